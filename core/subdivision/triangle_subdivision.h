// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangular Bezier patches cut out of tensor-product and of triangular ones.
//
// The triangular blossom of degree N = n + m is the average of the tensor-product blossom over
// all ways to give n of the N points to u and the other m to v. Grouped by corners, that is one
// matrix for each direction and a sum with fixed weights:
//
//   q_{nu mu} = sum binom(nu, i) binom(mu, j) binom(lambda, k) / binom(N, n)
//               s(a_1^i b_1^j c_1^k; a_2^(nu - i) b_2^(mu - j) c_2^(lambda - k)),   i + j + k = n
//
// For a triangle inside the unit square no weight is negative, so the result is as accurate as
// the net and stays in its convex hull.

#pragma once

#include <algorithm>

#include "core/blossom/triangle_blossom.h"
#include "core/forms/patch.h"
#include "core/forms/triangle.h"
#include "core/math/roundoff.h"

namespace blossom {

/// The triangular Bezier patch of degree n + m of a patch over a triangle of its parameters.
///
/// corners      a, b, c; q_{N0} = S(a), q_{0N} = S(b), q_{00} = S(c). Clockwise, collinear and
///              equal corners are allowed
/// returns      (N + 1)(N + 2) / 2 points, model units
/// throws       InvalidInput if a corner is not finite or a degree is not 0..kMaxDegree
/// accuracy     sub_triangle_error(n, m) for corners in the unit square
/// cost         O(n^2 m^2)
///
/// Source: Vlachkova 2025, Theorem 3, in the Bernstein basis.
template <class Point>
BezierTriangleOf<Point> sub_triangle(const BezierPatchOf<Point>& patch,
                                     const TriangleCorners& corners);

/// The triangular Bezier patch of the same degree over a triangle inside another.
///
/// corners      barycentric (x, y) of a, b and c with respect to the given triangle
/// throws       InvalidInput if a corner is not finite, the degree is not 0..kMaxDegree, or the
///              number of points does not fit it
/// accuracy     inner_triangle_error(N) for corners in the triangle
/// cost         O(N^5)
///
/// Source: formula (12) of Vlachkova 2025, each value by de Casteljau's algorithm.
template <class Point>
BezierTriangleOf<Point> sub_triangle(const BezierTriangleOf<Point>& triangle,
                                     const TriangleCorners& corners);

/// Bound on the error of a coordinate, relative to the largest of the net. A weight of one
/// direction carries 5n + 3 roundings, its dot product n + 1, the last sum the number of its terms.
constexpr double sub_triangle_error(int degree_u, int degree_v) {
  const int least = std::min(degree_u, degree_v);
  const int terms = (least + 1) * (least + 2) / 2;
  return (6 * (degree_u + degree_v) + terms + 12) * kUnitRoundoff;
}

/// Likewise for a triangle cut out of a triangle: N levels of three products, with 1 - x - y.
constexpr double inner_triangle_error(int degree) { return (5 * degree + 1) * kUnitRoundoff; }

}  // namespace blossom
