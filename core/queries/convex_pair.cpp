// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/queries/convex_pair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/intersection/net_ranges.h"

namespace blossom {
namespace {

// Covers the roundings of the few operations in a bound.
constexpr double kSlack = 1e-13;
// Derivatives by parameters are this much less exact than points: twice the degree, and what
// quotients add.
constexpr double kDerivativeGrowth = 64;
constexpr std::size_t kMostPoints = (kMaxDegree + 1) * (kMaxDegree + 1);

VectorBounds operator-(const VectorBounds& a, const VectorBounds& b) {
  return {a.middle - b.middle, a.radius + b.radius};
}

// A number known as middle +- radius.
struct Known {
  double middle = 0;
  double radius = 0;
};

Known operator+(const Known& a, const Known& b) {
  return {a.middle + b.middle, a.radius + b.radius};
}
Known operator-(const Known& a, const Known& b) {
  return {a.middle - b.middle, a.radius + b.radius};
}
Known operator*(const Known& a, const Known& b) {
  return {a.middle * b.middle, std::abs(a.middle) * b.radius +
                                   a.radius * (std::abs(b.middle) + b.radius) +
                                   kSlack * std::abs(a.middle * b.middle)};
}

Known dot(const VectorBounds& a, const VectorBounds& b) {
  Known sum;
  for (int k = 0; k < 3; ++k)
    sum = sum + Known{a.middle[k], a.radius[k]} * Known{b.middle[k], b.radius[k]};
  return sum;
}

Known of_range(const Range& range, double factor, double margin) {
  return {0.5 * factor * (range.low + range.high),
          factor * (0.5 * (range.high - range.low) * (1 + kSlack) + margin)};
}

// The second derivatives of a cell by its own [0, 1] parameters.
struct Curvatures {
  VectorBounds uu, uv, vv;
};

struct Seconds {
  Known uu, uv, vv;
};

// Of one plane of a net, each value of which is off by at most `margin`.
Seconds seconds_of(const double* plane, const NetShape& shape, double margin) {
  const int n = shape.rows - 1, m = shape.columns - 1;
  const SecondRanges ranges = second_difference_ranges(plane, shape.rows, shape.columns);
  return {of_range(ranges.uu, n * (n - 1), 4 * margin), of_range(ranges.uv, n * m, 4 * margin),
          of_range(ranges.vv, m * (m - 1), 4 * margin)};
}

Curvatures of_polynomial(const CellOf& of) {
  Curvatures result;
  for (int k = 0; k < 3; ++k) {
    const Seconds s =
        seconds_of(of.cell->hull + k * of.shape.plane_size(), of.shape, of.cell->margin);
    result.uu.middle[k] = s.uu.middle, result.uu.radius[k] = s.uu.radius;
    result.uv.middle[k] = s.uv.middle, result.uv.radius[k] = s.uv.radius;
    result.vv.middle[k] = s.vv.middle, result.vv.radius[k] = s.vv.radius;
  }
  return result;
}

// With X' = X - w O for a point O in the middle of the cell's box, X' = w (S - O), so that
//   S_uu = (X'_uu - 2 w_u S_u - w_uu (S - O)) / w
//   S_uv = (X'_uv - w_u S_v - w_v S_u - w_uv (S - O)) / w
Curvatures of_rational(const CellOf& of) {
  const Cell& cell = *of.cell;
  const int size = of.shape.plane_size(), n = of.shape.rows - 1, m = of.shape.columns - 1;
  const double* weight = cell.homogeneous + 3 * size;
  const auto [least, most] = std::minmax_element(weight, weight + size);
  const Known inverse{0.5 * (1 / *least + 1 / *most),
                      0.5 * (1 / *least - 1 / *most) + kSlack / *least};
  const double slack = kSlack * *most;
  const Seconds w = seconds_of(weight, of.shape, slack);
  const Known wu = of_range(difference_range_u(weight, n + 1, m + 1), n, 2 * slack);
  const Known wv = of_range(difference_range_v(weight, n + 1, m + 1), m, 2 * slack);
  std::array<double, kMostPoints> moved;
  Curvatures result;
  for (int k = 0; k < 3; ++k) {
    const double origin = 0.5 * (cell.low[k] + cell.high[k]);
    const double* x = cell.homogeneous + k * size;
    for (int i = 0; i < size; ++i) moved[static_cast<std::size_t>(i)] = x[i] - weight[i] * origin;
    const Seconds s = seconds_of(moved.data(), of.shape, 2 * *most * cell.margin);
    const Known offset{0, 0.5 * (cell.high[k] - cell.low[k]) * (1 + kSlack)};
    const Known su{cell.du.middle[k], cell.du.radius[k]};
    const Known sv{cell.dv.middle[k], cell.dv.radius[k]};
    const Known two{2, 0};
    const Known uu = (s.uu - two * wu * su - w.uu * offset) * inverse;
    const Known uv = (s.uv - wu * sv - wv * su - w.uv * offset) * inverse;
    const Known vv = (s.vv - two * wv * sv - w.vv * offset) * inverse;
    result.uu.middle[k] = uu.middle, result.uu.radius[k] = uu.radius;
    result.uv.middle[k] = uv.middle, result.uv.radius[k] = uv.radius;
    result.vv.middle[k] = vv.middle, result.vv.radius[k] = vv.radius;
  }
  return result;
}

Curvatures curvatures(const CellOf& of) {
  if (of.form.dimension == 0) return {};
  return of.shape.planes == 4 ? of_rational(of) : of_polynomial(of);
}

using KnownMatrix = std::array<std::array<Known, 4>, 4>;

// A bound below the second derivatives of f by the cells' own parameters, as quadratic forms:
//   f_xx = J^T J + r . r_xx,  J = (A_u, A_v, -B_s, -B_t),  r = A - B
// With J = J0 + E, |J v|^2 >= |J0 v|^2 / 2 - |E v|^2: so vectors with J0 v = 0, which move both
// points alike and along which f hardly changes, lose the square of the derivatives' spread only.
KnownMatrix hessian(const CellOf& a, const CellOf& b, const std::array<bool, 4>& counts) {
  const Curvatures ca = curvatures(a), cb = curvatures(b);
  const auto box = [](const Cell& cell) {
    VectorBounds bounds{0.5 * (cell.low + cell.high), (0.5 + kSlack) * (cell.high - cell.low)};
    for (int k = 0; k < 3; ++k) bounds.radius[k] += 0x1p-51 * std::abs(bounds.middle[k]);
    return bounds;
  };
  const VectorBounds r = box(*a.cell) - box(*b.cell);
  const std::array<Vec3, 4> j0{a.cell->du.middle, a.cell->dv.middle, -b.cell->du.middle,
                               -b.cell->dv.middle};
  const std::array<Vec3, 4> spread{a.cell->du.radius, a.cell->dv.radius, b.cell->du.radius,
                                   b.cell->dv.radius};
  const auto dimensions = static_cast<double>(std::count(counts.begin(), counts.end(), true));
  KnownMatrix h;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j <= i; ++j) h[i][j].middle = 0.5 * dot(j0[i], j0[j]);
    // |E v|^2 <= (sum |E_i| |v_i|)^2 <= dimensions * sum |E_i|^2 v_i^2
    h[i][i].radius = dimensions * dot(spread[i], spread[i]);
  }
  h[0][0] = h[0][0] + dot(r, ca.uu);
  h[1][0] = h[1][0] + dot(r, ca.uv);
  h[1][1] = h[1][1] + dot(r, ca.vv);
  h[2][2] = h[2][2] - dot(r, cb.uu);
  h[3][2] = h[3][2] - dot(r, cb.uv);
  h[3][3] = h[3][3] - dot(r, cb.vv);
  return h;
}

// Whether all matrices within the bounds are positive definite in the directions that count: the
// middle, scaled to a diagonal of 1, by Cholesky's method less the largest row sum of the radii.
bool is_positive(const KnownMatrix& h, const std::array<bool, 4>& counts) {
  std::array<double, 4> scale{};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!counts[i]) continue;
    if (!(h[i][i].middle > h[i][i].radius)) return false;
    scale[i] = 1 / std::sqrt(h[i][i].middle);
  }
  double spread = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < 4; ++j)
      sum += scale[i] * scale[j] * h[std::max(i, j)][std::min(i, j)].radius;
    spread = std::max(spread, sum);
  }
  std::array<std::array<double, 4>, 4> l{};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!counts[i]) continue;
    for (std::size_t j = 0; j <= i; ++j) {
      if (!counts[j]) continue;
      double sum = scale[i] * scale[j] * h[i][j].middle;
      for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
      if (i == j && !((sum -= spread + kSlack) > 0)) return false;
      l[i][j] = i == j ? std::sqrt(sum) : sum / l[j][j];
    }
  }
  return true;
}

// Whether derivatives turn too much for the test to succeed: only saves time.
bool turns_far(const CellOf& of) {
  constexpr double kFar = 0.5;
  const auto turns = [](const VectorBounds& d) { return norm(d.radius) > kFar * norm(d.middle); };
  return (of.form.dimension > 0 && turns(of.cell->du)) ||
         (of.form.dimension > 1 && turns(of.cell->dv));
}

// The least value of the tangent plane of f at a place, as a distance.
double tangent_bound(const PatchOf& a, const PatchOf& b, const std::array<double, 4>& x,
                     const std::array<bool, 4>& counts, double rounding) {
  const SquaredGap gap = squared_gap(a, b, x);
  const std::array<Interval, 4> sides{a.u, a.v, b.u, b.v};
  const double far = std::sqrt(2 * gap.value);
  double fall = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!counts[i]) continue;
    // A slope r . d is known as far as r and d are.
    const Vec3& d = i == 0 ? gap.a.u : i == 1 ? gap.a.v : i == 2 ? gap.b.u : gap.b.v;
    const double error = rounding * (norm(d) + kDerivativeGrowth * far);
    fall += std::max({0.0, (gap.slope[i] + error) * (x[i] - sides[i].from),
                      (error - gap.slope[i]) * (sides[i].to - x[i])});
  }
  const double reach = std::max(0.0, far - rounding);
  return std::sqrt(std::max(0.0, reach * reach - 2 * fall)) * (1 - kSlack);
}

}  // namespace

double convex_bound(const CellOf& a, const CellOf& b, const Vec2& at_a, const Vec2& at_b,
                    double enough, double rounding) {
  const std::array<bool, 4> counts{a.form.dimension > 0, a.form.dimension > 1, b.form.dimension > 0,
                                   b.form.dimension > 1};
  if (turns_far(a) || turns_far(b) || !is_positive(hessian(a, b, counts), counts)) return 0;
  const auto piece = [](const CellOf& of) {
    return PatchOf{of.form.patch, of.form.dimension, of.cell->u, of.cell->v};
  };
  const PatchOf piece_a = piece(a), piece_b = piece(b);
  const double bound =
      tangent_bound(piece_a, piece_b, {at_a[0], at_a[1], at_b[0], at_b[1]}, counts, rounding);
  if (bound >= enough) return bound;
  const NearPair least = near_pair(piece_a, piece_b, at_a, at_b);
  return std::max(bound,
                  tangent_bound(piece_a, piece_b, {least.a[0], least.a[1], least.b[0], least.b[1]},
                                counts, rounding));
}

}  // namespace blossom
