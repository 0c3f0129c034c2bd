// SPDX-License-Identifier: LGPL-2.1-or-later
// Higher and lower degrees.
//
// A form has every degree above its own, exactly. Below, there is a nearest one, and a bound on
// the distance.

#pragma once

#include "core/forms/function.h"
#include "core/forms/triangle.h"
#include "core/math/grid.h"
#include "core/math/roundoff.h"

namespace blossom {

/// The same curve, patch or triangle with a higher degree.
///
///   p'_k = sum_i binom(n, i) binom(r, k - i) / binom(n + r, k) p_i,   r = degree - n
///
/// degree       n..kMaxProductDegree
/// returns      degree + 1 points, model units
/// throws       InvalidInput if a degree is below the form's or out of range, or the form has no
///              points or, for a triangle, not as many as its degree wants
/// accuracy     relative to the largest coordinate: elevation_error(degree), for a patch the sum of
///              those of both degrees, for a triangle triangle_elevation_error
///
/// Source: Farin 2002.
template <class Point>
BezierCurveOf<Point> elevated(const BezierCurveOf<Point>& curve, int degree);
template <class Point>
BezierPatchOf<Point> elevated(const BezierPatchOf<Point>& patch, int degree_u, int degree_v);
template <class Point>
BezierTriangleOf<Point> elevated(const BezierTriangleOf<Point>& triangle, int degree);

/// A form of lower degree and how far it is from the given one.
template <class Form>
struct ReducedOf {
  Form form;
  double error = 0;  ///< bound on the distance at equal parameters, model units
};

/// The curve of a lower degree whose elevated control points are nearest to the given ones in the
/// mean square, among those with the same ends. Where the ends are given up (degree 0) that is the
/// nearest curve in the mean square, too; otherwise it need not be.
///
/// degree       0..n; with 0 the ends are given up
/// returns      the curve, and the largest distance of its control points, elevated, from the
///              given ones: a bound on the distance, by the convex hull, rounding included. Of
///              four coordinates: the distance of the homogeneous points
/// throws       InvalidInput if the degree is above the curve's or out of range, or the curve's is
///              not 0..kMaxProductDegree
/// cost         O(n^3)
///
/// Source: Lutterkort, Peters, Reif 1999; conditions on ends as in linear least squares.
template <class Point>
ReducedOf<BezierCurveOf<Point>> reduced(const BezierCurveOf<Point>& curve, int degree);

/// The same along u, then along v. The borders of the result are the borders reduced.
template <class Point>
ReducedOf<BezierPatchOf<Point>> reduced(const BezierPatchOf<Point>& patch, int degree_u,
                                        int degree_v);

/// The triangle of a lower degree whose borders are the borders reduced, and whose elevated points
/// are the nearest then to the given ones in the mean square. Triangles that share a side still
/// share it, to rounding.
///
/// degree       0..N; with 0 the corners are given up
/// throws       InvalidInput if the degree is above the triangle's, or that is above
///              kMaxProductDegree or does not fit the number of points
/// cost         O(N^6)
template <class Point>
ReducedOf<BezierTriangleOf<Point>> reduced(const BezierTriangleOf<Point>& triangle, int degree);

/// The same for many triangles of one degree, with the matrix made once.
class TriangleReduction {
 public:
  /// from, to   degrees
  /// throws     InvalidInput as `reduced`
  /// cost       O(from^6)
  TriangleReduction(int from, int to);

  /// throws     InvalidInput if the triangle is not of degree `from`
  /// cost       O(from^4)
  template <class Point>
  ReducedOf<BezierTriangleOf<Point>> operator()(const BezierTriangleOf<Point>& triangle) const;

 private:
  int from_;
  int to_;
  Grid<double> matrix_;
};

/// Bound on the error of a coordinate of an elevated form of this degree, relative to the largest:
/// a sum of at most degree / 2 + 1 terms, and 13 roundings of the binomials and products.
constexpr double elevation_error(int degree) { return (0.5 * degree + 14) * kUnitRoundoff; }

/// Likewise of a triangle: a product, two sums and a division (as a product) for each degree.
constexpr double triangle_elevation_error(int from, int to) {
  return 5 * (to - from) * kUnitRoundoff;
}

}  // namespace blossom
