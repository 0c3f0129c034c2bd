// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/pair_search/arc_lines.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace blossom::occt {
namespace {

// Whether a line between two spans of an arc goes through a box of parameters.
bool holds_arc_line(const BezierSurface& surface, const Interval& u, const Interval& v) {
  const auto any_in = [](const std::vector<double>& knots, ParameterLaw law,
                         const Interval& range) {
    return law == ParameterLaw::Angle &&
           std::any_of(knots.begin() + 1, knots.end() - 1,
                       [&](double at) { return range.from <= at && at <= range.to; });
  };
  return any_in(surface.u_knots, surface.u_law, u) || any_in(surface.v_knots, surface.v_law, v);
}

bool has_inner_arcs(const BezierSurface& surface) {
  constexpr Interval kAll{-std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::infinity()};
  return holds_arc_line(surface, kAll, kAll);
}

}  // namespace

bool may_be_of_arc_lines(const SurfaceIntersection& found, const BezierSurface& a,
                         const BezierSurface& b) {
  if (found.status == Status::Stopped) return has_inner_arcs(a) || has_inner_arcs(b);
  return std::ranges::any_of(found.places, [&](const Place& place) {
    const auto& [u_a, v_a, u_b, v_b] = place.parameters;
    return place.kind != PlaceKind::Overlap &&
           (holds_arc_line(a, u_a, v_a) || holds_arc_line(b, u_b, v_b));
  });
}

}  // namespace blossom::occt
