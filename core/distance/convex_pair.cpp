// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/convex_pair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/cells/cell_bend.h"

namespace blossom {
namespace {

// Covers the roundings of the few operations in a bound.
constexpr double kSlack = 1e-13;
// Derivatives by parameters are this much less exact than points: twice the degree, and what
// quotients add.
constexpr double kDerivativeGrowth = 64;

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

using KnownMatrix = std::array<std::array<Known, 4>, 4>;

// A bound below the second derivatives of f by the cells' own parameters, as quadratic forms:
//   f_xx = J^T J + r . r_xx,  J = (A_u, A_v, -B_s, -B_t),  r = A - B
// With J = J0 + E, |J v|^2 >= |J0 v|^2 / 2 - |E v|^2: so vectors with J0 v = 0, which move both
// points alike and along which f hardly changes, lose the square of the derivatives' spread only.
KnownMatrix hessian(const CellOf& a, const CellOf& b, const std::array<bool, 4>& counts) {
  const auto seconds = [](const CellOf& of) {
    return of.form.dimension == 0 ? SecondDerivatives{} : second_derivatives(*of.cell, of.shape);
  };
  const SecondDerivatives ca = seconds(a), cb = seconds(b);
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
