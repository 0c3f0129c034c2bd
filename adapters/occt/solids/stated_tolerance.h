// SPDX-License-Identifier: LGPL-2.1-or-later
// The tolerance within which two solids are one where they meet, by what they state.

#pragma once

#include "adapters/occt/trim_tool.h"

namespace blossom::occt {

/// What lies nearer than this may be one: the sum of what a face of each solid states, the largest
/// of those that may meet.
///
///   T(face)       = max(point / 2, min(its tolerance, its shortest edge / 10))
///   T(solids)     = max(point, T(face of a) + T(face of b)) over faces whose boxes meet
///
/// Tolerances of no more than Open CASCADE's confusion, which all faces have, state nothing. A face
/// of which an edge would vanish within its tolerance cannot mean what it states. Edges and vertices
/// tell of themselves alone.
///
/// point    the least tolerance of points, model units
double stated_tolerance(const TrimTool& a, const TrimTool& b, double point);

}  // namespace blossom::occt
