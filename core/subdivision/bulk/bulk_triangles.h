// SPDX-License-Identifier: LGPL-2.1-or-later
// Many triangles cut out of one net at once.
//
// Layouts and promises as in `core/subdivision/bulk/bulk.h`; lanes are triangles. T4 works from
// either form and is as accurate as the net for triangles in the unit square; T1 works from
// re-centred coefficients, is accurate for small triangles, and takes fewer operations: O(N^3), not
// O(N^4).

#pragma once

#include <span>
#include <vector>

#include "core/subdivision/bulk/bulk_bounds.h"
#include "core/subdivision/bulk/bulk_matrices.h"
#include "core/subdivision/bulk/bulk_storage.h"
#include "core/subdivision/bulk/simd_level.h"
#include "core/subdivision/cell_nets.h"

namespace blossom {

/// What all triangles of one pair of degrees share: how often each value of the tensor-product
/// blossom counts in each control point (T4), and the inverse multinomials (T1). Made once, for
/// any number of calls.
///
/// Sizes: T4 keeps (n + 1)(n + 2)(m + 1)(m + 2) / 4 weights.
class TrianglePlan {
 public:
  /// throws       InvalidInput if a degree is not 0..kMaxDegree
  TrianglePlan(int degree_u, int degree_v);

  int degree_u() const { return degree_u_; }
  int degree_v() const { return degree_v_; }
  /// N = n + m.
  int degree() const { return degree_u_ + degree_v_; }
  /// Control points of a triangle, in the order of BezierTriangleOf::index.
  int points() const { return (degree() + 1) * (degree() + 2) / 2; }

  std::span<const double> weights() const { return weights_; }
  std::span<const int> targets() const { return targets_; }
  std::span<const double> inverses() const { return inverses_; }

 private:
  int degree_u_;
  int degree_v_;
  std::vector<double> weights_;
  std::vector<int> targets_;
  std::vector<double> inverses_;
};

/// Corners of triangles, six lists of the same length: a multiple of kLanes.
struct TriangleLists {
  std::span<const double> a_u, a_v, b_u, b_v, c_u, c_v;
};

/// Triangles by scheme T4:
///
///   q_{nu mu} = sum_{tau + sigma = (nu, mu, lambda)}
///                   binom(nu, i) binom(mu, j) binom(lambda, k) / binom(N, n) s(tau; sigma)
///
/// where s(tau; sigma) is the tensor-product blossom at i copies of a_1, j of b_1, k of c_1 and r,
/// s, t of a_2, b_2, c_2, with tau = (i, j, k), sigma = (r, s, t).
///
/// net          planes (n + 1)(m + 1) values in the given form, model units
/// out          receives a block for every kLanes triangles: planes plan.points() kLanes values,
///              point k of triangle l at k * kLanes + l
/// throws       InvalidInput if a size does not fit or a corner is not finite
/// accuracy     bulk_t4_error or bulk_t4_monomial_error
/// stack        up to 1.2 MB for degrees above 9, else 130 kB
///
/// Source: Vlachkova 2025, Theorem 3, by the average over tensor-product blossoms.
void subdivide_triangles(NetForm form, const TrianglePlan& plan, int planes,
                         std::span<const double> net, const TriangleLists& triangles,
                         std::span<double> out, SimdLevel level = best_simd_level());

/// Triangles by scheme T1: the polynomial at the corner c, its differences along the sides, two
/// difference tables.
///
/// coefficients planes (n + 1)(m + 1) re-centred coefficients
/// accuracy     bulk_t1_error times t1_growth
/// stack        up to 230 kB
///
/// Source: Vlachkova 2025, Theorem 3, with 1 + a E = (1 + c E) + A E, 1 + b E = (1 + c E) + B E.
void subdivide_triangles_by_differences(const TrianglePlan& plan, int planes,
                                        std::span<const double> coefficients,
                                        const TriangleLists& triangles, std::span<double> out,
                                        SimdLevel level = best_simd_level());

}  // namespace blossom
