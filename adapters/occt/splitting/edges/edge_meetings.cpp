// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/edges/edge_meetings.h"

#include <optional>

#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

// Whether an edge keeps within reach of another one from here to its end; where that is on it then.
std::optional<double> kept_to_end(const RangedCurve& edge, double from, double end,
                                  const RangedCurve& other, double within) {
  if (edge.curve->Value(from).Distance(edge.curve->Value(end)) <= within) return {};
  for (const double part : {0.25, 0.5, 0.75})
    if (foot_on(other, edge.curve->Value(at(Interval{from, end}, part))).distance > within)
      return {};
  const EdgeFoot foot = foot_on(other, edge.curve->Value(end));
  return foot.distance <= within ? std::optional(foot.parameter) : std::nullopt;
}

// The sine of an angle alpha. Edges that are off by a distance d may cross d / sin(alpha) from
// where they meet. A choice: where that is less than 10 d, the crossing is taken as found.
constexpr double kSteep = 0.1;

bool cross_steeply(const RangedCurve& a, double at_a, const RangedCurve& b, double at_b) {
  gp_Pnt point;
  gp_Vec along_a, along_b;
  a.curve->D1(at_a, point, along_a);
  b.curve->D1(at_b, point, along_b);
  return along_a.CrossMagnitude(along_b) > kSteep * along_a.Magnitude() * along_b.Magnitude();
}

}  // namespace

EdgesMeeting moved_to_end(EdgesMeeting met, double within) {
  const RangedCurve a = curve_of(met.a), b = curve_of(met.b);
  if (cross_steeply(a, met.at_a, b, met.at_b)) return met;
  for (const double end : {a.range.from, a.range.to})
    if (const auto on_b = kept_to_end(a, met.at_a, end, b, within))
      return {met.a, met.b, end, *on_b};
  for (const double end : {b.range.from, b.range.to})
    if (const auto on_a = kept_to_end(b, met.at_b, end, a, within))
      return {met.a, met.b, *on_a, end};
  return met;
}

}  // namespace blossom::occt
