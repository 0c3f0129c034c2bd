// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the contacts of a rolling ball leave their faces.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/strips/ball_walker.h"

namespace blossom::occt {

// Whether a ball is past both ends of an open run.
bool BallWalker::is_past_end(const Vec3& centre) const {
  double least = 0;
  bool past = true;
  for (std::size_t i = 0; i < run_.edges.size(); ++i) {
    const RunEdge& each = run_.edges[i];
    Interval range;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(body_.edge(each.edge), range.from, range.to);
    const double x = nearest_on(curve, range, centre);
    const double away = distance(vec(curve->Value(x).XYZ()), centre);
    if (i > 0 && away >= least) continue;
    least = away;
    past = !run_.closed &&
           ((i == 0 && x == (each.forward ? range.from : range.to)) ||
            (i + 1 == run_.edges.size() && x == (each.forward ? range.to : range.from)));
  }
  return past;
}

// The crossings at notches that are beside the run: the ball rolls over them, but leans on a bend.
std::vector<Notch> BallWalker::notches_beside(const WalkedStrip& of, std::size_t contact,
                                              const std::vector<ContactCrossing>& crossed) const {
  std::vector<Notch> all = notches(body_, of.strip, contact, crossed);
  std::erase_if(all, [&](const Notch& each) {
    if (holds(of, each.leaves.t, each.leaves) && holds(of, each.enters.t, each.enters)) return true;
    return is_past_end(vec(of.strip.spine->Value(each.leaves.t).XYZ())) ||
           is_past_end(vec(of.strip.spine->Value(each.enters.t).XYZ()));
  });
  return all;
}

// Seams are none, as the face is the same behind them. Over the edge that it entered by, or that it
// begins on, a contact leaves its face only where it goes out of it: where faces do not quite
// touch, its way in is not quite where the strip before ended.
std::optional<ContactCrossing> BallWalker::first_crossing(const WalkedStrip& of, std::size_t side,
                                                          double from, int ahead,
                                                          int entered) const {
  const std::size_t contact = contact_at(of, side);
  std::optional<ContactCrossing> best;
  const std::vector<ContactCrossing> all =
      contact_crossings(body_, of.strip, contact, options_.filleted);
  const std::vector<Notch> round = notches_beside(of, contact, all);
  for (const ContactCrossing& each : all) {
    const double far = ahead * (each.t - from);
    const double speed = of.strip.contacts[contact].curve->DN(each.t, 1).Magnitude();
    const double room =
        kSamePlace * std::max(options_.tolerance, each.use->coedge->tolerance) / speed;
    const bool is_entered = each.use->edge == entered, leaves = each.leaves == (ahead > 0);
    if (far < (is_entered ? room : -room) || (far < room && !leaves)) continue;
    if (is_entered && !leaves) continue;
    if (is_seam_at(body_, each)) continue;
    if (std::ranges::any_of(round, [&](const Notch& notch) { return notch.has(each.t); })) continue;
    if (!best || far < ahead * (best->t - from)) best = each;
  }
  return best;
}

// How far apart in t places are that count as one.
double BallWalker::same_place(const WalkedStrip& of, double t) const {
  double speed = 0;
  for (const RolledContact& each : of.strip.contacts)
    speed = std::max(speed, each.curve->DN(t, 1).Magnitude());
  return kSamePlace * options_.tolerance / speed;
}

// Both contacts at once, where they go over smooth edges at one place.
WalkExit BallWalker::over_edges(const WalkedStrip& of, std::size_t side,
                                const ContactCrossing& first,
                                const std::optional<ContactCrossing>& other) const {
  WalkExit found{first.t, {}, false, 0, held_by(of)};
  found.over[side] = first;
  if (!other || !is_smooth_at(body_, *other)) return found;
  WalkExit both = found;
  both.over[1 - side] = other;
  const double speed =
      of.strip.contacts[contact_at(of, 1 - side)].curve->DN(found.t, 1).Magnitude();
  return std::abs(other->t - found.t) * speed <= reach_at(of, both) ? both : found;
}

// Whether a chamfer goes on over an edge that begins in the vertex ahead of it. Its section in the
// plane across a vertex in which the run goes on is that of both edges there, so faces need not go
// on smoothly beside it.
bool BallWalker::goes_on_across(const WalkedStrip& of, const ContactCrossing& over,
                                std::size_t place, int step) const {
  if (!options_.fillet.chamfer || !of.of_edge || !next_place(place, step)) return false;
  const RunEdge& last = run_.edges[place];
  const bool rises = of.forward == (step > 0);
  const double end = rises ? of.strip.edge_range.to : of.strip.edge_range.from;
  return begins_at(over.use->edge, {last.edge, last.forward != (step > 0)}) &&
         std::abs(over.t - end) <= same_place(of, end);
}

// Where strips end at an edge, or lean on one, they are as near to each other as it is to its
// faces; in one of its vertices, as that is to it.
double BallWalker::reach_at(const WalkedStrip& of, const WalkExit& exit) const {
  double reach = options_.tolerance;
  for (const std::size_t side : {0U, 1U})
    for (const int number :
         {exit.over[side] ? exit.over[side]->use->edge : 0, exit.held[side], held_by(of)[side]}) {
      if (number == 0) continue;
      const TopoDS_Edge edge = body_.edge(number);
      reach = std::max(reach, BRep_Tool::Tolerance(edge));
      const Vec3 place = vec(of.strip.contacts[contact_at(of, side)].curve->Value(exit.t));
      for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
        const double tolerance = BRep_Tool::Tolerance(end);
        if (distance(place, point_of(end)) <= tolerance) reach = std::max(reach, tolerance);
      }
    }
  return kSamePlace * reach;
}

}  // namespace blossom::occt
