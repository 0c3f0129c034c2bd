// SPDX-License-Identifier: LGPL-2.1-or-later
// A point of the intersection of two patches with one parameter given.

#pragma once

#include <array>
#include <optional>

#include "core/cells/points.h"
#include "core/forms/evaluation.h"
#include "core/forms/patch.h"
#include "core/math/vec.h"

namespace blossom {

/// The derivatives of A(u, v) - B(s, t) by u, v, s and t.
using JacobianColumns = std::array<Vec3, 4>;

inline JacobianColumns jacobian_columns(const PatchJet& a, const PatchJet& b) {
  return {a.u, a.v, -b.u, -b.v};
}

/// Solves A(u, v) = B(s, t) for three parameters, the fourth one fixed, by Newton's method.
///
/// start     the first guess; its entry `fixed` is kept
/// returns   the solution, to rounding; nothing if the steps do not settle or leave the box
///           blown up to twice its size
std::optional<Point4> newton(const RationalBezierPatch& a, const RationalBezierPatch& b,
                             const Point4& start, int fixed, const Box4& box);

}  // namespace blossom
