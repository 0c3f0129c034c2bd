// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/bulk/bulk_bounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace blossom {
namespace {

double power(double base, int exponent) {
  double result = 1;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

double growth(int degree, double reach) { return power(std::max(1.0, reach), degree); }

double pyramid_error(int degree_u, int degree_v, const NetSizes& sizes, double reach_u,
                     double reach_v) {
  return (bulk_pyramid_error(degree_u, degree_v) * sizes.sum + sizes.conversion) *
         growth(degree_u, reach_u) * growth(degree_v, reach_v);
}

double middle(double t) { return 2 * t - 1; }

// Sums of |1 - t| + |t| over the worst corner, one parameter.
double corners_growth(int degree, const std::array<Vec2, 3>& corners, int parameter) {
  double worst = 1;
  for (const Vec2& corner : corners) worst = std::max(worst, bezier_norm(corner[parameter]));
  return power(worst, degree);
}

}  // namespace

double pyramid_growth(int degree, const Interval& piece) {
  return growth(degree, pyramid_reach(piece));
}

double t1_growth(int degree_u, int degree_v, const std::array<Vec2, 3>& corners) {
  const Vec2& c = corners[2];
  Vec2 a = 2 * (corners[0] - c), b = 2 * (corners[1] - c);
  Vec2 start{std::abs(middle(c[0])), std::abs(middle(c[1]))};
  bool turned = false;
  if (max_norm(a) < max_norm(b)) std::swap(a, b);
  if (std::abs(a[0]) < std::abs(a[1])) {
    turned = true;
    std::swap(a[0], a[1]);
    std::swap(b[0], b[1]);
    std::swap(start[0], start[1]);
  }
  const double rho = a[0] == 0 ? 0 : std::abs(b[0] / a[0]);
  // |delta| <= |b_2| + |rho a_2|, and the path goes along rho A before delta.
  const double first = start[0] + std::abs(a[0]);
  const double second =
      start[1] + std::max(std::abs(a[1]), std::abs(b[1]) + 2 * rho * std::abs(a[1]));
  const double growth_u = turned ? second : first, growth_v = turned ? first : second;
  return power(std::max(1.0, growth_u), degree_u) * power(std::max(1.0, growth_v), degree_v);
}

double piece_error(PiecePath path, int degree_u, int degree_v, const NetSizes& sizes,
                   const Interval& u, const Interval& v) {
  if (path == PiecePath::BezierMatrices)
    return bulk_bezier_error(degree_u, degree_v) * sizes.largest * bezier_growth(degree_u, u) *
           bezier_growth(degree_v, v);
  return pyramid_error(degree_u, degree_v, sizes, pyramid_reach(u), pyramid_reach(v));
}

double triangle_error(TrianglePath path, int degree_u, int degree_v, const NetSizes& sizes,
                      const std::array<Vec2, 3>& corners) {
  if (path == TrianglePath::BezierT4)
    return bulk_t4_error(degree_u, degree_v) * sizes.largest *
           corners_growth(degree_u, corners, 0) * corners_growth(degree_v, corners, 1);
  return (bulk_t1_error(degree_u, degree_v) * sizes.sum + sizes.conversion) *
         t1_growth(degree_u, degree_v, corners);
}

PiecePath piece_path(int degree_u, int degree_v, const NetSizes& sizes, const Interval& u,
                     const Interval& v, double tolerance) {
  return piece_path(degree_u, degree_v, sizes, pyramid_reach(u), pyramid_reach(v), tolerance);
}

PiecePath piece_path(int degree_u, int degree_v, const NetSizes& sizes, double reach_u,
                     double reach_v, double tolerance) {
  return pyramid_error(degree_u, degree_v, sizes, reach_u, reach_v) <= tolerance
             ? PiecePath::MonomialPyramid
             : PiecePath::BezierMatrices;
}

TrianglePath triangle_path(int degree_u, int degree_v, const NetSizes& sizes,
                           const std::array<Vec2, 3>& corners, double tolerance) {
  const TrianglePath fast = TrianglePath::MonomialT1;
  return triangle_error(fast, degree_u, degree_v, sizes, corners) <= tolerance
             ? fast
             : TrianglePath::BezierT4;
}

}  // namespace blossom
