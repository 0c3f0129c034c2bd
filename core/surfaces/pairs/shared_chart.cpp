// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/shared_chart.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/forms/algebra/products.h"
#include "core/forms/evaluation.h"
#include "core/subdivision/growth.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/subdivision/subdivision_matrix.h"
#include "core/surfaces/gap/contact_points.h"
#include "core/surfaces/gap/limits.h"

namespace blossom {
namespace {

constexpr double kStep = 1.0 / 16;  // along a, fraction of a patch
constexpr double kStepB = 1.0 / 8;  // along b
constexpr double kMinStep = 1e-6;
constexpr double kBeyond = 0.5;           // how far b is extended
constexpr double kStraight = 1e-7;        // an iso-line of a that strays less on b is one of b
constexpr double kMinDomain = 1e-4;       // of a domain
constexpr double kPowerError = 0x1p-48;   // of products of powers, relative to them
constexpr double kGrowthError = 0x1p-46;  // of a piece beyond the patch

double gap_at(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x) {
  return distance(point_at(a, x[0], x[1]), point_at(b, x[2], x[3]));
}

bool on_extension(const Point4& x) {
  return std::min(x[2], x[3]) >= -kBeyond && std::max(x[2], x[3]) <= 1 + kBeyond;
}

// Follows the foot along u (k = 0) or v (k = 1) up to the end of a or of b's extension. Nothing if
// the patches part.
std::optional<Point4> farthest(const RationalBezierPatch& a, const RationalBezierPatch& b, Point4 x,
                               std::size_t k, double goal, double tolerance) {
  double step = kStep;
  while (x[k] != goal && step > kMinStep) {
    Point4 start = x;
    start[k] = goal > x[k] ? std::min(goal, x[k] + step) : std::max(goal, x[k] - step);
    auto next = foot_point(a, b, start, kNewtonReach);
    if (next) (*next)[k] = start[k];
    const double moved =
        next ? std::max(std::abs((*next)[2] - x[2]), std::abs((*next)[3] - x[3])) : kUnbounded;
    if (moved > kStepB || !on_extension(*next)) {
      step *= 0.5;
      continue;
    }
    if (gap_at(a, b, *next) > tolerance) return std::nullopt;
    x = *next;
    step = std::min(2 * step, kStep);
  }
  return x;
}

// The foot at a place between two of an iso-line.
std::optional<Point4> between(const RationalBezierPatch& a, const RationalBezierPatch& b, Point4 x,
                              std::size_t k, double goal, double tolerance) {
  constexpr double kReached = 1e-15;  // part of the patch: a few roundings of a parameter
  const auto found = farthest(a, b, x, k, goal, tolerance);
  return found && std::abs((*found)[k] - goal) < kReached ? found : std::nullopt;
}

struct Direction {
  std::size_t other;  // the parameter of b that varies: 2 or 3
  LinearRational map;
};

std::optional<Direction> direction_of(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                      const Point4& x, std::size_t k, double tolerance) {
  const auto low = farthest(a, b, x, k, 0, tolerance), high = farthest(a, b, x, k, 1, tolerance);
  if (!low || !high || (*high)[k] - (*low)[k] < kMinDomain) return std::nullopt;
  const auto middle = between(a, b, *low, k, 0.5 * ((*low)[k] + (*high)[k]), tolerance);
  if (!middle) return std::nullopt;
  const double ds = std::abs((*high)[2] - (*low)[2]), dt = std::abs((*high)[3] - (*low)[3]);
  if (std::min(ds, dt) > kStraight) return std::nullopt;
  Direction result{ds > dt ? 2U : 3U, {}};
  const std::size_t o = result.other;
  const double part = ((*middle)[o] - (*low)[o]) / ((*high)[o] - (*low)[o]);
  if (!(part > 0 && part < 1)) return std::nullopt;
  result.map = {{(*low)[k], (*high)[k]}, {(*low)[o], (*high)[o]}, (1 - part) / part};
  return result;
}

// b over the chart's domain in a's parameters: control points times powers of the ratios.
RationalBezierPatch mapped(RationalBezierPatch piece, const SharedChart& chart) {
  const int n = piece.degree_u(), m = piece.degree_v();
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j)
      piece.points(i, j) *= std::pow(chart.s.ratio, n - i) * std::pow(chart.t.ratio, m - j);
  if (!chart.transposed) return piece;
  RationalBezierPatch turned{Grid<Vec4>(m + 1, n + 1)};
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) turned.points(j, i) = piece.points(i, j);
  return turned;
}

struct Homogeneous {
  BezierFunction2 weight;
  BezierPatch point;
};

Homogeneous parts_of(const RationalBezierPatch& patch) {
  const int rows = patch.points.rows(), columns = patch.points.columns();
  Homogeneous parts{{Grid<double>(rows, columns)}, {Grid<Vec3>(rows, columns)}};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const Vec4& p = patch.points(i, j);
      parts.weight.points(i, j) = p[3];
      parts.point.points(i, j) = {p[0], p[1], p[2]};
    }
  return parts;
}

// How far control points are from the origin; infinite if a weight is not positive.
double reach_of(const RationalBezierPatch& patch) {
  double reach = 0;
  for (const Vec4& p : patch.points.values())
    reach = p[3] > 0 ? std::max(reach, norm(Vec3{p[0], p[1], p[2]}) / p[3]) : kUnbounded;
  return reach;
}

// Bound on the distance of two patches at equal parameters: a quotient of two forms is at most the
// largest quotient of their coefficients if those of the divisor are positive. A coefficient that
// is a sum of positive multiples of w x is rounded relative to that of w times the reach of x,
// which is not that of the pieces: a small one near the origin may be of a patch that reaches far.
double distance_bound(const RationalBezierPatch& a, const RationalBezierPatch& b, double reach) {
  const Homogeneous p = parts_of(a), q = parts_of(b);
  const BezierPatch left = product(q.weight, p.point), right = product(p.weight, q.point);
  const BezierFunction2 weight = product(p.weight, q.weight);
  double worst = 0;
  for (std::size_t i = 0; i < left.points.values().size(); ++i)
    worst = std::max(worst, norm(left.points.values()[i] - right.points.values()[i]) /
                                weight.points.values()[i]);
  const int degree = std::max({a.degree_u(), a.degree_v(), b.degree_u(), b.degree_v()});
  const double rounding =
      product_error(std::min(a.degree_u(), b.degree_u()), std::min(a.degree_v(), b.degree_v())) +
      subdivision_error(degree) + kPowerError;
  return worst + 4 * rounding * reach;
}

// Bound on what rounding moves points of a piece beyond the patch's own parameters. At t the
// weights of a point add up to |t| + |1 - t| for each degree.
double error_beyond(const RationalBezierPatch& patch, const RationalBezierPatch& piece,
                    const Interval& s, const Interval& t, double reach) {
  const double growth = bezier_growth(patch.degree_u(), s) * bezier_growth(patch.degree_v(), t);
  if (growth <= 1) return 0;
  double largest = 0, least = kUnbounded;
  for (const Vec4& p : patch.points.values()) largest = std::max(largest, p[3]);
  for (const Vec4& p : piece.points.values()) least = std::min(least, p[3]);
  return kGrowthError * growth * largest / least * reach;
}

Interval range(const LinearRational& f, const Interval& x) {
  const double p = f(x.from), q = f(x.to);
  return {std::min(p, q), std::max(p, q)};
}

}  // namespace

double LinearRational::operator()(double x) const {
  const double t = (x - from.from) / length(from);
  return at(to, t / (t + ratio * (1 - t)));
}

std::array<Interval, 2> SharedChart::image(const Interval& u, const Interval& v) const {
  return {range(s, transposed ? v : u), range(t, transposed ? u : v)};
}

std::array<Interval, 2> SharedChart::inverse_image(const Interval& in_s,
                                                   const Interval& in_t) const {
  const Interval from_s = range(s.inverse(), in_s), from_t = range(t.inverse(), in_t);
  if (transposed) return {from_t, from_s};
  return {from_s, from_t};
}

std::optional<SharedChart> shared_chart(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                        const Point4& near, double tolerance) {
  const auto x = foot_point(a, b, near, kNewtonReach);
  if (!x || !on_extension(*x) || gap_at(a, b, *x) > tolerance) return std::nullopt;
  const auto along_u = direction_of(a, b, *x, 0, tolerance);
  if (!along_u) return std::nullopt;
  const auto along_v = direction_of(a, b, *x, 1, tolerance);
  if (!along_v || along_u->other == along_v->other) return std::nullopt;
  SharedChart chart;
  chart.transposed = along_u->other == 3;
  chart.s = (chart.transposed ? along_v : along_u)->map;
  chart.t = (chart.transposed ? along_u : along_v)->map;
  chart.domain = {along_u->map.from, along_v->map.from};
  const RationalBezierPatch of_a = sub_patch(a, chart.domain[0], chart.domain[1]);
  const RationalBezierPatch of_b = sub_patch(b, chart.s.to, chart.t.to);
  const double reach =
      std::max(reach_of(a), reach_of(of_a)) + std::max(reach_of(b), reach_of(of_b));
  if (!(reach < kUnbounded)) return std::nullopt;
  const double error = error_beyond(b, of_b, chart.s.to, chart.t.to, reach);
  if (!(distance_bound(of_a, mapped(of_b, chart), reach) + error <= tolerance)) return std::nullopt;
  return chart;
}

}  // namespace blossom
