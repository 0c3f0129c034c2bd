// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/retry/shorter_patches.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/cells/limits.h"
#include "core/forms/evaluation.h"
#include "core/subdivision/knot_insertion.h"
#include "core/surfaces/pairs/border_roots.h"

namespace blossom {
namespace {

// Tolerances: the length within which ends of arcs on a patch are one. Joints of chains and what
// lies on a border are up to four times as far apart.
constexpr double kSameLength = 0.25;
constexpr int kMaxCuts = 100;            // of a surface: the work grows with their square
constexpr std::size_t kMaxOpen = 5'000;  // places: more are no contacts but an early end

// The longest row of control points of a patch in a direction.
double extent(const RationalBezierPatch& patch, Direction direction) {
  const bool along_u = direction == Direction::U;
  const Grid<Vec4>& net = patch.points;
  double longest = 0;
  for (int row = 0; row < (along_u ? net.columns() : net.rows()); ++row) {
    const auto point = [&](int k) {
      const Vec4& p = along_u ? net(k, row) : net(row, k);
      return Vec3{p[0] / p[3], p[1] / p[3], p[2] / p[3]};
    };
    double sum = 0;
    for (int k = 1; k < (along_u ? net.rows() : net.columns()); ++k)
      sum += distance(point(k - 1), point(k));
    longest = std::max(longest, sum);
  }
  return longest;
}

using Rectangle = std::array<Interval, 2>;  // of parameters

bool meet(const Rectangle& p, const Rectangle& q) {
  return p[0].from <= q[0].to && q[0].from <= p[0].to && p[1].from <= q[1].to &&
         q[1].from <= p[1].to;
}

struct LongSpan {
  Direction direction;
  Interval span;
  double extent;
};

// The longest one of the patches that meet open places, if that is too long. By patches, since
// beside a pole a place may go all the way round, though it is short.
std::optional<LongSpan> long_span(const BezierSurface& surface, const std::vector<Rectangle>& open,
                                  double most) {
  LongSpan longest{Direction::U, {}, most};
  for (std::size_t i = 0; i + 1 < surface.u_knots.size(); ++i)
    for (std::size_t j = 0; j + 1 < surface.v_knots.size(); ++j) {
      const Rectangle place{Interval{surface.u_knots[i], surface.u_knots[i + 1]},
                            Interval{surface.v_knots[j], surface.v_knots[j + 1]}};
      if (std::ranges::none_of(open, [&](const Rectangle& x) { return meet(x, place); })) continue;
      const RationalBezierPatch& patch = surface.patches(static_cast<int>(i), static_cast<int>(j));
      for (const Direction direction : {Direction::U, Direction::V}) {
        const double length = extent(patch, direction);
        if (length > longest.extent)
          longest = {direction, place[direction == Direction::U ? 0 : 1], length};
      }
    }
  return longest.extent > most ? std::optional(longest) : std::nullopt;
}

}  // namespace

double longest_span(double tolerance) { return kSameLength * tolerance / kSamePoint; }

std::optional<BezierSurface> with_shorter_patches(const BezierSurface& surface, OpenOn which,
                                                  const SurfaceIntersection& found,
                                                  double tolerance) {
  const std::size_t first = which == OpenOn::First ? 0 : 2;
  std::vector<Rectangle> open;
  for (const Place& place : found.places)
    if (place.kind == PlaceKind::Open)
      open.push_back({place.parameters[first], place.parameters[first + 1]});
  if (open.size() > kMaxOpen) return std::nullopt;
  std::optional<BezierSurface> result;
  const double most = longest_span(tolerance);
  int cuts = 0;
  while (const auto cut = long_span(result ? *result : surface, open, most)) {
    if (++cuts > kMaxCuts) return std::nullopt;
    result =
        with_knot(result ? *result : surface, cut->direction, at(cut->span, kSurfaceOffMiddle));
  }
  return result;
}

}  // namespace blossom
