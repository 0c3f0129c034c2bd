// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/patch_blossom.h"

#include <algorithm>
#include <vector>

#include "core/blossom/detail/checks.h"
#include "core/blossom/detail/closed_form.h"
#include "core/forms/detail/checks.h"

namespace blossom {
namespace {

template <class Point>
void check(const char* function, const MonomialPatchOf<Point>& patch) {
  detail::check_degree(function, patch.degree_u());
  detail::check_degree(function, patch.degree_v());
  detail::check_placement(function, patch.centre_u, patch.scale_u);
  detail::check_placement(function, patch.centre_v, patch.scale_v);
}

}  // namespace

template <class Point>
Point blossom_at(const MonomialPatchOf<Point>& patch, std::span<const double> u,
                 std::span<const double> v) {
  check("blossom_at", patch);
  detail::check_parameters("blossom_at", "patch along u", patch.degree_u(), u);
  detail::check_parameters("blossom_at", "patch along v", patch.degree_v(), v);
  const std::vector<double> local_u = detail::local_parameters(u, patch.centre_u, patch.scale_u);
  const std::vector<double> local_v = detail::local_parameters(v, patch.centre_v, patch.scale_v);
  const std::vector<double> along_u = detail::monomial_blossoms(std::span(local_u));
  const std::vector<double> along_v = detail::monomial_blossoms(std::span(local_v));
  Point sum{};
  for (int i = 0; i <= patch.degree_u(); ++i) {
    Point row{};
    for (int j = 0; j <= patch.degree_v(); ++j)
      row += patch.coefficients(i, j) * along_v[detail::index(j)];
    sum += row * along_u[detail::index(i)];
  }
  return sum;
}

template <class Point>
Point blossom_at(const BezierPatchOf<Point>& patch, std::span<const double> u,
                 std::span<const double> v) {
  detail::check_degree("blossom_at", patch.degree_u());
  detail::check_degree("blossom_at", patch.degree_v());
  detail::check_parameters("blossom_at", "patch along u", patch.degree_u(), u);
  detail::check_parameters("blossom_at", "patch along v", patch.degree_v(), v);
  std::vector<Point> column;
  for (int i = 0; i <= patch.degree_u(); ++i) {
    std::vector<Point> row;
    for (int j = 0; j <= patch.degree_v(); ++j) row.push_back(patch.points(i, j));
    column.push_back(detail::casteljau_blossom(row, v));
  }
  return detail::casteljau_blossom(column, u);
}

template <class Point>
BezierPatchOf<Point> bezier_points(const MonomialPatchOf<Point>& patch, const Interval& u,
                                   const Interval& v) {
  check("bezier_points", patch);
  detail::check_interval("bezier_points", "of u", u);
  detail::check_interval("bezier_points", "of v", v);
  return {detail::bezier_net(patch, u, v)};
}

template <class Point>
double blossom_scale(const MonomialPatchOf<Point>& patch, const Interval& u, const Interval& v) {
  check("blossom_scale", patch);
  detail::check_interval("blossom_scale", "of u", u);
  detail::check_interval("blossom_scale", "of v", v);
  const Interval local_u = detail::local_interval(u, patch.centre_u, patch.scale_u);
  const Interval local_v = detail::local_interval(v, patch.centre_v, patch.scale_v);
  MonomialPatchOf<Point> sizes{patch.coefficients};
  for (Point& point : sizes.coefficients.values()) point = detail::absolute(point);
  const Grid<Point> net =
      detail::bezier_net(sizes, detail::absolute(local_u), detail::absolute(local_v));
  double largest = 0;
  for (const Point& point : net.values()) largest = std::max(largest, max_norm(point));
  return largest;
}

#define BLOSSOM_INSTANTIATE(Point)                                                            \
  template Point blossom_at(const MonomialPatchOf<Point>&, std::span<const double>,           \
                            std::span<const double>);                                         \
  template Point blossom_at(const BezierPatchOf<Point>&, std::span<const double>,             \
                            std::span<const double>);                                         \
  template BezierPatchOf<Point> bezier_points(const MonomialPatchOf<Point>&, const Interval&, \
                                              const Interval&);                               \
  template double blossom_scale(const MonomialPatchOf<Point>&, const Interval&, const Interval&);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
