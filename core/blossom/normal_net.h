// SPDX-License-Identifier: LGPL-2.1-or-later
// The normal of a patch as a patch of its own.
//
// Its net bounds all normals exactly: normals inside a half-space mean no fold, normals of two
// patches in disjoint cones mean no closed loop between them. Cones of tangents are cheaper and
// wider.

#pragma once

#include "core/forms/function.h"
#include "core/math/roundoff.h"

namespace blossom {

/// The normal S_u x S_v, not of unit length.
///
///   N_kl = n m / (binom(2n-1, k) binom(2m-1, l)) sum_{i+i'=k, j+j'=l}
///            binom(n-1, i) binom(n, i') binom(m, j) binom(m-1, j') D_u P_ij x D_v P_i'j'
///
/// returns      bidegree (2n - 1, 2m - 1), square model units
/// throws       InvalidInput if a degree is not 1..kMaxDegree
/// accuracy     normal_net_error(n, m), relative to the square of the largest coordinate
/// cost         O(n^2 m^2)
///
/// Source: Sederberg and Meyers 1988 for its use; products as in Farouki and Rajan 1988.
BezierPatch normal_net(const BezierPatch& patch);

/// The same for a rational patch: w^3 times S_u x S_v, so of the same direction for positive w.
///
///   w (X_u x X_v) + w_v (X x X_u) - w_u (X x X_v)
///
/// returns      bidegree (3n - 1, 3m - 1)
/// throws       InvalidInput if a degree is not 1..20, since the net's would be above
///              kMaxProductDegree
/// accuracy     rational_normal_net_error(n, m), relative to the third power of the largest
///              coordinate or weight
BezierPatch normal_net(const RationalBezierPatch& patch);

/// Bounds on the error of a coordinate. A derivative is at most 2n times as large as the net and
/// has 2 roundings; a cross product doubles the size and has product_error and one more.
constexpr double normal_net_error(int degree_u, int degree_v) {
  const int product = degree_u * degree_v;
  return 8 * product * (product + 18) * kUnitRoundoff;
}

/// Three products of a derivative and a cross product, each with 2 roundings of a derivative, and
/// the sum of the three.
constexpr double rational_normal_net_error(int degree_u, int degree_v) {
  const int terms = (degree_u + 1) * (degree_v + 1);
  return 24 * degree_u * degree_v * (2 * terms + 35) * kUnitRoundoff;
}

}  // namespace blossom
