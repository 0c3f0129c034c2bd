// SPDX-License-Identifier: LGPL-2.1-or-later
// A point of the intersection of two patches with one parameter given.

#pragma once

#include <optional>

#include "core/cells/points.h"
#include "core/forms/patch.h"

namespace blossom {

/// Solves A(u, v) = B(s, t) for three parameters, the fourth one fixed, by Newton's method.
///
/// start     the first guess; its entry `fixed` is kept
/// returns   the solution, to rounding; nothing if the steps do not settle or leave the box
///           blown up to twice its size
std::optional<Point4> newton(const RationalBezierPatch& a, const RationalBezierPatch& b,
                             const Point4& start, int fixed, const Box4& box);

}  // namespace blossom
