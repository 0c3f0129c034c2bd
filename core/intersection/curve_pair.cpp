// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/curve_pair.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace blossom {
namespace {

constexpr int kNewtonSteps = 24;
constexpr double kConverging = 1e-6;  // steps below this, in parts of the cells, square
constexpr double kSettled = 1e-16;    // the next step, in parts of the cells
constexpr double kLeastStep = 1e-17;  // in parameters of the span
constexpr double kStalled = 1e-12;    // below this, steps that shrink no more are rounding
constexpr double kReach = 0.5;        // how far outside the cells Newton's steps may lead
constexpr double kParallel = 1e-3;    // sine below which chords in space have no common normal
constexpr double kAngleSlack = 1e-14;

Vec3 turned(const Vec3& v) { return {-v[1], v[0], 0}; }

bool apart(const ValueRange& a, const ValueRange& b, double tolerance) {
  return a.low > b.high + tolerance || b.low > a.high + tolerance;
}

bool apart_along(const CurvePair& pair, const Vec3& direction, double tolerance) {
  return apart(range_along(pair.a, pair.dimension(), direction),
               range_along(pair.b, pair.dimension(), direction), tolerance);
}

Vec3 middle_of(const CurveCell& cell) { return (cell.low + cell.high) * 0.5; }

// A direction perpendicular to both chords, in space; if those are nearly parallel, the one from
// one cell to the other.
Vec3 common_normal(const CurvePair& pair) {
  const Vec3 normal = cross(pair.a.axis, pair.b.axis);
  if (norm(normal) > kParallel) return unit(normal);
  const Vec3& axis = pair.a.axis;
  const Vec3 between = middle_of(pair.b) - middle_of(pair.a);
  const Vec3 across = between - axis * dot(axis, between);
  if (norm(across) > kParallel * norm(between)) return unit(across);
  return unit(cross(axis, std::abs(axis[0]) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
}

struct Normals {
  std::array<Vec3, 3> directions;
  int count;
};

// Normals of the fat lines; unit, or zero where a cell has no chord.
Normals normals_of(const CurvePair& pair) {
  if (pair.dimension() == 2) return {{turned(pair.a.axis), turned(pair.b.axis), Vec3{}}, 2};
  const Vec3 normal = common_normal(pair);
  return {{normal, unit(cross(normal, pair.a.axis)), unit(cross(normal, pair.b.axis))}, 3};
}

bool inside_reach(double t, const Interval& cell) {
  const double reach = kReach * length(cell);
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

Vec3 rotated(const Vec3& v, double cosine, double sine) {
  return {cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1], 0};
}

double cross_z(const Vec3& a, const Vec3& b) { return a[0] * b[1] - a[1] * b[0]; }

}  // namespace

CurveFoot foot_at(const CurvePair& pair, const SpanPoint& a, const SpanPoint& b) {
  return {a, b, pair.tree_a.jet(a), pair.tree_b.jet(b)};
}

bool boxes_apart(const CurvePair& pair, double tolerance) {
  for (int k = 0; k < pair.dimension(); ++k)
    if (apart({pair.a.low[k], pair.a.high[k]}, {pair.b.low[k], pair.b.high[k]}, tolerance))
      return true;
  return false;
}

bool separated(const CurvePair& pair, double tolerance) {
  if (pair.a.axis == Vec3{} || pair.b.axis == Vec3{}) return false;
  const Normals normals = normals_of(pair);
  for (int i = 0; i < normals.count; ++i)
    if (apart_along(pair, normals.directions[static_cast<std::size_t>(i)], tolerance)) return true;
  return false;
}

bool within_strip(const CurvePair& pair, double tolerance) {
  const Vec3 axis = pair.a.extent >= pair.b.extent ? pair.a.axis : pair.b.axis;
  if (axis == Vec3{}) return false;
  std::array<Vec3, 2> across{turned(axis), Vec3{}};
  if (pair.dimension() == 3) {
    across[0] = unit(cross(axis, std::abs(axis[0]) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    across[1] = cross(axis, across[0]);
  }
  double square = 0;
  for (int i = 0; i + 1 < pair.dimension(); ++i) {
    const Vec3& direction = across[static_cast<std::size_t>(i)];
    const ValueRange a = range_along(pair.a, pair.dimension(), direction);
    const ValueRange b = range_along(pair.b, pair.dimension(), direction);
    const double width = std::max(a.high, b.high) - std::min(a.low, b.low);
    square += width * width;
  }
  return square <= tolerance * tolerance;
}

std::optional<double> least_sine(const CurvePair& pair) {
  const double ca = pair.a.cosine, cb = pair.b.cosine;
  if (!(ca > 0 && cb > 0)) return std::nullopt;
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
    if (settled || size < kLeastStep || (size < kStalled && shrink > 0.25)) return foot;
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
    const Vec3 p = pair.a.axis * -sign_a, q = pair.b.axis * sign_b;
    const double turn = cross_z(p, q) > 0 ? 1 : -1;
    const double sa = std::sqrt(1 - pair.a.cosine * pair.a.cosine);
    const double sb = std::sqrt(1 - pair.b.cosine * pair.b.cosine);
    const Vec3 first = rotated(p, pair.a.cosine, -turn * sa);
    const Vec3 last = rotated(q, pair.b.cosine, turn * sb);
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
