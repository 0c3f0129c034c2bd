// SPDX-License-Identifier: LGPL-2.1-or-later
// Random curves, patches and triangles, and slow, obvious ways to evaluate them.

#pragma once

#include <algorithm>
#include <vector>

#include "core/forms/curve.h"
#include "core/forms/patch.h"
#include "core/forms/triangle.h"
#include "tests/support/random.h"

namespace blossom::testing {

/// Coordinates in [-1, 1), so that errors relative to the largest coordinate are absolute ones.
template <class Point = Vec3>
Point random_point(Random& random) {
  Point point;
  for (int i = 0; i < Point::kDimension; ++i) point[i] = uniform(random, -1, 1);
  return point;
}

template <class Point = Vec3>
BezierCurveOf<Point> random_curve(Random& random, int degree) {
  BezierCurveOf<Point> curve;
  for (int i = 0; i <= degree; ++i) curve.points.push_back(random_point<Point>(random));
  return curve;
}

template <class Point = Vec3>
MonomialCurveOf<Point> random_monomial_curve(Random& random, int degree) {
  return {random_curve<Point>(random, degree).points};
}

template <class Point = Vec3>
BezierPatchOf<Point> random_patch(Random& random, int degree_u, int degree_v) {
  BezierPatchOf<Point> patch{Grid<Point>(degree_u + 1, degree_v + 1)};
  for (Point& point : patch.points.values()) point = random_point<Point>(random);
  return patch;
}

template <class Point = Vec3>
MonomialPatchOf<Point> random_monomial_patch(Random& random, int degree_u, int degree_v) {
  return {random_patch<Point>(random, degree_u, degree_v).points};
}

inline BezierTriangle random_triangle(Random& random, int degree) {
  BezierTriangle triangle;
  triangle.degree = degree;
  for (std::size_t k = 0; k < BezierTriangle::count(degree); ++k)
    triangle.points.push_back(random_point(random));
  return triangle;
}

/// Largest difference of a coordinate.
template <class Point>
double coordinate_gap(const Point& a, const Point& b) {
  return max_norm(a - b);
}

template <class Point>
double largest_coordinate(const std::vector<Point>& points) {
  double largest = 0;
  for (const Point& point : points) largest = std::max(largest, max_norm(point));
  return largest;
}

inline double lerp(double a, double b, double t) { return (1 - t) * a + t * b; }

/// de Casteljau in long double.
template <class Point>
Point reference_point(const BezierCurveOf<Point>& curve, double t) {
  Point result;
  for (int x = 0; x < Point::kDimension; ++x) {
    std::vector<long double> level;
    for (const Point& point : curve.points) level.push_back(point[x]);
    for (; level.size() > 1; level.pop_back())
      for (std::size_t k = 0; k + 1 < level.size(); ++k)
        level[k] = (1 - static_cast<long double>(t)) * level[k] + t * level[k + 1];
    result[x] = static_cast<double>(level[0]);
  }
  return result;
}

template <class Point>
Point reference_point(const BezierPatchOf<Point>& patch, double u, double v) {
  BezierCurveOf<Point> column;
  for (int i = 0; i <= patch.degree_u(); ++i) {
    BezierCurveOf<Point> row;
    for (int j = 0; j <= patch.degree_v(); ++j) row.points.push_back(patch.points(i, j));
    column.points.push_back(reference_point(row, v));
  }
  return reference_point(column, u);
}

/// Horner in long double.
template <class Point>
Point reference_point(const MonomialCurveOf<Point>& curve, double t) {
  const long double s = (static_cast<long double>(t) - curve.centre) / curve.scale;
  Point result;
  for (int x = 0; x < Point::kDimension; ++x) {
    long double value = 0;
    for (int i = curve.degree(); i >= 0; --i)
      value = value * s + curve.coefficients[static_cast<std::size_t>(i)][x];
    result[x] = static_cast<double>(value);
  }
  return result;
}

template <class Point>
Point reference_point(const MonomialPatchOf<Point>& patch, double u, double v) {
  MonomialCurveOf<Point> column{{}, patch.centre_u, patch.scale_u};
  for (int i = 0; i <= patch.degree_u(); ++i) {
    MonomialCurveOf<Point> row{{}, patch.centre_v, patch.scale_v};
    for (int j = 0; j <= patch.degree_v(); ++j)
      row.coefficients.push_back(patch.coefficients(i, j));
    column.coefficients.push_back(reference_point(row, v));
  }
  return reference_point(column, u);
}

}  // namespace blossom::testing
