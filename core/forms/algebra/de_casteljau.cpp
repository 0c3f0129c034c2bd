// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/de_casteljau.h"

#include "core/forms/detail/checks.h"
#include "core/forms/function.h"

namespace blossom {
namespace {

// One level: every point becomes (1 - t) p_k + t p_(k + 1); the last one goes.
template <class Point>
void reduce(std::vector<Point>& points, double t) {
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    points[k] = points[k] * (1 - t) + points[k + 1] * t;
  points.pop_back();
}

template <class Point>
CurveDerivatives<Point> derivatives(std::vector<Point> points, double t) {
  const double n = static_cast<double>(points.size()) - 1;
  CurveDerivatives<Point> result{};
  while (points.size() > 3) reduce(points, t);
  if (points.size() == 3) {
    result.second = (points[2] - points[1] - (points[1] - points[0])) * (n * (n - 1));
    reduce(points, t);
  }
  if (points.size() == 2) {
    result.first = (points[1] - points[0]) * n;
    reduce(points, t);
  }
  result.point = points[0];
  return result;
}

template <class Point>
std::vector<Point> column(const BezierPatchOf<Point>& patch, int j) {
  std::vector<Point> points;
  for (int i = 0; i <= patch.degree_u(); ++i) points.push_back(patch.points(i, j));
  return points;
}

template <class Point>
void check(const char* function, const BezierPatchOf<Point>& patch) {
  detail::check_degree(function, patch.degree_u());
  detail::check_degree(function, patch.degree_v());
}

}  // namespace

template <class Point>
Point point_at(const BezierCurveOf<Point>& curve, double t) {
  detail::check_degree("point_at", curve.degree(), kMaxProductDegree);
  return derivatives(curve.points, t).point;
}

template <class Point>
Point point_at(const BezierPatchOf<Point>& patch, double u, double v) {
  check("point_at", patch);
  std::vector<Point> row;
  for (int j = 0; j <= patch.degree_v(); ++j) row.push_back(derivatives(column(patch, j), u).point);
  return derivatives(row, v).point;
}

template <class Point>
Point point_at(const BezierTriangleOf<Point>& triangle, double x, double y) {
  const int n = triangle.degree;
  detail::check_triangle("point_at", triangle, 2 * kMaxDegree);
  const double z = 1 - x - y;
  BezierTriangleOf<Point> level = triangle;
  for (int left = n - 1; left >= 0; --left)
    for (int nu = 0; nu <= left; ++nu)
      for (int mu = 0; nu + mu <= left; ++mu)
        level(nu, mu) = level(nu + 1, mu) * x + level(nu, mu + 1) * y + level(nu, mu) * z;
  return level(0, 0);
}

template <class Point>
CurveDerivatives<Point> derivatives_at(const BezierCurveOf<Point>& curve, double t) {
  detail::check_degree("derivatives_at", curve.degree(), kMaxProductDegree);
  return derivatives(curve.points, t);
}

template <class Point>
PatchDerivatives<Point> derivatives_at(const BezierPatchOf<Point>& patch, double u, double v) {
  check("derivatives_at", patch);
  std::vector<Point> points, first, second;
  for (int j = 0; j <= patch.degree_v(); ++j) {
    const CurveDerivatives<Point> along_u = derivatives(column(patch, j), u);
    points.push_back(along_u.point);
    first.push_back(along_u.first);
    second.push_back(along_u.second);
  }
  const CurveDerivatives<Point> value = derivatives(points, v);
  const CurveDerivatives<Point> mixed = derivatives(first, v);
  return {.point = value.point,
          .u = mixed.point,
          .v = value.first,
          .uu = derivatives(second, v).point,
          .uv = mixed.first,
          .vv = value.second};
}

#define BLOSSOM_INSTANTIATE(Point)                                                      \
  template Point point_at(const BezierCurveOf<Point>&, double);                         \
  template Point point_at(const BezierPatchOf<Point>&, double, double);                 \
  template Point point_at(const BezierTriangleOf<Point>&, double, double);              \
  template CurveDerivatives<Point> derivatives_at(const BezierCurveOf<Point>&, double); \
  template PatchDerivatives<Point> derivatives_at(const BezierPatchOf<Point>&, double, double);
BLOSSOM_INSTANTIATE(double)
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
