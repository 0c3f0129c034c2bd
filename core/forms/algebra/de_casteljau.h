// SPDX-License-Identifier: LGPL-2.1-or-later
// Points and derivatives of Bezier curves, patches and triangles by de Casteljau's algorithm.
//
// Slow next to `core/forms/evaluation.h`, but it takes numbers and points of two, three and four
// coordinates. Four are homogeneous and stay so: the results then are not projected.
//
// In [0, 1] a coordinate of a point has an error of at most de_casteljau_error, relative to the
// largest coordinate of the net. Parameters may be any real numbers.

#pragma once

#include "core/forms/curve.h"
#include "core/forms/patch.h"
#include "core/forms/triangle.h"
#include "core/math/roundoff.h"

namespace blossom {

/// A point of a curve with its first two derivatives by the curve's parameter, model units.
template <class Point>
struct CurveDerivatives {
  Point point;
  Point first;
  Point second;
};

/// A point of a patch with its first and second partial derivatives, model units.
template <class Point>
struct PatchDerivatives {
  Point point;
  Point u, v;
  Point uu, uv, vv;
};

/// C(t), S(u, v), T(x, y).
///
/// throws    InvalidInput if there is no point, a degree is above kMaxDegree (kMaxProductDegree for
///           a curve, twice kMaxDegree for a triangle), or the number of points does not fit the
///           degree
/// cost      O(n^2), O(n m (n + m)), O(N^3)
///
/// Source: de Casteljau 1985.
template <class Point>
Point point_at(const BezierCurveOf<Point>& curve, double t);
template <class Point>
Point point_at(const BezierPatchOf<Point>& patch, double u, double v);
template <class Point>
Point point_at(const BezierTriangleOf<Point>& triangle, double x, double y);

/// The same with derivatives: the last levels of the algorithm hold the differences,
///   C' = n (p_1 - p_0) of the level with two points, C'' = n (n - 1) (p_2 - 2 p_1 + p_0).
template <class Point>
CurveDerivatives<Point> derivatives_at(const BezierCurveOf<Point>& curve, double t);
template <class Point>
PatchDerivatives<Point> derivatives_at(const BezierPatchOf<Point>& patch, double u, double v);

/// Bound on the error of a coordinate of a point: 3 roundings in each of n levels; a patch has
/// n + m of them.
constexpr double de_casteljau_error(int levels) { return (3 * levels + 1) * kUnitRoundoff; }

}  // namespace blossom
