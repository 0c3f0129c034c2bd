// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/pair_search/arc_lines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/base/unbounded.h"
#include "core/forms/evaluation.h"
#include "core/math/spans.h"

namespace blossom::occt {
namespace {

using Range = std::array<Interval, 2>;  // of u and v

constexpr Interval kAll{-kInfinity, kInfinity};

// Whether a line between two spans of an arc goes through a box of parameters.
bool holds_arc_line(const BezierSurface& surface, const Range& box) {
  const auto any_in = [](const std::vector<double>& knots, ParameterLaw law,
                         const Interval& range) {
    return law == ParameterLaw::Angle &&
           std::any_of(knots.begin() + 1, knots.end() - 1,
                       [&](double at) { return range.from <= at && at <= range.to; });
  };
  return any_in(surface.u_knots, surface.u_law, box[0]) ||
         any_in(surface.v_knots, surface.v_law, box[1]);
}

bool has_inner_arcs(const BezierSurface& surface) { return holds_arc_line(surface, {kAll, kAll}); }

// A place is known to within its size, or the tolerance, over the first derivatives; where one
// vanishes, all of its parameter may be of the place.
Range widened_by_size(const BezierSurface& surface, Range box, double size) {
  const Vec2 middle{at(box[0], 0.5), at(box[1], 0.5)};
  const std::size_t i = span_of(surface.u_knots, middle[0]),
                    j = span_of(surface.v_knots, middle[1]);
  const Interval u{surface.u_knots[i], surface.u_knots[i + 1]},
      v{surface.v_knots[j], surface.v_knots[j + 1]};
  const Vec2 local{local_parameter(surface.u_law, u, middle[0]),
                   local_parameter(surface.v_law, v, middle[1])};
  const PatchJet jet =
      jet_at(surface.patches(static_cast<int>(i), static_cast<int>(j)), local[0], local[1], 1);
  const double by_u = size * parameter_derivative(surface.u_law, u, local[0]) / norm(jet.u);
  const double by_v = size * parameter_derivative(surface.v_law, v, local[1]) / norm(jet.v);
  return {Interval{box[0].from - by_u, box[0].to + by_u},
          Interval{box[1].from - by_v, box[1].to + by_v}};
}

// Those that nobody has set tell nothing.
bool are_known(const Place& place) { return place.parameters != Place{}.parameters; }

bool is_on_arc_line(const BezierSurface& surface, const Range& box, const Place& place,
                    double tolerance) {
  if (!are_known(place)) return has_inner_arcs(surface);
  const double size = std::max(distance(place.box_low, place.box_high), tolerance);
  return holds_arc_line(surface, widened_by_size(surface, box, size));
}

}  // namespace

bool may_be_of_arc_lines(const SurfaceIntersection& found, const BezierSurface& a,
                         const BezierSurface& b, double tolerance) {
  if (found.status == Status::Stopped) return has_inner_arcs(a) || has_inner_arcs(b);
  return std::ranges::any_of(found.places, [&](const Place& place) {
    const auto& [u_a, v_a, u_b, v_b] = place.parameters;
    return place.kind != PlaceKind::Overlap && (is_on_arc_line(a, {u_a, v_a}, place, tolerance) ||
                                                is_on_arc_line(b, {u_b, v_b}, place, tolerance));
  });
}

}  // namespace blossom::occt
