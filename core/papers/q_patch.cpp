// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/papers/q_patch.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/blossom/detail/checks.h"
#include "core/papers/detail/q_checks.h"
#include "core/papers/detail/q_conversion.h"
#include "core/papers/detail/q_errors.h"
#include "core/papers/detail/q_lines.h"
#include "core/papers/detail/q_subdivision.h"

namespace blossom {
namespace {

template <class Point>
void check(const char* function, const QBezierPatchOf<Point>& patch) {
  detail::check_basis(function, patch.degree_u(), patch.u, patch.q);
  detail::check_basis(function, patch.degree_v(), patch.v, patch.r);
  detail::check_points(function, patch.points.values());
}

template <class Point>
void check_monomial(const char* function, const MonomialPatchOf<Point>& patch,
                    const QParametersOf<ScalarOf<Point>>& q,
                    const QParametersOf<ScalarOf<Point>>& r) {
  detail::check_blossom(function, patch.degree_u(), q);
  detail::check_blossom(function, patch.degree_v(), r);
  detail::check_points(function, patch.coefficients.values());
  detail::check_placement(function, patch.centre_u, patch.scale_u);
  detail::check_placement(function, patch.centre_v, patch.scale_v);
  detail::check_divisors(function, patch.degree_u(), q);
  detail::check_divisors(function, patch.degree_v(), r);
}

template <class Point>
void check_place(const char* function, const QBezierPatchOf<Point>& patch, const ScalarOf<Point>& u,
                 const ScalarOf<Point>& v, std::span<const int> permutation_u,
                 std::span<const int> permutation_v) {
  check(function, patch);
  detail::check_finite(function, "u", u);
  detail::check_finite(function, "v", v);
  detail::check_permutation(function, patch.degree_u(), permutation_u);
  detail::check_permutation(function, patch.degree_v(), permutation_v);
}

}  // namespace

template <class Point>
Point q_blossom_at(const MonomialPatchOf<Point>& patch, const QParametersOf<ScalarOf<Point>>& q,
                   const QParametersOf<ScalarOf<Point>>& r, std::span<const PairOf<Point>> along_u,
                   std::span<const PairOf<Point>> along_v) {
  check_monomial("q_blossom_at", patch, q, r);
  detail::check_arguments("q_blossom_at", patch.degree_u(), along_u);
  detail::check_arguments("q_blossom_at", patch.degree_v(), along_v);
  const MonomialCurveOf<Point> column{
      detail::fold_rows(patch.coefficients,
                        [&](const std::vector<Point>& row) {
                          return q_blossom_at(
                              MonomialCurveOf<Point>{row, patch.centre_v, patch.scale_v}, r,
                              along_v);
                        }),
      patch.centre_u, patch.scale_u};
  return q_blossom_at(column, q, along_u);
}

template <class Point>
Point point_at(const QBezierPatchOf<Point>& patch, const ScalarOf<Point>& u,
               const ScalarOf<Point>& v, std::span<const int> permutation_u,
               std::span<const int> permutation_v) {
  check_place("point_at", patch, u, v, permutation_u, permutation_v);
  const std::vector<Point> column =
      detail::fold_rows(patch.points, [&](const std::vector<Point>& row) {
        return detail::evaluation_levels(row, patch.v, patch.r, v, permutation_v).back()[0];
      });
  return detail::evaluation_levels(column, patch.u, patch.q, u, permutation_u).back()[0];
}

template <class Point>
Point point_at(const QBezierPatchOf<Point>& patch, const ScalarOf<Point>& u,
               const ScalarOf<Point>& v) {
  check("point_at", patch);
  return point_at(patch, u, v, identity_permutation(patch.degree_u()),
                  identity_permutation(patch.degree_v()));
}

template <class Point>
double q_evaluation_error(const QBezierPatchOf<Point>& patch, double u, double v,
                          std::span<const int> permutation_u, std::span<const int> permutation_v) {
  check_place("q_evaluation_error", patch, u, v, permutation_u, permutation_v);
  std::vector<Point> column;
  std::vector<double> errors;
  for (int i = 0; i < patch.points.rows(); ++i) {
    const std::vector<Point> row = detail::row(patch.points, i);
    column.push_back(detail::evaluation_levels(row, patch.v, patch.r, v, permutation_v).back()[0]);
    errors.push_back(q_evaluation_error(row, patch.v, patch.r, v, permutation_v));
  }
  return detail::evaluation_errors(column, errors, patch.u, patch.q, u, permutation_u).back()[0];
}

template <class Point>
QBezierPatchOf<Point> q_bezier_form(const MonomialPatchOf<Point>& patch,
                                    const IntervalOf<ScalarOf<Point>>& u,
                                    const IntervalOf<ScalarOf<Point>>& v,
                                    const QParametersOf<ScalarOf<Point>>& q,
                                    const QParametersOf<ScalarOf<Point>>& r) {
  check_monomial("q_bezier_form", patch, q, r);
  const auto half = detail::along_v(patch.coefficients, [&](const std::vector<Point>& row) {
    return q_control_points(MonomialCurveOf<Point>{row, patch.centre_v, patch.scale_v}, v, r);
  });
  return {detail::along_u(half,
                          [&](const std::vector<Point>& column) {
                            return q_control_points(
                                MonomialCurveOf<Point>{column, patch.centre_u, patch.scale_u}, u,
                                q);
                          }),
          u, v, q, r};
}

template <class Point>
QBezierPatchOf<Point> q_bezier_form(const BezierPatchOf<Point>& patch,
                                    const IntervalOf<ScalarOf<Point>>& u,
                                    const IntervalOf<ScalarOf<Point>>& v,
                                    const QParametersOf<ScalarOf<Point>>& q,
                                    const QParametersOf<ScalarOf<Point>>& r) {
  detail::check_basis("q_bezier_form", patch.degree_u(), u, q);
  detail::check_basis("q_bezier_form", patch.degree_v(), v, r);
  detail::check_points("q_bezier_form", patch.points.values());
  const auto matrix_u = detail::conversion_matrix(patch.degree_u(), u, q);
  const auto matrix_v = detail::conversion_matrix(patch.degree_v(), v, r);
  const auto half = detail::along_v(
      patch.points, [&](const std::vector<Point>& row) { return detail::solution(matrix_v, row); });
  return {detail::along_u(
              half,
              [&](const std::vector<Point>& column) { return detail::solution(matrix_u, column); }),
          u, v, q, r};
}

template <class Point>
MonomialPatchOf<Point> monomial_form(const QBezierPatchOf<Point>& patch) {
  check("monomial_form", patch);
  const auto half = detail::along_v(patch.points, [&](const std::vector<Point>& row) {
    return detail::monomial_coefficients(row, patch.v, patch.r);
  });
  return {detail::along_u(half, [&](const std::vector<Point>& column) {
    return detail::monomial_coefficients(column, patch.u, patch.q);
  })};
}

template <class Point>
BezierPatchOf<Point> bezier_form(const QBezierPatchOf<Point>& patch) {
  check("bezier_form", patch);
  return {product_transposed(
      product(detail::conversion_matrix(patch.degree_u(), patch.u, patch.q), patch.points),
      detail::conversion_matrix(patch.degree_v(), patch.v, patch.r))};
}

template <class Point>
double bezier_form_error(const QBezierPatchOf<Point>& patch) {
  check("bezier_form_error", patch);
  Grid<Point> sizes = patch.points;
  for (Point& point : sizes.values()) point = detail::absolute(point);
  const Grid<Point> net = product_transposed(
      product(detail::conversion_sizes(patch.degree_u(), patch.u, patch.q), sizes),
      detail::conversion_sizes(patch.degree_v(), patch.v, patch.r));
  double largest = 0;
  for (const Point& point : net.values()) largest = std::max(largest, max_norm(point));
  return (q_conversion_error(patch.degree_u()) + q_conversion_error(patch.degree_v())) * largest;
}

template <class Point>
Grid<QBezierPatchOf<Point>> subdivide(const QBezierPatchOf<Point>& patch, const ScalarOf<Point>& s,
                                      const ScalarOf<Point>& t) {
  using Piece = IntervalOf<ScalarOf<Point>>;
  check("subdivide", patch);
  detail::check_finite("subdivide", "the cut in u", s);
  detail::check_finite("subdivide", "the cut in v", t);
  const std::array<Piece, 2> u{Piece{patch.u.from, s}, Piece{s, patch.u.to}};
  const std::array<Piece, 2> v{Piece{patch.v.from, t}, Piece{t, patch.v.to}};
  for (const Piece& piece : u) detail::check_basis("subdivide", patch.degree_u(), piece, patch.q);
  for (const Piece& piece : v) detail::check_basis("subdivide", patch.degree_v(), piece, patch.r);
  Grid<QBezierPatchOf<Point>> quadrants(2, 2);
  for (int i = 0; i < 2; ++i) {
    const auto half = detail::along_u(patch.points, [&](const std::vector<Point>& line) {
      const auto cut = detail::cut_points(line, patch.u, patch.q, s);
      return i == 0 ? cut.left : cut.right;
    });
    for (int j = 0; j < 2; ++j)
      quadrants(i, j) = {detail::along_v(half,
                                         [&](const std::vector<Point>& line) {
                                           const auto cut =
                                               detail::cut_points(line, patch.v, patch.r, t);
                                           return j == 0 ? cut.left : cut.right;
                                         }),
                         u[detail::index(i)], v[detail::index(j)], patch.q, patch.r};
  }
  return quadrants;
}

using Rational = boost::multiprecision::cpp_rational;
using ExactPoint2 = Vec<Rational, 2>;
using ExactPoint3 = Vec<Rational, 3>;
using ExactPoint4 = Vec<Rational, 4>;

#define BLOSSOM_INSTANTIATE(Point)                                                             \
  template Point q_blossom_at(const MonomialPatchOf<Point>&,                                   \
                              const QParametersOf<ScalarOf<Point>>&,                           \
                              const QParametersOf<ScalarOf<Point>>&,                           \
                              std::span<const PairOf<Point>>, std::span<const PairOf<Point>>); \
  template Point point_at(const QBezierPatchOf<Point>&, const ScalarOf<Point>&,                \
                          const ScalarOf<Point>&, std::span<const int>, std::span<const int>); \
  template Point point_at(const QBezierPatchOf<Point>&, const ScalarOf<Point>&,                \
                          const ScalarOf<Point>&);                                             \
  template QBezierPatchOf<Point> q_bezier_form(                                                \
      const MonomialPatchOf<Point>&, const IntervalOf<ScalarOf<Point>>&,                       \
      const IntervalOf<ScalarOf<Point>>&, const QParametersOf<ScalarOf<Point>>&,               \
      const QParametersOf<ScalarOf<Point>>&);                                                  \
  template QBezierPatchOf<Point> q_bezier_form(                                                \
      const BezierPatchOf<Point>&, const IntervalOf<ScalarOf<Point>>&,                         \
      const IntervalOf<ScalarOf<Point>>&, const QParametersOf<ScalarOf<Point>>&,               \
      const QParametersOf<ScalarOf<Point>>&);                                                  \
  template MonomialPatchOf<Point> monomial_form(const QBezierPatchOf<Point>&);                 \
  template BezierPatchOf<Point> bezier_form(const QBezierPatchOf<Point>&);                     \
  template Grid<QBezierPatchOf<Point>> subdivide(const QBezierPatchOf<Point>&,                 \
                                                 const ScalarOf<Point>&, const ScalarOf<Point>&);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
BLOSSOM_INSTANTIATE(ExactPoint2)
BLOSSOM_INSTANTIATE(ExactPoint3)
BLOSSOM_INSTANTIATE(ExactPoint4)
#undef BLOSSOM_INSTANTIATE

#define BLOSSOM_INSTANTIATE(Point)                                                 \
  template double q_evaluation_error(const QBezierPatchOf<Point>&, double, double, \
                                     std::span<const int>, std::span<const int>);  \
  template double bezier_form_error(const QBezierPatchOf<Point>&);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
