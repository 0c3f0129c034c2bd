// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls that lean on an edge at which the faces bend away from them.
//
// A contact that comes to such an edge at which its face ends goes on along it, while the direction
// to the centre turns from the normal of that face to the normal of the one behind; then it goes on
// over that face, or back over the first one.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <BRep_Tool.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/strips/ball_walker.h"
#include "core/math/functions/sign_change.h"

namespace blossom::occt {
namespace {

constexpr int kLeaningSteps = 64;  // along a strip, between which the ball leans or does not
constexpr double kLeftAt = 1e-12;  // of a strip's range: where the ball leaves the edge

}  // namespace

double nearest_on_edge(const BodyEdges& body, int edge, const Vec3& point) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(body.edge(edge), range.from, range.to);
  return nearest_on(curve, range, point);
}

// Whether an edge, if it is one, begins in the vertex of a half-edge.
bool BallWalker::begins_at(int edge, const DirectedEdge& half) const {
  return edge > 0 && (body_.vertex({edge, true}).IsSame(body_.vertex(half)) ||
                      body_.vertex({edge, false}).IsSame(body_.vertex(half)));
}

// Whether an edge begins in a vertex in which the run ends.
bool BallWalker::is_end_edge(int edge) const {
  return !run_.closed && (begins_at(edge, run_.first()) || begins_at(edge, run_.last()));
}

// Whether the faces at an edge over which a contact leaves its face turn away from the ball, which
// then can lean on it.
bool BallWalker::leans(const ContactCrossing& over) const {
  const auto profile = profiles_.everywhere();
  if (!profile || !profile->is_ball() || is_smooth_at(body_, over) || is_end_edge(over.use->edge))
    return false;
  const EdgeUseInFace& other = body_.behind(*over.use);
  if (other.face == over.use->face) return false;
  const double falls = -dot(body_.corner(other, over.edge_parameter).inwards,
                            body_.corner(*over.use, over.edge_parameter).normal);
  return run_.concave ? falls > 0 : falls < 0;
}

// Whether the ball's way is along that edge.
bool BallWalker::runs_along(const WalkedStrip& of, double t, const ContactCrossing& over) const {
  const Vec3 way = unit(vec(of.strip.spine->DN(t, 1)));
  return std::abs(dot(way, body_.corner(*over.use, over.edge_parameter).along)) >
         std::cos(kMaxBend);
}

// Whether the contact goes on along that edge in any case: at a bend, along the ball's way.
bool BallWalker::holds(const WalkedStrip& of, double t, const ContactCrossing& over) const {
  if (!leans(over)) return false;
  const BodyEdges::Corner here = body_.corner(*over.use, over.edge_parameter),
                          behind = body_.corner(body_.behind(*over.use), over.edge_parameter);
  return dot(here.normal, behind.normal) > std::cos(kMaxBend) && runs_along(of, t, over);
}

// Whether it does at a sharper one: before the end of the run, where that is not cut there.
bool BallWalker::holds_sharp(const WalkedStrip& of, std::size_t place, int step,
                             const WalkExit& end, const ContactCrossing& over) const {
  std::size_t nearest = 0;
  if (!is_before_end(of, place, step, end, nearest) || !leans(over)) return false;
  return runs_along(of, end.t, over) || !joint_at(over.use->edge, place, step);
}

// Of a ball that leans on an edge, where it comes to the next one: in their common vertex, where
// they may go on in each other, and the crossing is no better known than where they part.
ContactCrossing BallWalker::in_common_vertex(const WalkedStrip& of, std::size_t side,
                                             ContactCrossing at) const {
  const int held = held_by(of)[side], next = at.use->edge;
  for (const bool at_start : {true, false}) {
    if (held == 0 || held == next || !begins_at(next, {held, at_start})) continue;
    const Vec3 place = point_of(body_.vertex({held, at_start}));
    at.t = nearest_on(of.strip.contacts[contact_at(of, side)].curve, of.strip.range, place);
    at.edge_parameter = nearest_on_edge(body_, next, place);
    break;
  }
  return at;
}

// Where a contact goes on along the edge at which its face ends. Beside a left contact what stays
// of faces is to the left of the way, so the edge is left to the face that lies there: that is the
// contact's face, whether it came from it or not.
WalkExit BallWalker::onto_edge(const WalkedStrip& of, std::size_t side, const ContactCrossing& met,
                               int step) const {
  const ContactCrossing at = in_common_vertex(of, side, met);
  WalkExit found{at.t, {}, false, 0, held_by(of)};
  found.held[side] = at.use->edge;
  const Vec3 way = (of.forward ? step : -step) * vec(of.strip.spine->DN(at.t, 1));
  const bool along = dot(way, body_.corner(*at.use, at.edge_parameter).along) > 0;
  const bool stays_left = (side == 0) == (step > 0);
  if (at.use->forward != (along == stays_left)) found.over[side] = at;
  return found;
}

// How far the centre of a ball that leans on an edge has turned past the normal of a face there:
// positive where it would touch the face inside of it.
double BallWalker::turned_past(const WalkedStrip& of, std::size_t side, const EdgeUseInFace& use,
                               double t) const {
  const Vec3 point = vec(of.strip.contacts[contact_at(of, side)].curve->Value(t));
  const BodyEdges::Corner at = body_.corner(use, nearest_on_edge(body_, use.edge, point));
  return dot(vec(of.strip.spine->Value(t)) - point, at.inwards);
}

// The first place of a way at which a ball that leans on an edge touches a face there.
std::optional<double> BallWalker::turns_onto(const WalkedStrip& of, std::size_t side,
                                             const EdgeUseInFace& use, const Interval& way) const {
  const auto past = [&](double t) { return turned_past(of, side, use, t); };
  double before = way.from;
  for (int i = 1; i <= kLeaningSteps; ++i) {
    const double t = at(way, static_cast<double>(i) / kLeaningSteps), there = past(t);
    // It begins with 0 where it came from that face.
    if (there > 0)
      return narrowed(past, {before, t}, std::min(past(before), 0.0), there,
                      kLeftAt * length(of.strip.range))
          .below;
    before = t;
  }
  return std::nullopt;
}

// Where a ball that leans on an edge comes off it: onto the contact's face, or back over the edge.
std::optional<WalkExit> BallWalker::off_edge(const WalkedStrip& of, double from, int ahead) const {
  std::optional<WalkExit> first;
  const Interval way{from, ahead > 0 ? of.strip.range.to : of.strip.range.from};
  for (const std::size_t side : {0U, 1U}) {
    const int edge = held_by(of)[side];
    if (edge == 0) continue;
    const RolledContact& contact = of.strip.contacts[contact_at(of, side)];
    const EdgeUseInFace& own = body_.use_in(edge, contact.face);
    for (const bool back : {true, false}) {
      const auto t = turns_onto(of, side, back ? body_.behind(own) : own, way);
      if (!t || (first && ahead * (*t - first->t) >= 0)) continue;
      first = WalkExit{*t, {}, false, 0, held_by(of)};
      first->held[side] = 0;
      if (!back) continue;
      const double x = nearest_on_edge(body_, edge, vec(contact.curve->Value(*t)));
      const double along = dot(vec(contact.curve->DN(*t, 1)), body_.corner(own, x).along);
      first->over[side] = ContactCrossing{*t, &own, x, ahead * along > 0, true};
    }
  }
  return first;
}

}  // namespace blossom::occt
