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
/// of which an edge would vanish within its tolerance cannot mean what it states. Edges and
/// vertices tell of themselves alone.
///
/// point    the least tolerance of points, model units
double stated_tolerance(const TrimTool& a, const TrimTool& b, double point);

/// The largest gap between an edge of one solid and one of the other that are one by what their
/// vertices state; 0 if no two are.
///
/// An edge runs along another one from end to end if it keeps within the lesser tolerance of its
/// two vertices, and no more than a tenth of its length, of it. Tolerances are those that are
/// stated, true or not: vertices that are given to be so large say what they are to be one with.
double gap_between_corners(const TrimTool& a, const TrimTool& b);

}  // namespace blossom::occt
