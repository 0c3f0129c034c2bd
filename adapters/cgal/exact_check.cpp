// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/cgal/exact_check.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>
#include <CGAL/version_macros.h>

#include <algorithm>
#include <vector>

#include "core/blossom/detail/closed_form.h"
#include "core/blossom/detail/composition.h"
#include "core/blossom/detail/normal_net.h"
#include "core/forms/algebra/detail/sign.h"

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

template <int Dim>
Grid<Vec<Exact, Dim>> exact(const Grid<Vec<double, Dim>>& net) {
  Grid<Vec<Exact, Dim>> result(net.rows(), net.columns());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) result(i, j) = exact(net(i, j));
  return result;
}

MonomialPatchOf<ExactPoint> exact(const MonomialPatch& patch) {
  return {exact(patch.coefficients), patch.centre_u, patch.centre_v, patch.scale_u, patch.scale_v};
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

template <int Dim>
double largest_gap(std::span<const Vec<double, Dim>> computed,
                   std::span<const Vec<Exact, Dim>> expected) {
  Exact largest(0);
  for (std::size_t k = 0; k < expected.size(); ++k)
    for (int x = 0; x < Dim; ++x) {
      const Exact difference = Exact(computed[k][x]) - expected[k][x];
      const Exact gap = CGAL::abs(difference);
      largest = std::max(largest, gap);
    }
  return CGAL::to_double(largest);
}

template <int Dim>
double largest_coordinate(std::span<const Vec<double, Dim>> points) {
  double largest = 0;
  for (const Vec<double, Dim>& point : points) largest = std::max(largest, max_norm(point));
  return largest;
}

std::vector<ExactPoint> exact_points(const MonomialPatch& patch, const TriangleCorners& corners,
                                     int degree) {
  return detail::triangle_points(exact(patch).coefficients, exact_local(patch, corners), degree);
}

int sign_of(const Exact& value) { return static_cast<int>(CGAL::sign(value)); }

// The sign of b^n.
int sign_of_power(double b, int n) { return b < 0 && n % 2 != 0 ? -1 : 1; }

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
  return {largest_gap<3>(computed.points, detail::bezier_line(exact(curve), exact(interval))),
          blossom_error(curve.degree()) * blossom_scale(curve, interval)};
}

ExactCheck check_bezier_points(const MonomialPatch& patch, const Interval& u, const Interval& v) {
  const BezierPatch computed = bezier_points(patch, u, v);
  const Grid<ExactPoint> net = detail::bezier_net(exact(patch), exact(u), exact(v));
  return {largest_gap<3>(computed.points.values(), net.values()),
          blossom_error(patch.degree_u() + patch.degree_v()) * blossom_scale(patch, u, v)};
}

ExactCheck check_bezier_points(const MonomialPatch& patch, const TriangleCorners& corners,
                               int degree) {
  const BezierTriangle computed = bezier_points(patch, corners, degree);
  return {largest_gap<3>(computed.points, exact_points(patch, corners, degree)),
          triangle_blossom_error(degree, patch.degree_u(), patch.degree_v()) *
              triangle_scale(patch, corners, degree)};
}

ExactCheck check_composition(const RationalBezierPatch& patch, const BezierCurve2& curve) {
  const RationalBezierCurve computed = composition(patch, curve);
  std::vector<Vec<Exact, 2>> parameters;
  for (const Vec2& uv : curve.points) parameters.push_back(exact(uv));
  const auto expected =
      detail::composition(exact(patch.points), detail::parameter_forms(parameters));
  const int n = patch.degree_u(), m = patch.degree_v();
  return {largest_gap<4>(computed.points, expected),
          composition_error(n, m, curve.degree()) * composition_growth(n, m, curve) *
              largest_coordinate<4>(patch.points.values())};
}

ExactCheck check_normal_net(const BezierPatch& patch) {
  const BezierPatch computed = normal_net(patch);
  const auto expected = detail::normal_net(exact(patch.points));
  const double size = largest_coordinate<3>(patch.points.values());
  return {largest_gap<3>(computed.points.values(), expected.values()),
          normal_net_error(patch.degree_u(), patch.degree_v()) * size * size};
}

ExactCheck check_normal_net(const RationalBezierPatch& patch) {
  const BezierPatch computed = normal_net(patch);
  const auto expected = detail::normal_net(exact(patch.points));
  const double size = largest_coordinate<4>(patch.points.values());
  return {largest_gap<3>(computed.points.values(), expected.values()),
          rational_normal_net_error(patch.degree_u(), patch.degree_v()) * size * size * size};
}

int exact_sign_at(const BezierFunction& f, const Ratio& t) {
  sign_at(f, t);
  const Exact value =
      detail::homogeneous_value(std::vector<Exact>(f.points.begin(), f.points.end()),
                                Exact(t.numerator), Exact(t.denominator));
  return sign_of(value) * sign_of_power(t.denominator, f.degree());
}

int exact_sign_at(const BezierFunction2& f, const Ratio& u, const Ratio& v) {
  sign_at(f, u, v);
  Grid<Exact> net(f.points.rows(), f.points.columns());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) net(i, j) = Exact(f.points(i, j));
  const Exact value = detail::homogeneous_value(net, Exact(u.numerator), Exact(u.denominator),
                                                Exact(v.numerator), Exact(v.denominator));
  return sign_of(value) * sign_of_power(u.denominator, f.degree_u()) *
         sign_of_power(v.denominator, f.degree_v());
}

const char* version() { return "CGAL " CGAL_STR(CGAL_VERSION); }

}  // namespace blossom::cgal
