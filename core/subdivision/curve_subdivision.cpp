// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/curve_subdivision.h"

#include "core/forms/detail/checks.h"
#include "core/math/matrix.h"
#include "core/subdivision/detail/cuts.h"

namespace blossom {

template <class Point>
BezierCurveOf<Point> sub_curve(const BezierCurveOf<Point>& curve, const Interval& piece) {
  detail::check_degree("sub_curve", curve.degree());
  detail::check_interval("sub_curve", "of the piece", piece);
  return {product(detail::subdivision_matrix(curve.degree(), piece), curve.points)};
}

template <class Point>
std::vector<BezierCurveOf<Point>> subdivide(const BezierCurveOf<Point>& curve,
                                            std::span<const double> cuts) {
  detail::check_degree("subdivide", curve.degree());
  detail::check_cuts("subdivide", "cuts", cuts);
  std::vector<BezierCurveOf<Point>> pieces;
  for (const Grid<double>& matrix : detail::matrices(curve.degree(), cuts))
    pieces.push_back({product(matrix, curve.points)});
  return pieces;
}

#define BLOSSOM_INSTANTIATE(Point)                                                       \
  template BezierCurveOf<Point> sub_curve(const BezierCurveOf<Point>&, const Interval&); \
  template std::vector<BezierCurveOf<Point>> subdivide(const BezierCurveOf<Point>&,      \
                                                       std::span<const double>);
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
