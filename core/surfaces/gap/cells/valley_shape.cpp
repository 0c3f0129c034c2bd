// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/cells/valley_shape.h"

#include <algorithm>
#include <cmath>

namespace blossom {
namespace {

constexpr double kMinBend = 0.1;    // of the largest bend across the valley
constexpr double kCoarse = 0.125;   // see `is_coarse`
constexpr double kLastMove = 1e-9;  // of Newton's method, which leaves about its square

// Where the valley is looked for on [-1, 1]: Chebyshev's nodes, and the coefficients of the cubics
// that are 1 at one of them and 0 at the others.
constexpr std::array kNodes{-0.9238795325112867, -0.3826834323650898, 0.3826834323650898,
                            0.9238795325112867};
constexpr auto kNodeCubics = [] {
  std::array<std::array<double, 4>, 4> cubics{};
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<double, 4>& cubic = cubics[i];
    cubic[0] = 1;
    for (std::size_t j = 0; j < 4; ++j) {
      if (j == i) continue;
      const double d = kNodes[i] - kNodes[j];
      for (std::size_t k = 4; k-- > 0;)
        cubic[k] = ((k > 0 ? cubic[k - 1] : 0) - kNodes[j] * cubic[k]) / d;
    }
  }
  return cubics;
}();

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
  if (!(shape.bend_low > kMinBend * shape.bend_high)) return std::nullopt;
  return shape;
}

// The valley at w by Newton's method; nothing if it leaves the range of the cell.
std::optional<double> ValleyShape::valley_at(double w, double near) const {
  const Polynomial across = along_y(gap_z, w);
  double z = near;
  for (int step = 0; step < 30; ++step) {
    const auto [slope, bend] = jet_at(across, z);
    const double move = slope / bend;
    z -= move;
    if (!(std::abs(z) < 2 * reach)) return std::nullopt;
    if (std::abs(move) < kLastMove) break;
  }
  return z;
}

// A cubic close to the valley over [from, to].
std::optional<TaylorCurve> ValleyShape::cubic_over(double from, double to) const {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  std::array<double, 4> cubic{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto z = valley_at(middle + half * kNodes[i]);
    if (!z) return std::nullopt;
    for (std::size_t k = 0; k < 4; ++k) cubic[k] += *z * kNodeCubics[i][k];
  }
  return TaylorCurve({middle, half}, cubic);
}

// How far the derivative across is from 0 along the cubic.
double ValleyShape::rest_along(const TaylorCurve& cubic) const {
  const PolynomialRange off = cubic.along(gap_z).range();
  return std::max(std::abs(off.low), std::abs(off.high)) + error[1];
}

std::array<ValleyStretch, 2> ValleyStretch::parts(double cut) const {
  const double t = (cut - from) / (to - from);
  const auto gaps = gap.parts(t), slopes = slope.parts(t);
  return {ValleyStretch{from, cut, gaps[0], slopes[0], rest},
          ValleyStretch{cut, to, gaps[1], slopes[1], rest}};
}

std::optional<ValleyStretch> ValleyShape::stretch(double from, double to) const {
  const auto cubic = cubic_over(from, to);
  if (!cubic) return std::nullopt;
  return ValleyStretch{from, to, cubic->along(gap), cubic->along(gap_w), rest_along(*cubic)};
}

ValleyBounds ValleyShape::bounds_on(const ValleyStretch& stretch) const {
  const PolynomialRange values = stretch.gap.range(), slope = stretch.slope.range();
  const auto [depth, tilt] = off_valley(stretch);
  return {values.low - depth - error[0], values.high + error[0], slope.low - tilt - error[1],
          slope.high + tilt + error[1]};
}

bool ValleyShape::is_coarse(const ValleyStretch& stretch) const {
  const PolynomialRange values = stretch.gap.range(), slope = stretch.slope.range();
  const auto [depth, tilt] = off_valley(stretch);
  return stretch.rest > 2 * error[1] && (depth > kCoarse * (values.high - values.low) ||
                                         tilt > kCoarse * (slope.high - slope.low));
}

// How far the gap and its slope along the curve may be from those of the valley.
std::array<double, 2> ValleyShape::off_valley(const ValleyStretch& stretch) const {
  return {stretch.rest * stretch.rest / (2 * bend_low), twist * stretch.rest / bend_low};
}

std::optional<ValleyShape::Along> ValleyShape::along(const TaylorPolynomial& f, double from,
                                                     double to) const {
  const auto cubic = cubic_over(from, to);
  if (!cubic) return std::nullopt;
  return Along{cubic->along(f).range(), rest_along(*cubic) / bend_low};
}

}  // namespace blossom
