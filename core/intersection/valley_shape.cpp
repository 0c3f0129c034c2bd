// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/valley_shape.h"

#include <algorithm>
#include <cmath>

namespace blossom {
namespace {

constexpr double kLeastBend = 0.1;  // of the largest bend across the valley
constexpr int K = kTaylorDegree;

// p(w(t), z(t)).
Polynomial composed(const TaylorPolynomial& p, const Polynomial& w, const Polynomial& z) {
  Polynomial result{0};
  for (int i = K; i >= 0; --i) {
    Polynomial row{0};
    for (int j = K - i; j >= 0; --j) {
      row = product(row, z);
      row[0] += p[taylor_index(i, j)];
    }
    result = product(result, w);
    if (result.size() < row.size()) result.resize(row.size(), 0.0);
    for (std::size_t k = 0; k < row.size(); ++k) result[k] += row[k];
  }
  return result;
}

}  // namespace

// Axes by the Hessian in the middle.
std::optional<ValleyShape> ValleyShape::of(const GapModel& model) {
  const auto& g = model.gap;
  const double xx = 2 * g[taylor_index(2, 0)], xy = g[taylor_index(1, 1)],
               yy = 2 * g[taylor_index(0, 2)];
  // The eigenvector of the eigenvalue that is larger in size.
  const double mean = 0.5 * (xx + yy), half = std::hypot(0.5 * (xx - yy), xy);
  const double eigenvalue = mean >= 0 ? mean + half : mean - half;
  const Vec2 across = std::abs(eigenvalue - xx) > std::abs(eigenvalue - yy)
                          ? Vec2{xy, eigenvalue - xx}
                          : Vec2{eigenvalue - yy, xy};
  if (!(norm(across) > 0)) return std::nullopt;
  ValleyShape shape{TurnedAxes(across)};
  shape.error = model.gap_error;
  shape.gap = shape.turned(g);
  if (eigenvalue < 0)
    for (double& c : shape.gap) c = -c;
  shape.gap_z = derivative_y(shape.gap);
  shape.gap_w = derivative_x(shape.gap);
  shape.gap_zz = derivative_y(shape.gap_z);
  const TaylorRange bend = range(shape.gap_zz, shape.reach, shape.reach);
  shape.bend_low = bend.low - shape.error[2];
  shape.bend_high = bend.high + shape.error[2];
  const TaylorRange twist = range(derivative_x(shape.gap_z), shape.reach, shape.reach);
  shape.twist = std::max(std::abs(twist.low), std::abs(twist.high)) + shape.error[2];
  if (!(shape.bend_low > kLeastBend * shape.bend_high)) return std::nullopt;
  return shape;
}

// The valley at w by Newton's method; nothing if it leaves the range of the cell.
std::optional<double> ValleyShape::valley_at(double w) const {
  double z = 0;
  for (int step = 0; step < 30; ++step) {
    const double move = value(gap_z, w, z) / value(gap_zz, w, z);
    z -= move;
    if (!(std::abs(z) < 2 * reach)) return std::nullopt;
    if (std::abs(move) < 1e-15) break;
  }
  return z;
}

// A cubic close to the valley over [from, to], in t on [-1, 1].
std::optional<Polynomial> ValleyShape::cubic_over(double from, double to) const {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  constexpr std::array kNodes{-0.9238795325112867, -0.3826834323650898, 0.3826834323650898,
                              0.9238795325112867};
  std::array<double, 4> z;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto found = valley_at(middle + half * kNodes[i]);
    if (!found) return std::nullopt;
    z[i] = *found;
  }
  Polynomial cubic{0};
  for (std::size_t i = 0; i < 4; ++i) {
    Polynomial basis{z[i]};
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) {
        const double d = kNodes[i] - kNodes[j];
        basis = product(basis, {-kNodes[j] / d, 1 / d});
      }
    cubic.resize(basis.size(), 0.0);
    for (std::size_t k = 0; k < basis.size(); ++k) cubic[k] += basis[k];
  }
  return cubic;
}

std::optional<ValleyBounds> ValleyShape::bounds_on(double from, double to) const {
  const auto cubic = cubic_over(from, to);
  if (!cubic) return std::nullopt;
  const Polynomial w{0.5 * (from + to), 0.5 * (to - from)};
  const PolynomialRange values = range(composed(gap, w, *cubic));
  const PolynomialRange off = range(composed(gap_z, w, *cubic));
  const PolynomialRange slope = range(composed(gap_w, w, *cubic));
  const double rest = std::max(std::abs(off.low), std::abs(off.high)) + error[1];
  const double slack = twist * rest / bend_low + error[1];
  return ValleyBounds{values.low - rest * rest / (2 * bend_low) - error[0], values.high + error[0],
                      slope.low - slack, slope.high + slack};
}

std::optional<ValleyShape::Along> ValleyShape::along(const TaylorPolynomial& f, double from,
                                                     double to) const {
  const auto cubic = cubic_over(from, to);
  if (!cubic) return std::nullopt;
  const Polynomial w{0.5 * (from + to), 0.5 * (to - from)};
  const PolynomialRange off = range(composed(gap_z, w, *cubic));
  const double rest = std::max(std::abs(off.low), std::abs(off.high)) + error[1];
  return Along{range(composed(f, w, *cubic)), rest / bend_low};
}

}  // namespace blossom
