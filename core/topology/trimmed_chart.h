// SPDX-License-Identifier: LGPL-2.1-or-later
// The trims of a face as `core/regions` takes them.

#pragma once

#include "core/regions/trimmed_chart.h"
#include "core/topology/face_trims.h"

namespace blossom {

/// In the surface's own parameters. The borders are the coedges, loop by loop.
TrimmedChart trimmed_chart(const FaceTrims& trims);

}  // namespace blossom
