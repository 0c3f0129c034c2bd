// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/patch_subdivision.h"

#include "core/forms/detail/checks.h"
#include "core/math/matrix.h"
#include "core/subdivision/detail/cuts.h"

namespace blossom {

template <class Point>
BezierPatchOf<Point> sub_patch(const BezierPatchOf<Point>& patch, const Interval& u,
                               const Interval& v) {
  detail::check_degree("sub_patch", patch.degree_u());
  detail::check_degree("sub_patch", patch.degree_v());
  detail::check_interval("sub_patch", "of u", u);
  detail::check_interval("sub_patch", "of v", v);
  const Grid<double> along_u = detail::subdivision_matrix(patch.degree_u(), u);
  const Grid<double> along_v = detail::subdivision_matrix(patch.degree_v(), v);
  return {product_transposed(product(along_u, patch.points), along_v)};
}

template <class Point>
Grid<BezierPatchOf<Point>> subdivide(const BezierPatchOf<Point>& patch,
                                     std::span<const double> u_cuts,
                                     std::span<const double> v_cuts) {
  detail::check_degree("subdivide", patch.degree_u());
  detail::check_degree("subdivide", patch.degree_v());
  detail::check_cuts("subdivide", "cuts along u", u_cuts);
  detail::check_cuts("subdivide", "cuts along v", v_cuts);
  const std::vector<Grid<double>> along_u = detail::matrices(patch.degree_u(), u_cuts);
  const std::vector<Grid<double>> along_v = detail::matrices(patch.degree_v(), v_cuts);
  const int rows = static_cast<int>(along_u.size()), columns = static_cast<int>(along_v.size());
  Grid<BezierPatchOf<Point>> cells(rows, columns);
  for (int i = 0; i < rows; ++i) {
    const Grid<Point> strip = product(along_u[detail::index(i)], patch.points);
    for (int j = 0; j < columns; ++j)
      cells(i, j).points = product_transposed(strip, along_v[detail::index(j)]);
  }
  return cells;
}

#define BLOSSOM_INSTANTIATE(Point)                                                      \
  template BezierPatchOf<Point> sub_patch(const BezierPatchOf<Point>&, const Interval&, \
                                          const Interval&);                             \
  template Grid<BezierPatchOf<Point>> subdivide(const BezierPatchOf<Point>&,            \
                                                std::span<const double>, std::span<const double>);
BLOSSOM_INSTANTIATE(double)
BLOSSOM_INSTANTIATE(Vec2)
BLOSSOM_INSTANTIATE(Vec3)
BLOSSOM_INSTANTIATE(Vec4)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
