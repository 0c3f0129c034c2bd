// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a walk has to end, and which way it goes.
#include <cstddef>
#include <optional>
#include <string>

#include <BRep_Tool.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/strips/ball_walker.h"

namespace blossom::occt {
namespace {

// Halvings of the way of a ball that turns back, to a thousandth of it.
constexpr int kTurnSteps = 10;

}  // namespace

// Whether a walk stops before the end of its run, and not at an edge that begins in the run's last
// vertex: there what is left of the run is as much behind the strip's end as the rest of a single
// edge.
//
// nearest   the edge of the run that is nearest to where it stops
bool BallWalker::is_before_end(const WalkedStrip& of, std::size_t place, int step,
                               const WalkExit& end, std::size_t& nearest) const {
  if (!next_place(place, step)) return false;
  if (!run_.closed && begins_at(end.sharp_edge, end_half(step))) return false;
  const Vec3 centre = vec(of.strip.spine->Value(end.t).XYZ());
  std::optional<double> least;
  for (std::size_t i = 0; i < run_.edges.size(); ++i) {
    Interval range;
    const Handle(Geom_Curve) curve =
        BRep_Tool::Curve(body_.edge(run_.edges[i].edge), range.from, range.to);
    const double away = distance(vec(curve->Value(nearest_on(curve, range, centre)).XYZ()), centre);
    if (least && away >= *least) continue;
    nearest = i;
    least = away;
  }
  return run_.closed || next_place(nearest, step);
}

// A walk that stops there has left the edges.
void BallWalker::check_end(const WalkedStrip& of, std::size_t place, int step,
                           const WalkExit& end) const {
  std::size_t nearest = 0;
  if (!is_before_end(of, place, step, end, nearest)) return;
  const Vec3 centre = vec(of.strip.spine->Value(end.t).XYZ());
  const Interval& most = of.strip.most;
  if (end.sharp_edge == 0 &&
      ((end.t == most.from && of.strip.pinched[0]) || (end.t == most.to && of.strip.pinched[1])))
    refuse(FilletFault::Pinch, nearest,
           "the ball is too large for the curvature of face " +
               std::to_string(of.strip.contacts[0].face) + " or face " +
               std::to_string(of.strip.contacts[1].face) +
               ": it rolls only along a part of the edge",
           centre);
  refuse(
      FilletFault::LeavesFace, nearest,
      "the ball stops at " +
          (end.sharp_edge > 0 ? "edge " + std::to_string(end.sharp_edge) + ", " : std::string()) +
          "a border of face " + std::to_string(of.strip.contacts[0].face) + " or face " +
          std::to_string(of.strip.contacts[1].face) + ", before it comes to the end of the edges",
      centre);
}

// How a ball goes on at a place of its way, by the edge of the run that is nearest to it.
BallWalker::Course BallWalker::course(const WalkedStrip& of, int step, double t) const {
  gp_Pnt centre;
  gp_Vec rate;
  of.strip.spine->D1(t, centre, rate);
  if (of.forward != (step > 0)) rate.Reverse();
  Course made;
  double least = 0;
  for (std::size_t i = 0; i < run_.edges.size(); ++i) {
    const bool forward = run_.edges[i].forward == (step > 0);
    Interval range;
    const Handle(Geom_Curve) curve =
        BRep_Tool::Curve(body_.edge(run_.edges[i].edge), range.from, range.to);
    const double x = nearest_on(curve, range, vec(centre.XYZ()));
    gp_Pnt foot;
    gp_Vec along;
    curve->D1(x, foot, along);
    const double away = foot.Distance(centre);
    if (i > 0 && away >= least) continue;
    least = away;
    made = {i, (forward ? 1 : -1) * rate.Dot(along), x == (forward ? range.to : range.from)};
  }
  return made;
}

// Whether the ball has come past the last edge of an open run.
bool BallWalker::is_past_run(const WalkedStrip& of, const WalkExit& exit, std::size_t place,
                             int step) const {
  return !run_.closed && !next_place(place, step) && course(of, step, exit.t).past_end;
}

// A ball that finds no room further on, as faces come too near to each other, turns round and rolls
// back, perhaps along another edge of theirs, until it goes over a border of them.
void BallWalker::check_course(const WalkedStrip& of, int step, const Interval& way) const {
  const Course last = course(of, step, way.to);
  if (last.past_end || last.ahead >= 0) return;
  Interval turn = way;
  for (int i = 0; i < kTurnSteps; ++i) {
    const double middle = at(turn, 0.5);
    (course(of, step, middle).ahead < 0 ? turn.to : turn.from) = middle;
  }
  refuse(FilletFault::NoBall, course(of, step, turn.from).place,
         "the ball turns back before the end of the edge: further on there is no room for it "
         "between the faces",
         vec(of.strip.spine->Value(turn.from).XYZ()));
}

}  // namespace blossom::occt
