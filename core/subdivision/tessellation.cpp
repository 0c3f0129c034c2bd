// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/tessellation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/errors.h"
#include "core/forms/detail/checks.h"
#include "core/math/detail/bernstein.h"
#include "core/math/matrix.h"

namespace blossom {
namespace {

void check(const char* function, const RationalBezierPatch& patch) {
  detail::check_degree(function, patch.degree_u());
  detail::check_degree(function, patch.degree_v());
  for (const Vec4& point : patch.points.values())
    if (!(point[3] > 0) || !std::isfinite(point[3]))
      throw InvalidInput(std::string(function) + ": weights must be positive, got " +
                         detail::text(point[3]));
}

// Derivatives by u (rows) or v (columns): differences times the degree.
Grid<Vec4> derivative(const Grid<Vec4>& net, bool by_u) {
  const int rows = net.rows() - (by_u ? 1 : 0), columns = net.columns() - (by_u ? 0 : 1);
  if (rows == 0 || columns == 0) return Grid<Vec4>(1, 1);
  const double degree = by_u ? rows : columns;
  Grid<Vec4> result(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      result(i, j) = (net(i + (by_u ? 1 : 0), j + (by_u ? 0 : 1)) - net(i, j)) * degree;
  return result;
}

// Largest length of the first three coordinates, and largest size of the fourth.
struct Sizes {
  double space = 0;
  double weight = 0;
};

Sizes sizes(const Grid<Vec4>& net) {
  Sizes largest;
  for (const Vec4& p : net.values()) {
    largest.space = std::max(largest.space, norm(Vec3{p[0], p[1], p[2]}));
    largest.weight = std::max(largest.weight, std::abs(p[3]));
  }
  return largest;
}

// The net relative to the first control point, which keeps |S| small in the quotient rule.
Grid<Vec4> near_origin(const Grid<Vec4>& net) {
  Grid<Vec4> result = net;
  const Vec4 first = net(0, 0) * (1 / net(0, 0)[3]);
  for (Vec4& p : result.values())
    for (int x = 0; x < 3; ++x) p[x] -= first[x] * p[3];
  return result;
}

}  // namespace

SecondDerivativeBounds second_derivative_bounds(const RationalBezierPatch& patch) {
  check("second_derivative_bounds", patch);
  const Grid<Vec4> net = near_origin(patch.points);
  const Grid<Vec4> net_u = derivative(net, true), net_v = derivative(net, false);
  const Sizes u = sizes(net_u), v = sizes(net_v), uu = sizes(derivative(net_u, true)),
              uv = sizes(derivative(net_u, false)), vv = sizes(derivative(net_v, false));
  double least = net(0, 0)[3], far = 0;  // |S| <= largest |X_i / w_i|
  for (const Vec4& p : net.values()) {
    least = std::min(least, p[3]);
    far = std::max(far, norm(Vec3{p[0], p[1], p[2]}) / p[3]);
  }
  // w S_u = X_u - w_u S and w S_uv = X_uv - w_u S_v - w_v S_u - w_uv S, likewise for uu and vv.
  const double s_u = (u.space + u.weight * far) / least;
  const double s_v = (v.space + v.weight * far) / least;
  return {(uu.space + 2 * u.weight * s_u + uu.weight * far) / least,
          (uv.space + u.weight * s_v + v.weight * s_u + uv.weight * far) / least,
          (vv.space + 2 * v.weight * s_v + vv.weight * far) / least};
}

double chord_bound(const SecondDerivativeBounds& bounds, const CellCount& cells) {
  const double l_u = 1.0 / cells.u, l_v = 1.0 / cells.v;
  return (l_u * l_u * bounds.uu + 2 * l_u * l_v * bounds.uv + l_v * l_v * bounds.vv) / 8;
}

CellCount cells_for_tolerance(const RationalBezierPatch& patch, double tolerance) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw InvalidInput("cells_for_tolerance: the tolerance must be positive and finite, got " +
                       detail::text(tolerance));
  const SecondDerivativeBounds bounds = second_derivative_bounds(patch);
  // Cells in proportion a : b; with k a and k b of them the bound is `unit` / k^2. The mixed
  // derivative keeps a direction from staying at one cell on a twisted patch.
  const double a = std::sqrt(bounds.uu + bounds.uv), b = std::sqrt(bounds.vv + bounds.uv);
  const double unit =
      ((a > 0 ? bounds.uu / (a * a) : 0) + (a > 0 && b > 0 ? 2 * bounds.uv / (a * b) : 0) +
       (b > 0 ? bounds.vv / (b * b) : 0)) /
      8;
  const double k = std::sqrt(unit / tolerance);
  const double u = std::max(1.0, std::ceil(k * a)), v = std::max(1.0, std::ceil(k * b));
  if (!(std::max(u, v) <= kMaxCells))
    throw InvalidInput("cells_for_tolerance: the tolerance " + detail::text(tolerance) +
                       " would take more than " + std::to_string(kMaxCells) +
                       " cells in a direction");
  CellCount cells{static_cast<int>(u), static_cast<int>(v)};
  if (chord_bound(bounds, cells) > tolerance) {  // k was rounded down
    if (a > 0) ++cells.u;
    if (b > 0) ++cells.v;
  }
  return cells;
}

Grid<Vec3> points_on_grid(const RationalBezierPatch& patch, const CellCount& cells) {
  check("points_on_grid", patch);
  if (cells.u < 1 || cells.v < 1)
    throw InvalidInput("points_on_grid: the numbers of cells must be positive, got " +
                       std::to_string(cells.u) + " and " + std::to_string(cells.v));
  const auto weights = [](int degree, int count) {
    Grid<double> matrix(count + 1, degree + 1);
    for (int k = 0; k <= count; ++k) {
      const auto row = detail::bernstein(degree, static_cast<double>(k) / count);
      for (int i = 0; i <= degree; ++i) matrix(k, i) = row[detail::index(i)];
    }
    return matrix;
  };
  const Grid<Vec4> points =
      product_transposed(product(weights(patch.degree_u(), cells.u), patch.points),
                         weights(patch.degree_v(), cells.v));
  Grid<Vec3> result(cells.u + 1, cells.v + 1);
  for (int i = 0; i <= cells.u; ++i)
    for (int j = 0; j <= cells.v; ++j) {
      const Vec4& p = points(i, j);
      result(i, j) = {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
    }
  return result;
}

}  // namespace blossom
