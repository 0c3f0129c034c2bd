// SPDX-License-Identifier: LGPL-2.1-or-later
// Bezier form to monomial form and back.
//
// The monomial form exists with its origin at the start of [0, 1], the plain power basis, and
// with its origin in the middle, x = 2t - 1 in [-1, 1]. A net of size 1 can have coefficients
// whose absolute values sum to 3^n at the start, but to only 2^n in the middle; random nets lose
// about as many digits as that says. So the middle is the default.
//
// Every function here is for points of two, three and four coordinates; four are homogeneous.

#pragma once

#include "core/forms/curve.h"
#include "core/forms/patch.h"
#include "core/forms/triangle.h"
#include "core/math/roundoff.h"

namespace blossom {

/// Where the monomial form has its origin.
enum class Origin {
  Start,   ///< centre 0, scale 1
  Middle,  ///< centre 1/2, scale 1/2
};

/// The coefficients of a Bezier curve. Differences are taken before averages (E shifts the index):
///
///   Start:   c_i = binom(n, i) Delta^i p_0
///   Middle:  c_i = binom(n, i) 2^-i ((1 + E) / 2)^(n - i) Delta^i p_0
///
/// returns   n + 1 coefficients, model units
/// throws    InvalidInput if there is no point or the degree is above kMaxDegree
/// accuracy  monomial_error(n, 0, origin)
/// cost      O(n^2) at the start, O(n^3) in the middle
template <class Point>
MonomialCurveOf<Point> monomial_form(const BezierCurveOf<Point>& curve,
                                     Origin origin = Origin::Middle);

/// The coefficients of a Bezier patch: the same along v, then along u.
///
/// returns   (n + 1) x (m + 1) coefficients, model units
/// throws    as above
/// accuracy  monomial_error(n, m, origin)
template <class Point>
MonomialPatchOf<Point> monomial_form(const BezierPatchOf<Point>& patch,
                                     Origin origin = Origin::Middle);

/// The coefficients of a Bezier triangle in its barycentric x (vertex a) and y (vertex b):
///
///   c_ij = N! / (i! j! (N - i - j)!) (E_a - 1)^i (E_b - 1)^j q_00
///
/// returns   (N + 1) x (N + 1) coefficients with centre 0 and scale 1; 0 where i + j > N
/// throws    InvalidInput if the number of points does not fit the degree, or the degree is not
///           0..kMaxDegree
template <class Point>
MonomialPatchOf<Point> monomial_form(const BezierTriangleOf<Point>& triangle);

/// The Bezier points on [0, 1] of a curve or patch with any centre and scale.
///
/// throws    InvalidInput if there is no coefficient, the degree is above kMaxDegree, a centre is
///           not finite, or a scale is 0 or not finite
/// accuracy  together with monomial_form: round_trip_error
///
/// Source: Vlachkova 2025, Theorems 1 and 2.
template <class Point>
BezierCurveOf<Point> bezier_form(const MonomialCurveOf<Point>& curve);
template <class Point>
BezierPatchOf<Point> bezier_form(const MonomialPatchOf<Point>& patch);

/// Largest sum of absolute coefficients that a net of size 1 can have.
constexpr double monomial_growth(int degree_u, int degree_v, Origin origin) {
  double growth = 1;
  for (int i = 0; i < degree_u + degree_v; ++i) growth *= origin == Origin::Start ? 3 : 2;
  return growth;
}

/// Bound on the sum of the absolute errors of one coordinate's coefficients, relative to the
/// largest absolute coordinate of the net. Each direction rounds n + 1 times. Degree 0 in v
/// stands for a curve.
constexpr double monomial_error(int degree_u, int degree_v, Origin origin) {
  return (degree_u + degree_v + 3) * monomial_growth(degree_u, degree_v, origin) * kUnitRoundoff;
}

/// Bound on the error of a coordinate after monomial_form and bezier_form, relative to the
/// largest of the net. To first order the way back rounds 3n + 4 times in each direction.
constexpr double round_trip_error(int degree_u, int degree_v, Origin origin) {
  return (4 * (degree_u + degree_v) + 12) * monomial_growth(degree_u, degree_v, origin) *
         kUnitRoundoff;
}

/// The same patch with weights of 1.
RationalBezierPatch homogeneous(const BezierPatch& patch);

}  // namespace blossom
