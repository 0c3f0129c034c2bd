// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves along which the faces of two solids touch.

#pragma once

#include <TopoDS_Face.hxx>

#include "core/results/result.h"

namespace blossom::occt {

/// Whether surfaces that touch along a curve stay on one side of each other, as far as points
/// beside it tell.
///
/// curve       a tangential one of the intersection of a and b
/// tolerance   model units
bool only_touch(const IntersectionCurve& curve, const TopoDS_Face& a, const TopoDS_Face& b,
                double tolerance);

}  // namespace blossom::occt
