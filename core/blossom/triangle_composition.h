// SPDX-License-Identifier: LGPL-2.1-or-later
// A patch over a curved triangle of its parameters, as a Bezier triangle in space.
//
// A triangle with curved sides in the parameter plane is a map G of low degree q from the standard
// triangle, homogeneous where a side is a rational curve. S(G(x, y)) of a patch of degrees n, m is
// a Bezier triangle of degree q (n + m): a piece of the patch up to a trimming curve, exactly. With
// q = 1 it is Theorem 3 of Vlachkova 2025, for which `core/subdivision/triangle_subdivision.h` is
// the short way.

#pragma once

#include "core/forms/curve.h"
#include "core/forms/patch.h"
#include "core/forms/triangle.h"
#include "core/math/roundoff.h"

namespace blossom {

/// S(G(x, y)), homogeneous, multiplied by w(x, y)^(n + m).
///
/// patch        (n + 1) x (m + 1) points, model units
/// map          points (wu, wv, w) in the parameters of the patch; a polynomial one has weights 1
/// returns      degree q (n + m); the weights are 1 to rounding if those of patch and map are 1
/// throws       InvalidInput if a degree of the patch is not 0..kMaxDegree, the number of points
///              does not fit the map's degree or the result's degree is above 2 kMaxDegree
/// accuracy     triangle_composition_error(n, m, q), relative to the largest coordinate of the net,
///              for a polynomial map with points in the unit square; weights above 1 count to the
///              power n + m
/// cost         O(q^4 n^2 m^2)
///
/// Source: DeRose 1988.
RationalBezierTriangle composition(const RationalBezierPatch& patch, const BezierTriangle& map);

/// The determinant of the map's derivatives by the three barycentric coordinates, of degree
/// 3 (q - 1). Where its coefficients are positive the map turns nothing over; its Jacobian is this
/// over q w^3, to a factor that is the same everywhere.
///
/// throws       InvalidInput if the degree is 0, above 2 kMaxDegree / 3, or does not fit the points
BezierTriangleOf<double> turning_form(const BezierTriangle& map);

/// The control points of a side, from one corner to the other; 0 is a, 1 is b, 2 is c.
template <class Point>
BezierCurveOf<Point> side_of(const BezierTriangleOf<Point>& triangle, int from, int to) {
  BezierCurveOf<Point> side;
  for (int k = 0; k <= triangle.degree; ++k) {
    const auto count = [&](int corner) {
      return corner == to ? k : corner == from ? triangle.degree - k : 0;
    };
    side.points.push_back(triangle(count(0), count(1)));
  }
  return side;
}

/// Puts control points in the place of a side's.
template <class Point>
void set_side(BezierTriangleOf<Point>& triangle, int from, int to,
              const BezierCurveOf<Point>& side) {
  for (int k = 0; k <= triangle.degree; ++k) {
    const auto count = [&](int corner) {
      return corner == to ? k : corner == from ? triangle.degree - k : 0;
    };
    triangle(count(0), count(1)) = side.points[static_cast<std::size_t>(k)];
  }
}

/// Bound on the error of a coordinate of a composition. Each of n + m factors has 6 roundings and,
/// in a product with at most (q + 1)(q + 2) / 2 terms, as many more; so has the product of both
/// directions; the sums over i and j n + m, weights and the last division 10.
constexpr double triangle_composition_error(int degree_u, int degree_v, int degree) {
  const auto terms = [](int d) { return (d + 1) * (d + 2) / 2; };
  const int least = degree_u < degree_v ? degree_u : degree_v;
  return ((degree_u + degree_v) * (terms(degree) + 7) + terms(least * degree) + 10) * kUnitRoundoff;
}

}  // namespace blossom
