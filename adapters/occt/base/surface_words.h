// SPDX-License-Identifier: LGPL-2.1-or-later
// The words that reports and listings use for kinds of surfaces.

#pragma once

#include <GeomAbs_SurfaceType.hxx>

namespace blossom::occt {

const char* surface_word(GeomAbs_SurfaceType type);

}  // namespace blossom::occt
