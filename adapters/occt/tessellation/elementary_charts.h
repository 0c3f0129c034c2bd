// SPDX-License-Identifier: LGPL-2.1-or-later
// Elementary surfaces with their own parameters.

#pragma once

#include <optional>

#include <Geom_Surface.hxx>

#include "core/tessellation/charts/elementary_chart.h"

namespace blossom::occt {

/// The plane, cylinder, cone, sphere or torus that a surface is all or part of, with the same
/// parameters. Nothing for others.
std::optional<ElementaryChart> elementary_chart(const Handle(Geom_Surface) & surface);

}  // namespace blossom::occt
