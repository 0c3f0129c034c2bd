// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/cgal/exact_check.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>
#include <CGAL/version_macros.h>

#include <algorithm>
#include <vector>

#include "core/blossom/detail/closed_form.h"

namespace blossom::cgal {
namespace {

using Exact = CGAL::Exact_rational;
using ExactPoint = Vec<Exact, 3>;

template <int Dim>
Vec<Exact, Dim> exact(const Vec<double, Dim>& point) {
  Vec<Exact, Dim> result;
  for (int i = 0; i < Dim; ++i) result[i] = Exact(point[i]);
  return result;
}

IntervalOf<Exact> exact(const Interval& interval) {
  return {Exact(interval.from), Exact(interval.to)};
}

MonomialCurveOf<ExactPoint> exact(const MonomialCurve& curve) {
  MonomialCurveOf<ExactPoint> result{{}, curve.centre, curve.scale};
  for (const Vec3& coefficient : curve.coefficients)
    result.coefficients.push_back(exact(coefficient));
  return result;
}

MonomialPatchOf<ExactPoint> exact(const MonomialPatch& patch) {
  MonomialPatchOf<ExactPoint> result{
      Grid<ExactPoint>(patch.coefficients.rows(), patch.coefficients.columns()), patch.centre_u,
      patch.centre_v, patch.scale_u, patch.scale_v};
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j)
      result.coefficients(i, j) = exact(patch.coefficients(i, j));
  return result;
}

std::array<Vec<Exact, 2>, 3> exact_local(const MonomialPatch& patch,
                                         const TriangleCorners& corners) {
  std::array<Vec<Exact, 2>, 3> result;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    result[k] = exact(corners[k]);
    result[k] -= exact(Vec2{patch.centre_u, patch.centre_v});
    result[k][0] /= Exact(patch.scale_u);
    result[k][1] /= Exact(patch.scale_v);
  }
  return result;
}

Vec3 rounded(const ExactPoint& point) {
  return {CGAL::to_double(point[0]), CGAL::to_double(point[1]), CGAL::to_double(point[2])};
}

double largest_gap(std::span<const Vec3> computed, std::span<const ExactPoint> expected) {
  Exact largest(0);
  for (std::size_t k = 0; k < expected.size(); ++k)
    for (int x = 0; x < 3; ++x) {
      const Exact difference = Exact(computed[k][x]) - expected[k][x];
      const Exact gap = CGAL::abs(difference);
      largest = std::max(largest, gap);
    }
  return CGAL::to_double(largest);
}

std::vector<ExactPoint> exact_points(const MonomialPatch& patch, const TriangleCorners& corners,
                                     int degree) {
  return detail::triangle_points(exact(patch).coefficients, exact_local(patch, corners), degree);
}

}  // namespace

// The core's functions are called first everywhere: they check the arguments.

BezierCurve exact_bezier_points(const MonomialCurve& curve, const Interval& interval) {
  BezierCurve result = bezier_points(curve, interval);
  const std::vector<ExactPoint> points = detail::bezier_line(exact(curve), exact(interval));
  std::transform(points.begin(), points.end(), result.points.begin(), rounded);
  return result;
}

BezierPatch exact_bezier_points(const MonomialPatch& patch, const Interval& u, const Interval& v) {
  BezierPatch result = bezier_points(patch, u, v);
  const Grid<ExactPoint> net = detail::bezier_net(exact(patch), exact(u), exact(v));
  std::transform(net.values().begin(), net.values().end(), result.points.values().begin(), rounded);
  return result;
}

BezierTriangle exact_bezier_points(const MonomialPatch& patch, const TriangleCorners& corners,
                                   int degree) {
  BezierTriangle result = bezier_points(patch, corners, degree);
  const std::vector<ExactPoint> points = exact_points(patch, corners, degree);
  std::transform(points.begin(), points.end(), result.points.begin(), rounded);
  return result;
}

ExactCheck check_bezier_points(const MonomialCurve& curve, const Interval& interval) {
  const BezierCurve computed = bezier_points(curve, interval);
  return {largest_gap(computed.points, detail::bezier_line(exact(curve), exact(interval))),
          blossom_error(curve.degree()) * blossom_scale(curve, interval)};
}

ExactCheck check_bezier_points(const MonomialPatch& patch, const Interval& u, const Interval& v) {
  const BezierPatch computed = bezier_points(patch, u, v);
  const Grid<ExactPoint> net = detail::bezier_net(exact(patch), exact(u), exact(v));
  return {largest_gap(computed.points.values(), net.values()),
          blossom_error(patch.degree_u() + patch.degree_v()) * blossom_scale(patch, u, v)};
}

ExactCheck check_bezier_points(const MonomialPatch& patch, const TriangleCorners& corners,
                               int degree) {
  const BezierTriangle computed = bezier_points(patch, corners, degree);
  return {largest_gap(computed.points, exact_points(patch, corners, degree)),
          triangle_blossom_error(degree, patch.degree_u(), patch.degree_v()) *
              triangle_scale(patch, corners, degree)};
}

const char* version() { return "CGAL " CGAL_STR(CGAL_VERSION); }

}  // namespace blossom::cgal
