// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/cells/foot_borders.h"

#include <algorithm>
#include <cmath>

namespace blossom {
namespace {

constexpr double kSharp = 0.25;      // error of a model that tells where to halve
constexpr double kAlike = 0.25;      // third order to second: the gap bends alike over the cell
constexpr double kWide = 0.5;        // of a chart
constexpr double kOnBorder = 1e-9;   // fraction of a patch
constexpr double kRounding = 1e-12;  // of a product of slopes

// The slope of a polynomial along a direction whose entries are at most 1.
TaylorRange slope_range(const TaylorPolynomial& p, const Vec2& direction, double error) {
  const TaylorPolynomial x = derivative_x(p), y = derivative_y(p);
  TaylorPolynomial along;
  for (std::size_t i = 0; i < along.size(); ++i)
    along[i] = direction[0] * x[i] + direction[1] * y[i];
  const TaylorRange r = range(along, 1, 1);
  return {r.low - error, r.high + error};
}

TaylorRange times(const TaylorRange& a, const TaylorRange& b) {
  const auto [low, high] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}

// By x and by y: how much a polynomial changes over the cell, or, from second order on, its slope.
Vec2 changes(const TaylorPolynomial& p, int from) {
  Vec2 sum{};
  for (int k = from; k <= kTaylorDegree; ++k)
    for (int j = 0; j <= k; ++j) {
      const double size = std::abs(p[taylor_index(k - j, j)]) * (from == 2 ? k - 1 : 1);
      sum[0] += size * (k - j);
      sum[1] += size * j;
    }
  return sum;
}

// Of the terms of one order.
double size_of(const TaylorPolynomial& p, int order) {
  double sum = 0;
  for (int j = 0; j <= order; ++j) sum += std::abs(p[taylor_index(order - j, j)]);
  return sum;
}

// How far foot points reach over a border from both sides; negative if they do not.
double reach_over(const Interval& x, double border) {
  return std::min(border - x.from, x.to - border);
}

// The direction in which foot points move over the border that they reach over farthest.
std::optional<bool> halving_at_border(const Box2& foot, const GapModel& model) {
  double farthest = 0;
  Vec2 moves{};
  for (std::size_t k = 0; k < 2; ++k)
    for (const double border : {0.0, 1.0}) {
      const double reach = reach_over(foot[k], border);
      if (reach <= kOnBorder || reach <= farthest * length(foot[k])) continue;
      farthest = reach / length(foot[k]);
      moves = changes(model.foot[k], 1);
    }
  if (farthest == 0) return std::nullopt;
  return moves[0] >= moves[1];
}

}  // namespace

Box2 foot_box(const GapModel& model) {
  Box2 box;
  for (std::size_t k = 0; k < 2; ++k) {
    const TaylorRange r = range(model.foot[k], 1, 1);
    box[k] = {r.low - model.foot_error[k], r.high + model.foot_error[k]};
  }
  return box;
}

bool crosses_border_once(const GapModel& model, const GapSlope& slope) {
  const Box2 foot = foot_box(model);
  int sides = 0;
  std::size_t crossed = 0;
  for (std::size_t k = 0; k < 2; ++k)
    for (const double border : {0.0, 1.0})
      if (reach_over(foot[k], border) > -kOnBorder) {
        ++sides;
        crossed = k;
      }
  if (sides != 1) return false;
  const Vec2 z = slope.direction, w{-z[1], z[0]};
  const double error = model.foot_slope_error[crossed];
  const TaylorRange first = times(slope_range(model.foot[crossed], w, error),
                                  slope_range(model.gap, z, model.gap_error[1]));
  const TaylorRange second = times(slope_range(model.foot[crossed], z, error),
                                   slope_range(model.gap, w, model.gap_error[1]));
  const double rounding =
      kRounding * (std::max(-first.low, first.high) + std::max(-second.low, second.high));
  return first.low > second.high + rounding || first.high + rounding < second.low;
}

std::optional<bool> halving_of(const GapModel& model, double tolerance) {
  const Vec2 bend = changes(model.gap, 2);
  const double first = size_of(model.gap, 1), second = size_of(model.gap, 2);
  const double most = std::max(bend[0], bend[1]);
  if (const auto along_u = halving_at_border(foot_box(model), model))
    return second > kAlike * first ? std::nullopt : along_u;
  if (std::min(bend[0], bend[1]) > kAlike * most || size_of(model.gap, 3) > kAlike * second ||
      model.gap_error[0] > kSharp * tolerance || model.gap_error[1] > kSharp * most)
    return std::nullopt;
  return bend[0] >= bend[1];
}

std::optional<bool> halving_of(const Cell& a, const GraphChart& chart) {
  const auto width = [&](const Vec3& along) {
    return std::max(std::abs(dot(chart.to_s, along)), std::abs(dot(chart.to_t, along)));
  };
  const double u = width(a.du.middle), v = width(a.dv.middle);
  if (std::max(u, v) < kWide) return std::nullopt;
  return u >= v;
}

}  // namespace blossom
