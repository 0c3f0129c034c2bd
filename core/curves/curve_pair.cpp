// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/curve_pair.h"

#include <algorithm>
#include <cmath>

#include "core/bounds/value_arithmetic.h"
#include "core/curves/limits.h"

namespace blossom {
namespace {

constexpr int kNewtonSteps = 24;
constexpr double kConverging = 1e-6;  // steps below this, in parts of the cells, square
constexpr double kSettled = 1e-16;    // the next step, in parts of the cells
constexpr double kMinStep = 1e-17;    // in parameters of the span
constexpr double kAngleSlack = 1e-14;

bool inside_reach(double t, const Interval& cell) {
  const double reach = kNewtonReach * length(cell);
  return t > cell.from - reach && t < cell.to + reach;
}

// The step of Gauss and Newton: least squares of a' ds - b' dt + gap by orthogonalisation.
std::optional<Vec2> newton_step(const CurveFoot& foot) {
  const double speed = norm(foot.jet_a.first);
  if (!(speed > 0)) return std::nullopt;
  const Vec3 q1 = foot.jet_a.first * (1 / speed);
  const double along = dot(q1, foot.jet_b.first);
  const Vec3 across = foot.jet_b.first - q1 * along;
  const double r = norm(across);
  if (!(r > 0)) return std::nullopt;
  const Vec3 gap = foot.gap();
  const double dt = dot(across, gap) / (r * r);
  return Vec2{(along * dt - dot(q1, gap)) / speed, dt};
}

// Sectors of less than half a turn are are_apart as lines if all turns from one to the other have
// one sign; then the least sine is that of two of their sides.
std::optional<double> least_sine_in_plane(const CurveCell& a, const CurveCell& b) {
  const double sign = cross_z(a.axis, b.axis) > 0 ? 1 : -1;
  const double low = sign * cross_z(a.left, b.right), high = sign * cross_z(a.right, b.left);
  const double inner = sign * cross_z(a.right, b.right);
  const double sine = std::min(low, high) - kAngleSlack;
  if (!(sine > 0 && inner > 0)) return std::nullopt;
  return sine;
}

}  // namespace

CurveFoot foot_at(const CurvePair& pair, const SpanPoint& a, const SpanPoint& b) {
  return {a, b, pair.tree_a.jet(a), pair.tree_b.jet(b)};
}

bool boxes_apart(const CurvePair& pair, double tolerance) {
  for (int k = 0; k < pair.dimension(); ++k)
    if (are_apart({pair.a.low[k], pair.a.high[k]}, {pair.b.low[k], pair.b.high[k]}, tolerance))
      return true;
  return false;
}

std::optional<double> least_sine(const CurvePair& pair) {
  const double ca = pair.a.cosine, cb = pair.b.cosine;
  if (!(ca > 0 && cb > 0)) return std::nullopt;
  if (pair.dimension() == 2) return least_sine_in_plane(pair.a, pair.b);
  const double sa = std::sqrt(1 - ca * ca), sb = std::sqrt(1 - cb * cb);
  const double cosine_sum = ca * cb - sa * sb, sine_sum = sa * cb + ca * sb;
  const double between = std::abs(dot(pair.a.axis, pair.b.axis)) + kAngleSlack;
  if (!(cosine_sum > between)) return std::nullopt;
  const double sine = std::sqrt(std::max(0.0, 1 - between * between));
  return sine * cosine_sum - between * sine_sum;
}

std::optional<CurveFoot> nearest_feet(const CurvePair& pair, CurveFoot foot) {
  double last = 1;
  for (int k = 0; k < kNewtonSteps; ++k) {
    const auto step = newton_step(foot);
    if (!step) return std::nullopt;
    const SpanPoint a{foot.a.span, foot.a.t + (*step)[0]}, b{foot.b.span, foot.b.t + (*step)[1]};
    if (!inside_reach(a.t, pair.a.local) || !inside_reach(b.t, pair.b.local)) return std::nullopt;
    foot = foot_at(pair, a, b);
    const double size = max_norm(*step);
    // In parts of the cells, each step is about the square of the last.
    const double part = std::max(std::abs((*step)[0]) / length(pair.a.local),
                                 std::abs((*step)[1]) / length(pair.b.local));
    const double shrink = size / last;
    const bool settled = part < kConverging && part * shrink * shrink < kSettled;
    if (settled || size < kMinStep || (size < kNewtonStalled && shrink > 0.25)) return foot;
    last = size;
  }
  return std::nullopt;
}

CurveFoot chord_feet(const CurvePair& pair) {
  const auto ends = [&](const CurveCell& cell, Vec3& from, Vec3& along) {
    const int n = cell.points;
    for (int k = 0; k < pair.dimension(); ++k) {
      from[k] = cell.hull[k * n];
      along[k] = cell.hull[k * n + n - 1] - from[k];
    }
  };
  CurveFoot chords;
  ends(pair.a, chords.jet_a.point, chords.jet_a.first);
  ends(pair.b, chords.jet_b.point, chords.jet_b.first);
  const Vec2 step = newton_step(chords).value_or(Vec2{0.5, 0.5});
  return foot_at(pair, {pair.a.span, at(pair.a.local, std::clamp(step[0], 0.0, 1.0))},
                 {pair.b.span, at(pair.b.local, std::clamp(step[1], 0.0, 1.0))});
}

// A common point A(s) = B(t) has A(s) = A(s0) + x with x in the cone of a or, for s < s0, in its
// opposite; likewise B. So the gap at (s0, t0) lies in one of the cones y - x; it must be in none.
bool cones_exclude(const CurvePair& pair, const CurveFoot& foot) {
  const Vec3 gap = foot.gap();
  const double slack = 4 * pair.margin();
  const auto excluded = [&](double sign_a, double sign_b) {
    const bool left = -sign_a * sign_b * cross_z(pair.a.axis, pair.b.axis) > 0;
    const double turn = left ? 1 : -1;
    const Vec3 first = (left ? pair.a.right : pair.a.left) * -sign_a;
    const Vec3 last = (left ? pair.b.left : pair.b.right) * sign_b;
    return turn * cross_z(first, gap) < -slack || turn * cross_z(gap, last) < -slack;
  };
  for (const double sign_a : {-1.0, 1.0}) {
    if (foot.a.t == (sign_a < 0 ? pair.a.local.from : pair.a.local.to)) continue;
    for (const double sign_b : {-1.0, 1.0}) {
      if (foot.b.t == (sign_b < 0 ? pair.b.local.from : pair.b.local.to)) continue;
      if (!excluded(sign_a, sign_b)) return false;
    }
  }
  return true;
}

}  // namespace blossom
