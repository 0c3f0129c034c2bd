// SPDX-License-Identifier: LGPL-2.1-or-later
// The first two steps: where cuts, wires and other cuts meet. What faces tell each other
// between them is in face_stops.cpp, the last one in face_pieces.cpp.
#include "adapters/occt/splitting/face_splitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/splitting/limits.h"
#include "core/base/sampled_margin.h"
#include "core/base/unbounded.h"
#include "core/plane/cut_crossings.h"

namespace blossom::occt {
namespace {

constexpr const char* kDividing = "dividing faces";
// A cut that stops short of a wire would have met it at most so many times farther along the wire.
constexpr double kObliqueness = 8;
// Neighbours that see a crossing farther apart, in tolerances of the edge, see two.
constexpr double kMaxDisagreement = 256;

// It stays within `reach` of a point there.
bool keeps_near(const PlanarCurve& curve, const Vec2& point, double s, double t, double reach) {
  return std::ranges::all_of(std::array{s, 0.5 * (s + t), t}, [&](double at) {
    return distance(point, point_at(curve, at)) <= reach;
  });
}

// Loops that touch in a vertex have a corner each there; one stands for all, so that what ends in
// the vertex meets them all. Not at edges that the face uses twice: their two sides lie in one
// place and stay apart by their corners alone.
void join_corners(FaceTrims& trims, double tolerance) {
  std::vector<int> vertices(trims.corners.size());
  std::vector<bool> apart(trims.corners.size());
  std::set<int> edges;
  for (auto& loop : trims.loops)
    for (const Coedge& of : loop) {
      const bool twice = !edges.insert(of.edge).second;
      if (twice)
        apart[static_cast<std::size_t>(of.from)] = apart[static_cast<std::size_t>(of.to)] = true;
      vertices[static_cast<std::size_t>(of.from)] = of.start;
    }
  std::vector<int> kept(trims.corners.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i] = static_cast<int>(i);
    for (std::size_t k = 0; k < i && !apart[i]; ++k)
      if (!apart[k] && vertices[k] == vertices[i] &&
          distance(trims.corners[k], trims.corners[i]) <= tolerance) {
        kept[i] = kept[k];
        break;
      }
  }
  for (auto& loop : trims.loops)
    for (Coedge& of : loop) {
      of.from = kept[static_cast<std::size_t>(of.from)];
      of.to = kept[static_cast<std::size_t>(of.to)];
    }
}

// The place of a curve that is nearest to a point, and how far that is from the curve if it went on
// straight beyond its ends: what touches an edge may end before a vertex that it leads to.
PlanarFoot nearest_of_line(const PlanarCurve& curve, const Vec2& point) {
  PlanarFoot foot = nearest(curve, point);
  const Interval domain = curve.domain();
  if (foot.parameter != domain.from && foot.parameter != domain.to) return foot;
  const PlanarJet end = jet_at(curve, foot.parameter);
  const Vec2 beyond = point - end.point;
  const Vec2 out = unit(end.first) * (foot.parameter == domain.to ? 1.0 : -1.0);
  if (dot(beyond, out) > 0) foot.distance = std::abs(cross(beyond, out));
  return foot;
}

}  // namespace

bool FaceSplitter::is_near(const PlanarCurve& curve, double s, double t, double reach) {
  const Vec2 point = point_at(curve, s);
  return distance(point, point_at(curve, t)) <= reach &&
         distance(point, point_at(curve, 0.5 * (s + t))) <= reach;
}

FaceSplitter::FaceSplitter(const TopoDS_Face& face, std::vector<FaceCut> cuts, EdgeSplits& splits,
                           double tolerance, const WorkLimit* limit)
    : given_(face),
      face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))),
      trims_(face_trims(face)),
      shapes_(trim_shapes(face)),
      cuts_(std::move(cuts)),
      splits_(splits),
      tolerance_(tolerance),
      limit_(limit) {
  join_corners(trims_, tolerance_);
  for (const Vec2& corner : trims_.corners) vertices_.push_back({corner, -1, -1, -1});
  for (std::size_t loop = 0; loop < trims_.loops.size(); ++loop)
    for (std::size_t i = 0; i < trims_.loops[loop].size(); ++i) {
      const Coedge& of = trims_.loops[loop][i];
      Vertex& start = vertices_[static_cast<std::size_t>(of.from)];
      start.loop = static_cast<int>(loop);
      start.coedge = static_cast<int>(i);
      start.split = of.reversed ? EdgeSplits::kLast : EdgeSplits::kFirst;
    }
  add_lifted_cuts();
  for (LiftedCut& lifted_cut : lifted_cuts_) add_wire_stops(lifted_cut);
}

// By now all faces have said where cuts cross the edges that they share: what touches an edge
// beside such a place meets it there.
void FaceSplitter::settle() {
  for (LiftedCut& lifted_cut : lifted_cuts_)
    for (const TrimMeeting& touch : lifted_cut.touches) add_wire_stop(lifted_cut, touch);
  for (LiftedCut& lifted_cut : lifted_cuts_) {
    add_end_stop(lifted_cut, lifted_cut.curve.domain().from);
    add_end_stop(lifted_cut, lifted_cut.curve.domain().to);
  }
  add_crossings();
  for (LiftedCut& lifted_cut : lifted_cuts_) finish_stops(lifted_cut);
}

const Coedge& FaceSplitter::coedge(int loop, int index) const {
  const auto place = static_cast<std::size_t>(index);
  if (loop == inner_loop()) return trims_.inner[place];
  return trims_.loops[static_cast<std::size_t>(loop)][place];
}

double FaceSplitter::reach(const LiftedCut& lifted_cut) const {
  return std::max(tolerance_, cuts_[static_cast<std::size_t>(lifted_cut.cut)].tolerance);
}

void FaceSplitter::note(int cut, const std::string& what) {
  const std::string text = "cut " + std::to_string(cut + 1) + " " + what;
  if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
}

void FaceSplitter::add_lifted_cuts() {
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    const PlanarCurve curve = chart_of(cuts_[i]);
    for (const Vec2& shift : period_shifts(trims_, curve))
      lifted_cuts_.push_back(
          {static_cast<int>(i), shift, transformed(curve, {1, 1}, shift), {}, {}, {}, {}});
  }
}

int FaceSplitter::vertex_at_split(int loop, int index, int split) {
  if (loop == inner_loop()) return inner_vertex(index, split);
  const Coedge& of = coedge(loop, index);
  if (split == EdgeSplits::kFirst) return of.reversed ? of.to : of.from;
  if (split == EdgeSplits::kLast) return of.reversed ? of.from : of.to;
  const auto known = std::find_if(vertices_.begin(), vertices_.end(), [&](const Vertex& vertex) {
    return vertex.loop == loop && vertex.coedge == index && vertex.split == split;
  });
  if (known != vertices_.end()) return static_cast<int>(known - vertices_.begin());
  const Vec2 point = point_at(of.curve, splits_.parameter(edge_of(of), split));
  vertices_.push_back({point, loop, index, split});
  return static_cast<int>(vertices_.size()) - 1;
}

int FaceSplitter::vertex_of(const TrimMeeting& meeting, double uncertainty, double inverse_sine) {
  const Coedge& of = coedge(meeting.loop, meeting.coedge);
  return vertex_at_split(
      meeting.loop, meeting.coedge,
      splits_.add(edge_of(of), meeting.edge_parameter, face_, uncertainty, inverse_sine));
}

// The vertex of a touch is to cover the places in which cut and edge cross beside it.
void FaceSplitter::widen_touch(const LiftedCut& lifted_cut, const TrimMeeting& meeting,
                               int vertex) {
  if (meeting.touch.from == meeting.touch.to) return;
  const Vertex& at = vertices_[static_cast<std::size_t>(vertex)];
  const Spline& curve = cuts_[static_cast<std::size_t>(lifted_cut.cut)].curve;
  const Vec3 point = point_at(curve, meeting.at);
  const double reach = std::max(distance(point, point_at(curve, meeting.touch.from)),
                                distance(point, point_at(curve, meeting.touch.to)));
  splits_.widen(edge_of(coedge(at.loop, at.coedge)), at.split, kSampledMargin * reach);
}

// How many times farther along the wire than across it neighbours may see the same crossing: where
// an edge is off by its tolerance, a surface that it meets at an angle alpha is met farther by
// 1 / sin alpha, and sin alpha = sin (cut, edge) sin (face, what cuts it).
double FaceSplitter::inverse_sine(const LiftedCut& lifted_cut, const TrimMeeting& meeting) const {
  const Vec2 along = jet_at(lifted_cut.curve, meeting.at).first;
  const Coedge& of = coedge(meeting.loop, meeting.coedge);
  const Vec2 wire = jet_at(of.curve, meeting.edge_parameter).first;
  const double size = norm(along) * norm(wire);
  const double sine =
      std::abs(cross(along, wire)) * cuts_[static_cast<std::size_t>(lifted_cut.cut)].least_sine;
  return sine * kMaxDisagreement > size ? std::max(1.0, size / sine) : kMaxDisagreement;
}

// A cut that keeps to an edge, as far as the two faces can tell, from a vertex known on it to a
// meeting beside that, meets it in the vertex alone; from what a face asked for, within tolerance.
bool FaceSplitter::add_known_stop(LiftedCut& lifted_cut, const TrimMeeting& meeting) {
  const Coedge& of = coedge(meeting.loop, meeting.coedge);
  if (of.degenerated) return false;
  const double least_sine = cuts_[static_cast<std::size_t>(lifted_cut.cut)].least_sine;
  const double allowed = reach(lifted_cut) / std::max(least_sine, 1 / kMaxDisagreement);
  const Vec2 met = point_at(lifted_cut.curve, meeting.at);
  std::optional<PlanarFoot> best;
  int known = -1;
  for (int split = 0; split < splits_.count(edge_of(of)); ++split) {
    const bool is_known = splits_.is_known(edge_of(of), split);
    const double most = is_known ? allowed : reach(lifted_cut);
    const Vec2 point = point_at(of.curve, splits_.parameter(edge_of(of), split));
    const double length = distance(point, met);
    if (length > wire_touch_length(trims_, reach(lifted_cut))) continue;
    const PlanarFoot foot = nearest_of_line(lifted_cut.curve, point);
    if (foot.distance > (is_known ? std::max(most, kLiesReach * reach(lifted_cut)) : most))
      continue;
    const bool keeps = std::ranges::all_of(std::array{0.0, 0.25, 0.5, 0.75}, [&](double part) {
      const double there =
          on_the_way(lifted_cut.curve, foot.parameter, meeting.at, part, reach(lifted_cut));
      return nearest(of.curve, point_at(lifted_cut.curve, there)).distance <= most;
    });
    if (!keeps || (best && distance(met, point_at(lifted_cut.curve, best->parameter)) <= length))
      continue;
    best = foot;
    known = split;
  }
  if (!best) return false;
  const int vertex = vertex_at_split(meeting.loop, meeting.coedge, known);
  lifted_cut.stops.emplace_back(best->parameter, vertex);
  const Interval domain = lifted_cut.curve.domain();
  if (meeting.at == domain.from || meeting.at == domain.to) {  // no loose end stays there
    lifted_cut.stops.emplace_back(meeting.at, vertex);
    Vertex& at = vertices_[static_cast<std::size_t>(vertex)];
    at.uncertainty = std::max(at.uncertainty, kSampledMargin * distance(at.point, met));
  }
  const gp_Pnt place = BRep_Tool::Pnt(splits_.vertex(edge_of(of), known));
  double moved = 0;
  for (const double t : {meeting.at, meeting.touch.from, meeting.touch.to}) {
    const Vec3 from = point_at(cuts_[static_cast<std::size_t>(lifted_cut.cut)].curve, t);
    moved = std::max(moved, distance(from, Vec3{place.X(), place.Y(), place.Z()}));
  }
  if (moved > reach(lifted_cut)) splits_.widen(edge_of(of), known, kSampledMargin * moved);
  return true;
}

void FaceSplitter::add_wire_stop(LiftedCut& lifted_cut, const TrimMeeting& meeting) {
  if (add_known_stop(lifted_cut, meeting)) return;
  const int vertex = vertex_of(meeting, 0, inverse_sine(lifted_cut, meeting));
  lifted_cut.stops.emplace_back(meeting.at, vertex);
  widen_touch(lifted_cut, meeting, vertex);
}

void FaceSplitter::add_wire_stops(LiftedCut& lifted_cut) {
  check_limit(limit_, kDividing);
  ClippedCurve found = clipped(trims_, lifted_cut.curve, reach(lifted_cut));
  for (const TrimMeeting& meeting : found.meetings)
    if (inverse_sine(lifted_cut, meeting) < kMaxDisagreement)
      add_wire_stop(lifted_cut, meeting);
    else
      lifted_cut.touches.push_back(meeting);
  lifted_cut.runs = std::move(found.runs);
  if (!found.complete)
    note(lifted_cut.cut, "runs so close to an edge that not all crossings are sure");
  add_inner_stops(lifted_cut);
}

// A cut may stop at the natural border of the surface while the wire leaves it, by as much as both
// tolerances allow, or because the surface goes on there; its end is taken to the wire.
void FaceSplitter::add_end_stop(LiftedCut& lifted_cut, double end) {
  if (has_stop(lifted_cut, end)) return;
  const Vec2 point = point_at(lifted_cut.curve, end);
  TrimMeeting nearest_meeting;
  double least = kInfinity;
  for (std::size_t loop = 0; loop < trims_.loops.size(); ++loop)
    for (std::size_t i = 0; i < trims_.loops[loop].size(); ++i) {
      const Coedge& of = trims_.loops[loop][i];
      const PlanarFoot foot = nearest(of.curve, point);
      const double allowed = std::max(BRep_Tool::Tolerance(edge_of(of)) + reach(lifted_cut),
                                      kSampledMargin * trims_.overshoot);
      if (foot.distance >= least || foot.distance > allowed) continue;
      least = foot.distance;
      nearest_meeting = {
          end, static_cast<int>(loop), static_cast<int>(i), foot.parameter, {end, end}};
    }
  if (std::isfinite(least) && !add_known_stop(lifted_cut, nearest_meeting))
    lifted_cut.stops.emplace_back(end, vertex_of(nearest_meeting, kObliqueness * least,
                                                 inverse_sine(lifted_cut, nearest_meeting)));
}

// Whether a stop is known that is this place of the curve but for the tolerance.
bool FaceSplitter::has_stop(const LiftedCut& lifted_cut, double at) const {
  return std::any_of(lifted_cut.stops.begin(), lifted_cut.stops.end(), [&](const auto& stop) {
    return is_near(lifted_cut.curve, stop.first, at, 8 * reach(lifted_cut));
  });
}

// The vertex within tolerance of the point, or a new node. Borders come first, so that a node of
// two cuts that end in one edge is the split of that edge.
int FaceSplitter::node_near(const Vec2& point, double reach) {
  int nearest = -1;
  double least = std::max(4 * tolerance_, reach);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const double gap = distance(vertices_[i].point, point);
    if (gap <= least) {
      least = gap;
      nearest = static_cast<int>(i);
    }
  }
  if (nearest >= 0) return nearest;
  vertices_.push_back({point, -1, -1, -1});
  return static_cast<int>(vertices_.size()) - 1;
}

// Whether a cut is in the node in which it ends, at a parameter and on the way from there. What
// ends on a wire ends in a place of that.
bool FaceSplitter::is_in_end_node(const LiftedCut& lifted_cut, double at) const {
  const FaceCut& cut = cuts_[static_cast<std::size_t>(lifted_cut.cut)];
  const Interval domain = lifted_cut.curve.domain();
  for (const bool last : {false, true}) {
    const double end = last ? domain.to : domain.from;
    if (is_near(lifted_cut.curve, end, at, cut.node_reach[last]) && !has_stop(lifted_cut, end))
      return true;
  }
  return false;
}

// Inside of a node in which both end cuts are known to be near each other, and no more: how often
// they cross there is by chance.
void FaceSplitter::add_crossings() {
  for (std::size_t i = 0; i < lifted_cuts_.size(); ++i)
    for (std::size_t k = i + 1; k < lifted_cuts_.size(); ++k) {
      LiftedCut &a = lifted_cuts_[i], &b = lifted_cuts_[k];
      const double widest = std::max(reach(a), reach(b));
      if (are_disjoint(box_of(a.curve), box_of(b.curve), widest)) continue;
      check_limit(limit_, kDividing);
      const CutCrossings common =
          cut_crossings(a.curve, b.curve, widest, wire_touch_length(trims_, widest));
      for (const CutCrossing& crossing : common.nodes) {
        if (std::ranges::all_of(crossing.a, [&](double t) { return is_in_end_node(a, t); }) &&
            std::ranges::all_of(crossing.b, [&](double t) { return is_in_end_node(b, t); }))
          continue;
        const int node = node_near(crossing.point);
        Vertex& at = vertices_[static_cast<std::size_t>(node)];
        at.uncertainty = std::max(at.uncertainty, crossing.uncertainty);
        const Spline& curve = cuts_[static_cast<std::size_t>(a.cut)].curve;
        for (const double t : crossing.beside)
          at.touch = std::max(
              at.touch,
              kSampledMargin * distance(point_at(curve, crossing.a.front()), point_at(curve, t)));
        for (const double t : crossing.a) a.stops.emplace_back(t, node);
        for (const double t : crossing.b) b.stops.emplace_back(t, node);
      }
      if (!common.complete)
        note(a.cut, "runs so close to another cut that not all branching points are sure");
    }
}

// Adds the ends, sorts, and joins stops at one vertex with next to nothing between them.
void FaceSplitter::finish_stops(LiftedCut& lifted_cut) {
  const Interval domain = lifted_cut.curve.domain();
  for (const bool last : {false, true}) {
    const double end = last ? domain.to : domain.from;
    if (has_stop(lifted_cut, end)) continue;
    const double reach = cuts_[static_cast<std::size_t>(lifted_cut.cut)].node_reach[last];
    const int node = node_near(point_at(lifted_cut.curve, end), reach);
    Vertex& at = vertices_[static_cast<std::size_t>(node)];
    at.uncertainty = std::max(at.uncertainty, reach);
    if (at.split < 0) at.touch = std::max(at.touch, reach);
    lifted_cut.stops.emplace_back(end, node);
  }
  tidy_stops(lifted_cut, 8 * reach(lifted_cut));
}

// Of two stops the one on the other side's border stays, or the one nearer to the vertex: beside it
// the cut has another direction, by which it may seem to lie on the other side of what it crosses.
void FaceSplitter::tidy_stops(LiftedCut& lifted_cut, double reach) const {
  const auto is_met = [&](double at) {
    return std::find(lifted_cut.met.begin(), lifted_cut.met.end(), at) != lifted_cut.met.end();
  };
  std::sort(lifted_cut.stops.begin(), lifted_cut.stops.end());
  std::vector<std::pair<double, int>> stops;
  const auto are_one = [&](const std::pair<double, int>& a, const std::pair<double, int>& b) {
    if (a.second != b.second) return false;
    const Vertex& of = vertices_[static_cast<std::size_t>(a.second)];
    return is_near(lifted_cut.curve, a.first, b.first, std::max(reach, of.uncertainty)) ||
           keeps_near(lifted_cut.curve, of.point, a.first, b.first, of.uncertainty);
  };
  const auto off = [&](const std::pair<double, int>& stop) {
    return distance(point_at(lifted_cut.curve, stop.first),
                    vertices_[static_cast<std::size_t>(stop.second)].point);
  };
  const auto stays = [&](const std::pair<double, int>& kept, const std::pair<double, int>& next) {
    if (is_met(kept.first) != is_met(next.first)) return is_met(kept.first);
    return off(kept) <= off(next);
  };
  for (const auto& stop : lifted_cut.stops) {
    if (stops.empty() || !are_one(stops.back(), stop))
      stops.push_back(stop);
    else if (!stays(stops.back(), stop))
      stops.back() = stop;
  }
  lifted_cut.stops = std::move(stops);
}

}  // namespace blossom::occt
