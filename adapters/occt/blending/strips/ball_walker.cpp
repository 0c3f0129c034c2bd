// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/ball_walker.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/strips/end_curves.h"

namespace blossom::occt {
namespace {

// What strips have past their edge grows by so many times until they meet what ends them, and
// strips that belong to no edge as a whole. All of a strip is fitted anew, so its edge's length
// does not count.
constexpr double kGrowth = 4;
constexpr double kGrowthAway = 2;

}  // namespace

// To the left and right of the way.
std::array<int, 2> BallWalker::faces_of(std::size_t place) const {
  const RunEdge& edge = run_.edges[place];
  return {body_.use(edge.edge, edge.forward).face, body_.use(edge.edge, !edge.forward).face};
}

// Whether the run goes round between two faces.
bool BallWalker::is_loop() const {
  for (std::size_t i = 1; i < run_.edges.size(); ++i)
    if (faces_of(i) != faces_of(0)) return false;
  return run_.closed;
}

const WalkedStrip& BallWalker::strip_at(std::size_t place) {
  if (made_[place]) return *made_[place];
  options_.tick();
  const RunEdge& edge = run_.edges[place];
  RolledStrip strip = profiles_.strip(body_, place);
  if (!is_loop() && strip.closed && strip.opened) strip = strip.opened();
  const double middle = at(strip.edge_range, 0.5);
  made_[place] = WalkedStrip{std::move(strip), edge.forward, middle};
  return *made_[place];
}

// A short edge may have no ball beside its middle where one rolls past it, which only those of one
// radius do.
std::optional<WalkedStrip> BallWalker::strip_if_any(std::size_t place) {
  try {
    return strip_at(place);
  } catch (const FilletRefused&) {
    if (!profiles_.everywhere()) throw;
    return std::nullopt;
  }
}

std::optional<std::size_t> BallWalker::next_place(std::size_t place, int step) const {
  const std::size_t count = run_.edges.size();
  if (step > 0 ? place + 1 < count : place > 0) return step > 0 ? place + 1 : place - 1;
  if (!run_.closed) return std::nullopt;
  return step > 0 ? 0 : count - 1;
}

// Whether other fillets end where the run does, or it would go on there: they, not borders of
// faces, end its strips.
bool BallWalker::is_shared(int step) const {
  const DirectedEdge half = end_half(step);
  const auto ring = body_.round(half);
  return std::ranges::any_of(ring, [&](const VertexSector& each) {
    if (options_.ended_before.count(each.half.edge) > 0) return true;
    return !(each.half == half) && options_.filleted.count(each.half.edge) > 0;
  });
}

// Whether the run ends where the ball passes edges: the strip stops before, whatever it goes over.
bool BallWalker::is_passed(int step) const {
  return std::ranges::any_of(body_.round(end_half(step)), [&](const VertexSector& each) {
    return passed_.count(each.half.edge) > 0;
  });
}

// More of a strip past one of its ends, if there is.
bool BallWalker::grow(WalkedStrip& of, bool at_start) const {
  const Interval range = of.strip.range, most = of.strip.most;
  if (!of.strip.over || !(at_start ? most.from < range.from : most.to > range.to)) return false;
  const Interval& edge = of.strip.edge_range;
  const double past = at_start ? edge.from - range.from : range.to - edge.to;
  const double more = past > 0 ? (kGrowth - 1) * past : (kGrowthAway - 1) * length(range);
  options_.tick();
  of.strip = of.strip.over(at_start ? Interval{std::max(most.from, range.from - more), range.to}
                                    : Interval{range.from, std::min(most.to, range.to + more)});
  return true;
}

// More of a strip than it has past the place where it ends, for the contact that goes on there.
bool BallWalker::grow_past(WalkedStrip& of, double t, int ahead) const {
  const RolledStrip& strip = of.strip;
  if (!strip.over) return false;
  double speed = 0;
  for (const RolledContact& each : strip.contacts)
    speed = std::max(speed, each.curve->DN(t, 1).Magnitude());
  Interval range = strip.range;
  const double room = kEndRadii * strip.radius / speed;
  if (ahead > 0)
    range.to = std::max(range.to, std::min(strip.most.to, t + room));
  else
    range.from = std::min(range.from, std::max(strip.most.from, t - room));
  if (range == strip.range) return false;
  options_.tick();
  of.strip = strip.over(range);
  return true;
}

// The end of a strip that narrows to a point in the last vertex of the run, if its contacts go over
// no edge before.
std::optional<WalkExit> BallWalker::end_in_point(
    const WalkedStrip& of, int step, double from,
    const std::array<std::optional<ContactCrossing>, 2>& first) const {
  const DirectedEdge half = end_half(step);
  const int ahead = of.forward ? step : -step;
  const auto point = narrow_end(body_, of.strip, half, options_.tolerance);
  if (!point || ahead * (point->t - from) <= 0) return std::nullopt;
  for (const std::size_t side : {0U, 1U}) {
    if (!first[side] || ahead * (point->t - first[side]->t) <= 0) continue;
    const Vec3 over = vec(of.strip.contacts[contact_at(of, side)].curve->Value(first[side]->t));
    if (distance(over, point_of(body_.vertex(half))) > point->room) return std::nullopt;
  }
  return WalkExit{point->t, {}, true};
}

// Where the ball goes on over another face, or along the next edge of the same faces.
WalkExit BallWalker::exit(WalkedStrip& of, std::size_t place, int step, double from,
                          const std::array<int, 2>& entered) {
  const int ahead = of.forward ? step : -step;
  const auto is_nearer = [&](double a, double b) { return ahead * (a - b) < 0; };
  const auto next = next_place(place, step);
  const bool goes_on_alike = of.of_edge && next && faces_of(*next) == faces_of(place);
  const bool ends_shared = of.of_edge && !next && is_shared(step);
  const double edge_end = ahead > 0 ? of.strip.edge_range.to : of.strip.edge_range.from;
  if (of.of_edge && !next && is_passed(step)) return {edge_end, {}, true};
  bool may_grow_past = true;
  for (;;) {
    std::array<std::optional<ContactCrossing>, 2> first;
    std::optional<std::size_t> side;
    for (const std::size_t k : {0U, 1U}) {
      first[k] = first_crossing(of, k, from, ahead, entered[k]);
      if (first[k] && (!side || is_nearer(first[k]->t, first[*side]->t))) side = k;
    }
    const auto goes_over = [&](std::size_t k) {
      return is_smooth_at(body_, *first[k]) || goes_on_across(of, *first[k], place, step);
    };
    // Of two edges at one place the sharp one ends the strip, whatever is behind the other one.
    if (side && first[1 - *side] && goes_over(*side) && !goes_over(1 - *side) &&
        !is_nearer(first[*side]->t + ahead * same_place(of, first[*side]->t), first[1 - *side]->t))
      side = 1 - *side;
    if (const auto point = next ? std::nullopt : end_in_point(of, step, from, first)) return *point;
    const auto off = off_edge(of, from, ahead);
    if (off && (!side || is_nearer(off->t, first[*side]->t))) return *off;
    if ((goes_on_alike || ends_shared) &&
        (!side || !is_nearer(first[*side]->t, edge_end - ahead * same_place(of, edge_end))))
      return {edge_end, {}, ends_shared};
    if (turns_to_next(of, place, step) && of.strip.range.from <= edge_end &&
        edge_end <= of.strip.range.to &&
        (!side || is_nearer(edge_end + ahead * same_place(of, edge_end), first[*side]->t)))
      return {edge_end, {}, false};
    if (side && holds(of, first[*side]->t, *first[*side]))
      return onto_edge(of, *side, *first[*side], step);
    if (side && !goes_over(*side)) {
      if (may_grow_past && !first[1 - *side] && grow_past(of, first[*side]->t, ahead)) {
        may_grow_past = false;
        continue;
      }
      const WalkExit end{first[*side]->t, {}, true, first[*side]->use->edge};
      return holds_sharp(of, place, step, end, *first[*side])
                 ? onto_edge(of, *side, *first[*side], step)
                 : end;
    }
    if (side) return over_edges(of, *side, *first[*side], first[1 - *side]);
    if (!grow(of, ahead < 0))
      return {ahead > 0 ? of.strip.range.to : of.strip.range.from, {}, true};
  }
}

std::array<int, 2> BallWalker::faces_behind(const WalkedStrip& of, const WalkExit& exit) const {
  std::array<int, 2> faces{};
  for (const std::size_t side : {0U, 1U}) {
    faces[side] = of.strip.contacts[contact_at(of, side)].face;
    if (const auto& over = exit.over[side])
      faces[side] = body_.use(over->use->edge, !over->use->forward).face;
  }
  return faces;
}

// The next place of the run whose edge has these faces.
std::optional<std::size_t> BallWalker::place_with(const std::array<int, 2>& faces,
                                                  std::size_t place, int step) const {
  auto next = next_place(place, step);
  for (std::size_t i = 0; next && i < run_.edges.size(); ++i) {
    if (faces_of(*next) == faces) return next;
    next = next_place(*next, step);
  }
  return std::nullopt;
}

// A contact at an exit, in the face behind it.
Vec2 BallWalker::chart_behind(const WalkedStrip& of, const WalkExit& exit, std::size_t side) const {
  const auto& over = exit.over[side];
  if (!over) {
    const gp_Pnt2d uv = of.strip.contacts[contact_at(of, side)].chart->Value(exit.t);
    return {uv.X(), uv.Y()};
  }
  const EdgeUseInFace& use = body_.use(over->use->edge, !over->use->forward);
  const Vec2 chart = point_at(use.coedge->curve, over->edge_parameter);
  const Vec2 scale = body_.trims(use.face).scale;
  return {chart[0] / scale[0], chart[1] / scale[1]};
}

WalkedStrip BallWalker::pair_strip(const WalkedStrip& of, const WalkExit& exit,
                                   const std::array<int, 2>& faces, std::size_t place,
                                   bool as_loop) {
  options_.tick();
  gp_Pnt centre;
  gp_Vec rate;
  of.strip.spine->D1(exit.t, centre, rate);
  const double sign = of.forward ? 1 : -1;
  BallPlace ball{faces, {}, vec(centre.XYZ()), sign * unit(vec(rate.XYZ())), as_loop, exit.held};
  for (const std::size_t side : {0U, 1U}) {
    if (exit.held[side] > 0) {
      const gp_Pnt contact = of.strip.contacts[contact_at(of, side)].curve->Value(exit.t);
      ball.held_at[side] = nearest_on_edge(body_, exit.held[side], vec(contact));
      continue;
    }
    ball.charts[side] = chart_behind(of, exit, side);
  }
  const auto profile = profiles_.everywhere();
  if (!profile)
    refuse(FilletFault::End, place,
           "it goes over edges beside it, which only fillets of one radius can", ball.centre);
  return {traced_strip(body_, ball, run_.edges[place].edge, run_.concave, *profile), true, 0,
          false};
}

// Whether a strip goes on where another ends, perhaps further on; t: there. Balls that turn on the
// spot are told apart by a contact.
bool BallWalker::reaches(WalkedStrip& next, const WalkedStrip& of, double end, double reach,
                         double& t) const {
  const auto off = [&] {
    Handle(Geom_Curve) line = next.strip.spine;
    Vec3 place = vec(of.strip.spine->Value(end).XYZ());
    for (const std::size_t side : {0U, 1U}) {
      if (line->DN(next.strip.range.from, 1).Magnitude() > 0) break;
      line = next.strip.contacts[contact_at(next, side)].curve;
      place = vec(of.strip.contacts[contact_at(of, side)].curve->Value(end));
    }
    t = nearest_on(line, next.strip.range, place);
    return distance(vec(line->Value(t).XYZ()), place);
  };
  // Short of its end it is not known how near it would come further on.
  const auto is_short = [&] { return t == next.strip.range.from || t == next.strip.range.to; };
  double least = off();
  while (least > (is_short() ? 0 : reach) && grow(next, t < at(next.strip.range, 0.5)))
    least = off();
  return least <= reach;
}

// Where the run goes over a vertex of an edge, ahead of a place.
std::optional<RunCut> BallWalker::joint_at(int edge, std::size_t place, int step) const {
  const auto next = next_place(place, step);
  if (edge == 0 || !next || !profiles_.everywhere() || run_.edges.size() < 2) return std::nullopt;
  const RunEdge& last = run_.edges[place];
  const TopoDS_Vertex joint = body_.vertex({last.edge, last.forward != (step > 0)});
  for (const bool at_start : {true, false})
    if (body_.vertex({edge, at_start}).IsSame(joint))
      return step > 0 ? RunCut{place, *next} : RunCut{*next, place};
  return std::nullopt;
}

// Where the ball cannot go on along the next edge of a run, nor along those behind it beside which
// there is none, but along a later one.
//
// why   it cannot
std::optional<RunCut> BallWalker::passing(std::size_t place, int step, const FilletRefusal& why) {
  if (why.fault != FilletFault::Pinch && why.fault != FilletFault::NoBall) return std::nullopt;
  std::vector<PassedEdge> passed;
  auto next = next_place(place, step);
  while (next && *next != place && (passed.empty() || !strip_if_any(*next))) {
    passed.push_back({run_.edges[*next].edge, why});
    next = next_place(*next, step);
  }
  if (!next || *next == place) return std::nullopt;
  return step > 0 ? RunCut{place, *next, passed} : RunCut{*next, place, passed};
}

// The strip that follows and where it begins.
std::pair<WalkedStrip, double> BallWalker::following(const WalkedStrip& of, const WalkExit& exit,
                                                     std::size_t& place, int step) {
  const std::array<int, 2> faces = faces_behind(of, exit);
  const Vec3 centre = vec(of.strip.spine->Value(exit.t).XYZ());
  if (faces[0] == faces[1])
    refuse(
        FilletFault::End, place,
        "the edge becomes nearly smooth at its end, and the strip, which narrows, does not come to "
        "a point in the vertex",
        centre);
  const double reach = reach_at(of, exit);
  double t = 0;
  if (run_.closed && is_start(faces, exit.held)) {
    WalkedStrip known = *behind_;
    came_back_ = reaches(known, of, exit.t, reach, t);
    if (came_back_) return {std::move(known), t};
  }
  const bool leans = exit.held != std::array<int, 2>{};
  // What is guided and crosses no edge goes on beside the next one of the run, whatever its faces.
  const bool turns = is_guided() && !exit.over[0] && !exit.over[1];
  // Radii by a law are those of the next edge from the plane across its vertex on.
  const auto there = leans || turns || is_before_next(of, place, step, exit.t)
                         ? std::nullopt
                         : place_with(faces, place, step);
  if (there) {
    auto known = strip_if_any(*there);
    if (known && !known->strip.closed && reaches(*known, of, exit.t, reach, t)) {
      place = *there;
      return {*std::move(known), t};
    }
  }
  if (is_guided()) return guided_following(of, exit, faces, place, step);
  WalkedStrip made = pair_strip(of, exit, faces, there.value_or(place));
  if (!made.strip.closed && reaches(made, of, exit.t, reach, t)) return {std::move(made), t};
  refuse(FilletFault::Corner, place, "the ball does not go on over an edge beside it", centre);
}

// The same, or nothing where the run is cut as the ball passes the next edges, or where behind the
// last one the ball has rolled on to where there is no room for it: what it came along ends the
// walk then.
std::optional<std::pair<WalkedStrip, double>> BallWalker::following_or_cut(const WalkedStrip& of,
                                                                           const WalkExit& exit,
                                                                           std::size_t& place,
                                                                           int step) {
  try {
    return following(of, exit, place, step);
  } catch (const FilletRefused& refusal) {
    cut_ = passing(place, step, refusal.why());
    const bool no_room =
        refusal.why().fault == FilletFault::NoBall || refusal.why().fault == FilletFault::Pinch;
    if (!cut_ && !(no_room && is_past_run(of, exit, place, step))) throw;
    return std::nullopt;
  }
}

// All strips that follow, and how they are joined; a closed run ends with the strip it started
// from.
BallWalker::Part BallWalker::way(WalkedStrip& from, std::size_t place, int step) {
  Part part;
  WalkedStrip* of = &from;
  const std::size_t first = place;
  double t = from.inside;
  std::array<int, 2> entered{};
  for (std::size_t count = 0; count < kMaxFacesInARow * (run_.edges.size() + 1); ++count) {
    const WalkExit found = exit(*of, place, step, t, entered);
    if (of->of_edge) made_[place]->strip = of->strip;
    if (!is_shared(step) && (found.sharp_edge > 0 || !found.ends))
      check_course(*of, step, {t, found.t});
    if (found.ends) {
      if (of->of_edge) cut_ = joint_at(found.sharp_edge, place, step);
      if (!cut_) check_end(*of, place, step, found);
      return part;
    }
    auto next = following_or_cut(*of, found, place, step);
    if (!next) return part;
    for (const std::size_t side : {0U, 1U})
      entered[side] = found.over[side] ? found.over[side]->use->edge : held_by(*of)[side];
    t = next->first.inside = next->second;
    part.emplace_back(WalkJoint{found.t, t, found.over}, std::move(next->first));
    of = &part.back().second;
    if (run_.closed && (behind_ ? came_back_ : of->of_edge && place == first)) return part;
  }
  refuse(FilletFault::LeavesFace, place, "the ball does not come to the end of the edges",
         vec(of->strip.spine->Value(t).XYZ()));
}

// A strip that comes back to where it began; only as long as the ball rolls round in it.
BallWalk BallWalker::round(WalkedStrip strip) const {
  const auto beside = [&](std::size_t place) {
    if (strip.of_edge && strip.strip.edge == run_.edges[place].edge) return true;
    auto faces = faces_of(place);
    std::ranges::sort(faces);
    std::array own{strip.strip.contacts[0].face, strip.strip.contacts[1].face};
    std::ranges::sort(own);
    return faces == own;
  };
  for (std::size_t i = 0; i < run_.edges.size() && !behind_; ++i)
    if (!run_.closed || !beside(i))
      refuse(FilletFault::End, i, "the ball rolls round both faces, not only along the edge",
             vec(strip.strip.spine->Value(strip.inside).XYZ()));
  const Interval range =
      strip.forward ? strip.strip.range : Interval{strip.strip.range.to, strip.strip.range.from};
  BallWalk walk{run_, {}, {{range.to, range.from, {}}}};
  walk.strips.push_back(std::move(strip));
  return walk;
}

BallWalk BallWalker::walk() {
  const std::size_t place = start();
  WalkedStrip first = strip_at(place);
  if (!goes_beside(first)) behind_ = start_behind(place);
  if (behind_) first = *behind_;
  if (first.strip.closed) return round(std::move(first));
  BallWalk walk{run_, {}, {}};
  Part ahead = way(first, place, 1);
  if (cut_) return walk;
  Part back;
  if (run_.closed) {
    // The last of them is the first strip again.
    const Interval a = first.strip.range, b = ahead.back().second.strip.range;
    if (first.strip.over)
      first.strip = first.strip.over({std::min(a.from, b.from), std::max(a.to, b.to)});
  } else {
    back = way(first, place, -1);
    if (cut_) return walk;
  }
  for (auto it = back.rbegin(); it != back.rend(); ++it) {
    walk.strips.push_back(std::move(it->second));
    walk.joints.push_back({it->first.after, it->first.before, it->first.over});
  }
  walk.strips.push_back(std::move(first));
  for (auto& [joint, strip] : ahead) {
    walk.joints.push_back(joint);
    walk.strips.push_back(std::move(strip));
  }
  if (run_.closed) walk.strips.pop_back();
  return walk;
}

}  // namespace blossom::occt
