// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/shared_cells.h"

#include <algorithm>

#include "core/forms/evaluation.h"
#include "core/math/interval.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/surfaces/gap/gap_model.h"

namespace blossom {
namespace {

constexpr double kSlack = 1e-9;     // fraction of a patch, for the rounding of the maps
constexpr double kWidening = 0.01;  // of a chart
constexpr double kMaxTurn = 1.0;    // of cells tried; sines of the turns of both derivatives, added
constexpr int kMaxTries = 4;
constexpr int kLookEvery = 16;

double turn(const Cell& c) {
  return norm(c.du.radius) / norm(c.du.middle) + norm(c.dv.radius) / norm(c.dv.middle);
}

// What x has in common with `bounds`; if it lies outside by at most `slack`, the end next to it.
std::optional<Interval> clipped(const Interval& x, const Interval& bounds, double slack) {
  if (x.to < bounds.from - slack || x.from > bounds.to + slack) return std::nullopt;
  return Interval{std::clamp(x.from, bounds.from, bounds.to),
                  std::clamp(x.to, bounds.from, bounds.to)};
}

}  // namespace

bool SharedCells::look_near(const Cell& a, const Cell& b) {
  if (chart_) return true;
  if (looks_ == kMaxTries || asked_++ % kLookEvery != 0) return false;
  ++looks_;
  // Of the patches as given, whose move to the origin was rounded.
  const double tolerance = tolerance_ - 2 * (a_.given_rounding() + b_.given_rounding());
  if (!(tolerance > 0)) return false;
  chart_ = shared_chart(a_.patch(), b_.patch(),
                        {at(a.u, 0.5), at(a.v, 0.5), at(b.u, 0.5), at(b.v, 0.5)}, tolerance);
  return chart_.has_value();
}

std::optional<SharedPart> SharedCells::part(const Cell& a, const Cell& b) const {
  if (!chart_ || !(turn(a) + turn(b) < kMaxTurn)) return std::nullopt;
  if (!within(a.u, chart_->domain[0]) || !within(a.v, chart_->domain[1])) return std::nullopt;
  const auto foot = chart_->image(a.u, a.v);
  const auto graph = graph_chart(b_, hull(foot[0], b.u), hull(foot[1], b.v), kWidening);
  if (!graph) return std::nullopt;
  // The surfaces agree within the tolerance: so do the true feet with those of the maps.
  const PatchJet jet = jet_at(b_.patch(), at(b.u, 0.5), at(b.v, 0.5), 1);
  const double sine = norm(cross(jet.u, jet.v));
  const double slack_s = kSlack + 2 * tolerance_ * norm(jet.v) / sine;
  const double slack_t = kSlack + 2 * tolerance_ * norm(jet.u) / sine;
  const auto s = clipped(foot[0], b.u, slack_s), t = clipped(foot[1], b.v, slack_t);
  SharedPart result;
  if (!s || !t) return result;
  const auto place = chart_->inverse_image(*s, *t);
  const auto u = clipped(place[0], a.u, 1), v = clipped(place[1], a.v, 1);
  if (!u || !v) return result;
  result.empty = false;
  result.box = {*u, *v, *s, *t};
  const RationalBezierPatch piece = sub_patch(a_.patch(), *u, *v);
  for (const Vec4& p : piece.points.values()) {
    const Vec3 x = projected(p);
    result.hull = blossom::joined(result.hull, {x, x});
  }
  const Vec3 r{tolerance_, tolerance_, tolerance_};
  result.hull = {result.hull.low - r, result.hull.high + r};
  return result;
}

}  // namespace blossom
