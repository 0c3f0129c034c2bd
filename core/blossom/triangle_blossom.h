// SPDX-License-Identifier: LGPL-2.1-or-later
// The blossom of a polynomial surface over triangles, in closed form.
//
// A polynomial surface sum_ij a_ij u^i v^j, i = 0..n, j = 0..m, seen as a surface of total degree
// N, has one blossom in N points of the parameter plane. Its values at repeated corners of a
// triangle are the points of the triangular Bezier patch there. N may be any number that is at
// least the largest i + j with a_ij != 0; n + m always is.
//
// Index convention: q_{nu mu} takes nu copies of a, mu of b and N - nu - mu of c, as in formulas
// (12) and (14) of the source. Its Table 2 prints another order, that of the vertices (c, a, b).

#pragma once

#include <array>
#include <span>

#include "core/forms/patch.h"
#include "core/forms/triangle.h"
#include "core/math/roundoff.h"
#include "core/math/vec.h"

namespace blossom {

/// Corners of a triangle in the parameter plane.
using TriangleCorners = std::array<Vec2, 3>;

/// The blossom of total degree N at N points of the parameter plane.
///
///   t(x1..xN) = sum_ij a_ij tau_ij / (N! / (i! j! (N - i - j)!))
///
/// where tau_ij sums, over all ordered pairs of disjoint index sets A and B of i and j elements,
/// the product of the u coordinates in A and the v coordinates in B.
///
/// arguments    N points, any reals; N is their number
/// returns      a point, model units
/// throws       InvalidInput if an argument is not finite, a degree is not 0..kMaxDegree, N is
///              above 2 kMaxDegree, or N is below i + j of a coefficient that is not 0
/// accuracy     triangle_blossom_error(N, n, m) times the sum of the terms' absolute values
/// cost         O(N n m)
///
/// Source: Vlachkova 2025, formula (13).
template <class Point>
Point blossom_at(const MonomialPatchOf<Point>& patch, std::span<const Vec2> arguments);

/// The same of a Bezier triangle: each argument is a level of de Casteljau's algorithm.
///
/// arguments    N barycentric points (x, y) of the triangle, any reals
/// throws       InvalidInput if the number of arguments or of points does not fit the degree, an
///              argument is not finite, or the degree is not 0..2 kMaxDegree
/// accuracy     (5 N + 1) 2^-53 for arguments in the triangle, relative to the largest coordinate
/// cost         O(N^3)
///
/// Source: Ramshaw 1989.
template <class Point>
Point blossom_at(const BezierTriangleOf<Point>& triangle, std::span<const Vec2> arguments);

/// The Bezier points of the surface on a triangle.
///
///   q_{nu mu} = sum_ij a_ij / (N! / (i! j! (N - i - j)!)) sum over i_alpha, i_beta, j_alpha,
///   j_beta
///     binom(nu, i_alpha) binom(mu, i_beta) binom(lambda, i_gamma)
///     binom(nu - i_alpha, j_alpha) binom(mu - i_beta, j_beta) binom(lambda - i_gamma, j_gamma)
///     a_1^i_alpha b_1^i_beta c_1^i_gamma a_2^j_alpha b_2^j_beta c_2^j_gamma
///
/// corners      a, b, c; clockwise, collinear and equal corners are allowed
/// degree       N, at most kMaxDegree; n + m if it is not given
/// returns      (N + 1)(N + 2) / 2 points, model units; q_{N0} = S(a), q_{0N} = S(b), q_{00} = S(c)
/// throws       InvalidInput if a corner is not finite, N is above kMaxDegree, or N is below i + j
///              of a coefficient that is not 0
/// accuracy     triangle_blossom_error(N, n, m) times triangle_scale
/// cost         O(N^8); the readable reference. `core/subdivision/triangle_subdivision.h` is the
///              fast way, and it goes to degree 2 kMaxDegree
///
/// Source: Vlachkova 2025, Theorem 3, with the limits and index sets as corrected in
/// `core/papers/README.md`.
template <class Point>
BezierTriangleOf<Point> bezier_points(const MonomialPatchOf<Point>& patch,
                                      const TriangleCorners& corners, int degree);
template <class Point>
BezierTriangleOf<Point> bezier_points(const MonomialPatchOf<Point>& patch,
                                      const TriangleCorners& corners);

/// The same sums with absolute values throughout, the largest of all. Model units.
template <class Point>
double triangle_scale(const MonomialPatchOf<Point>& patch, const TriangleCorners& corners,
                      int degree);

/// Bound on the error of the closed form, relative to the sum of its terms' absolute values.
/// Powers and their products round N + 6 times, the four nested sums 2N, the outer sum n + m, and
/// a centre and a scale 2N.
constexpr double triangle_blossom_error(int degree, int degree_u, int degree_v) {
  return (5 * degree + degree_u + degree_v + 12) * kUnitRoundoff;
}

}  // namespace blossom
