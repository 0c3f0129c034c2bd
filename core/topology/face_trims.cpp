// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/face_trims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>

#include "core/base/unbounded.h"
#include "core/plane/even_line.h"
#include "core/plane/loops.h"

namespace blossom {
namespace {

constexpr int kMaxHalvings = 6;     // of a wire's span, to see whether it meets a rectangle
constexpr int kPointHalvings = 24;  // likewise a point: pieces are about as long as kOnWire then

// The starts and ends of coedges at one vertex.
struct Meeting {
  int vertex = -1;
  std::vector<Coedge*> starts;
  std::vector<Coedge*> ends;
};

// In the order in which the loops come by.
std::vector<Meeting> meetings(FaceTrims& trims) {
  std::vector<Meeting> all;
  std::map<int, std::size_t> places;
  const auto at_vertex = [&](int vertex) -> Meeting& {
    const auto [known, added] = places.emplace(vertex, all.size());
    return added ? all.emplace_back(Meeting{vertex, {}, {}}) : all[known->second];
  };
  for (auto& loop : trims.loops)
    for (Coedge& coedge : loop) {
      at_vertex(coedge.start).starts.push_back(&coedge);
      at_vertex(coedge.end).ends.push_back(&coedge);
    }
  return all;
}

// Whether places of a chart that one vertex stands for are one corner of it, as those on the sides
// of a seam or round a pole are not. Each is in reach of the vertex in space, where the chart's
// measure is another one than in the chart itself.
bool are_one_corner(const FaceTrims& trims, const Vec2& p, const Vec2& q, double reach) {
  const SurfaceJet jet = trims.jet({p[0] / trims.scale[0], p[1] / trims.scale[1]});
  const Vec2 apart = q - p;
  return norm((apart[0] / trims.scale[0]) * jet.du + (apart[1] / trims.scale[1]) * jet.dv) <=
         2 * reach;
}

// Joins each end to a start, nearest pairs first. Where wires touch in a vertex their corners are
// one point, as they are in space.
void join(Meeting meeting, FaceTrims& trims) {
  const std::size_t first = trims.corners.size();
  double reach = kOnWire;
  if (meeting.vertex >= 0)
    reach = std::max(reach, trims.vertices[static_cast<std::size_t>(meeting.vertex)].tolerance);
  const bool is_pole = std::ranges::any_of(meeting.ends, &Coedge::degenerated) ||
                       std::ranges::any_of(meeting.starts, &Coedge::degenerated);
  while (!meeting.ends.empty()) {
    std::size_t best_end = 0, best_start = 0;
    double nearest_gap = kInfinity;
    for (std::size_t i = 0; i < meeting.ends.size(); ++i)
      for (std::size_t k = 0; k < meeting.starts.size(); ++k) {
        const double gap =
            distance(end_point(*meeting.ends[i], true), end_point(*meeting.starts[k], false));
        if (gap < nearest_gap) {
          nearest_gap = gap;
          best_end = i;
          best_start = k;
        }
      }
    meeting.ends[best_end]->to = meeting.starts[best_start]->from =
        static_cast<int>(trims.corners.size());
    const Vec2 corner = end_point(*meeting.ends[best_end], true);
    const auto same = std::find_if(trims.corners.begin() + static_cast<std::ptrdiff_t>(first),
                                   trims.corners.end(), [&](const Vec2& p) {
                                     return is_pole ? distance(p, corner) <= reach
                                                    : are_one_corner(trims, p, corner, reach);
                                   });
    trims.corners.push_back(same == trims.corners.end() ? corner : *same);
    trims.largest_gap = std::max(trims.largest_gap, nearest_gap);
    meeting.ends.erase(meeting.ends.begin() + static_cast<std::ptrdiff_t>(best_end));
    meeting.starts.erase(meeting.starts.begin() + static_cast<std::ptrdiff_t>(best_start));
  }
}

void set_curve(Coedge& coedge, PlanarCurve curve) {
  coedge.curve = std::move(curve);
  coedge.boxes.clear();
  coedge.joints.clear();
  const auto first = [](const PlanarSpan& of) { return projected(of.curve.points.front()); };
  const auto last = [](const PlanarSpan& of) { return projected(of.curve.points.back()); };
  const std::vector<PlanarSpan>& spans = coedge.curve.spans;
  for (std::size_t k = 0; k < spans.size(); ++k) {
    coedge.boxes.push_back(box_of(spans[k].curve.points));
    if (k > 0 && last(spans[k - 1]) != first(spans[k]))
      coedge.joints.push_back({last(spans[k - 1]), first(spans[k])});
  }
  coedge.ends = {first(spans.front()), last(spans.back())};
}

double past(const PlanarBox& box, const PlanarBox& bounds) {
  double most = 0;
  for (int k = 0; k < 2; ++k)
    most = std::max({most, bounds.low[k] - box.low[k], box.high[k] - bounds.high[k]});
  return most;
}

// How far a piece goes past the bounds, at most kOnWire too much. Its control points may go far
// beyond the piece, so it is halved as long as they tell of more than its ends.
double farthest_past(const PlanarBezier& piece, const PlanarBox& bounds, double known,
                     int halvings) {
  const double most = past(box_of(piece.points), bounds);
  for (const Vec3& end : {piece.points.front(), piece.points.back()})
    known = std::max(known, past(box_of(std::span<const Vec3>(&end, 1)), bounds));
  if (most <= known + kOnWire || halvings == 0) return std::max(most, known);
  for (const Interval& half : {Interval{0, 0.5}, Interval{0.5, 1}})
    known = farthest_past(bezier_piece(piece, half), bounds, known, halvings - 1);
  return known;
}

double overshoot(PlanarBox bounds, const FaceTrims& trims) {
  for (int k = 0; k < 2; ++k) {
    const bool periodic = trims.period[k] > 0;
    bounds.low[k] = periodic ? -kInfinity : trims.scale[k] * bounds.low[k];
    bounds.high[k] = periodic ? kInfinity : trims.scale[k] * bounds.high[k];
  }
  double most = 0;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop)
      for (const auto& span : coedge.curve.spans)
        most = farthest_past(span.curve, bounds, most, kPointHalvings);
  return most;
}

bool lies_on_border(const PlanarCurve& curve, const PlanarBox& box) {
  const PlanarBox own = box_of(curve);
  for (int k = 0; k < 2; ++k) {
    const double error = kNaturalError * (box.high[k] - box.low[k]);
    if (own.high[k] <= box.low[k] + error || own.low[k] >= box.high[k] - error) return true;
  }
  return false;
}

bool is_natural(const FaceTrims& trims) {
  return trims.loops.size() == 1 &&
         std::all_of(trims.loops.front().begin(), trims.loops.front().end(),
                     [&](const Coedge& coedge) { return lies_on_border(coedge.curve, trims.box); });
}

// Of a straight piece whose box meets the other one: whether that is all on one side of its line.
bool lies_beside(const PlanarBezier& line, const PlanarBox& box) {
  const auto end = [&](std::size_t i) {
    const Vec3& p = line.points[i];
    return Vec2{p[0] / p[2], p[1] / p[2]};
  };
  const Vec2 from = end(0), along = end(1) - from, half = 0.5 * (box.high - box.low);
  const double reach = std::abs(along[0]) * half[1] + std::abs(along[1]) * half[0];
  return std::abs(cross(along, box.low + half - from)) > reach;
}

bool may_meet(const PlanarBezier& piece, const PlanarBox& box, int halvings) {
  if (are_disjoint(box_of(piece.points), box)) return false;
  if (piece.degree() == 1) return !lies_beside(piece, box);
  if (holds(box, projected(piece.points.front())) || holds(box, projected(piece.points.back())))
    return true;
  return halvings == 0 || may_meet(bezier_piece(piece, {0, 0.5}), box, halvings - 1) ||
         may_meet(bezier_piece(piece, {0.5, 1}), box, halvings - 1);
}

PlanarBox grown(const PlanarBox& box, double margin) {
  return {box.low - Vec2{margin, margin}, box.high + Vec2{margin, margin}};
}

// Shifts by whole periods.
std::vector<double> turns(double period) {
  if (period > 0) return {0, period, -period};
  return {0};
}

// Whether the ray from a point to the right may meet what is in a box.
bool may_cross(const PlanarBox& box, const Vec2& point) {
  return box.low[1] <= point[1] && point[1] <= box.high[1] && point[0] <= box.high[0];
}

// What lies within an edge's tolerance of its wire, or in a gap between coedges, is on the wire.
PartSide side_of(const FaceTrims& trims, const PlanarBox& box) {
  const int halvings = box.low == box.high ? kPointHalvings : kMaxHalvings;
  if (coedge_near(trims, box, kOnWire + trims.largest_gap, halvings) != nullptr)
    return PartSide::Mixed;
  return is_inside(trims, 0.5 * (box.low + box.high)) ? PartSide::Inside : PartSide::Outside;
}

}  // namespace

const Coedge* coedge_near(const FaceTrims& trims, const PlanarBox& box, double margin, int halvings,
                          Wires wires) {
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      const double loose = wires == Wires::WithTolerances ? coedge.tolerance : 0;
      const PlanarBox near = grown(box, margin + loose);
      for (std::size_t k = 0; k < coedge.boxes.size(); ++k)
        if (!are_disjoint(coedge.boxes[k], near) &&
            may_meet(coedge.curve.spans[k].curve, near, halvings))
          return &coedge;
    }
  return nullptr;
}

const Coedge* coedge_at(const FaceTrims& trims, const Vec2& point, Wires wires) {
  return coedge_near(trims, {point, point}, kOnWire, kPointHalvings, wires);
}

std::optional<FaceTrims> trims_of(const SurfaceChart& chart, std::vector<FaceVertex> vertices,
                                  std::vector<std::vector<Coedge>> loops,
                                  std::vector<Coedge> inner) {
  FaceTrims trims;
  trims.loops = std::move(loops);
  trims.inner = std::move(inner);
  trims.vertices = std::move(vertices);
  trims.jet = chart.jet;
  trims.scale = chart.scale;
  trims.period = {chart.period[0] * trims.scale[0], chart.period[1] * trims.scale[1]};
  for (auto& loop : trims.loops)
    for (Coedge& coedge : loop)
      set_curve(coedge, transformed(std::move(coedge.curve), trims.scale, {}));
  for (Coedge& coedge : trims.inner)
    set_curve(coedge, transformed(std::move(coedge.curve), trims.scale, {}));
  for (Meeting& meeting : meetings(trims)) {
    if (meeting.starts.size() != meeting.ends.size()) return std::nullopt;
    join(std::move(meeting), trims);
  }
  trims.box = box_of(trims.loops);
  trims.overshoot = overshoot(chart.bounds, trims);
  trims.natural = is_natural(trims);
  return trims;
}

PlanarBox box_of(const std::vector<std::vector<Coedge>>& loops) {
  PlanarBox box = box_of(loops.front().front().curve);
  for (const auto& loop : loops)
    for (const Coedge& coedge : loop) box = united(box, box_of(coedge.curve));
  return box;
}

Vec2 end_point(const Coedge& coedge, bool last) {
  return coedge.ends[last != coedge.reversed ? 1 : 0];
}

PlanarCurve chart_curve(const FaceTrims& trims, const Spline2& chart) {
  return transformed(simplest_curve(chart), trims.scale, {});
}

bool is_covered(const FaceTrims& trims, const std::vector<Coedge>& loop, double least) {
  double area = 0, covered = 0;
  for (const Coedge& coedge : loop) {
    const double sign = coedge.reversed ? -1 : 1, width = std::max(least, coedge.tolerance);
    for (const PlanarSpan& span : coedge.curve.spans) {
      const auto& points = span.curve.points;
      area += sign * area_along(PlanarPath{span.curve}, trims.corners.front());
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        covered += width * distance(projected(points[i]), projected(points[i + 1]));
    }
  }
  return std::abs(area) <= covered;
}

std::vector<Vec2> period_shifts(const FaceTrims& trims, const PlanarCurve& curve) {
  const PlanarBox box = box_of(curve);
  std::array<std::vector<double>, 2> moves;
  for (int k = 0; k < 2; ++k) {
    auto& along = moves[static_cast<std::size_t>(k)];
    // A move that only touches the box would give the other side of a seam a second time.
    const auto reaches = [&](double move, double margin) {
      return box.low[k] + move <= trims.box.high[k] + margin &&
             box.high[k] + move >= trims.box.low[k] - margin;
    };
    if (reaches(0, kOnWire)) along.push_back(0);
    for (int turn = -2; trims.period[k] > 0 && turn <= 2; ++turn)
      if (turn != 0 && reaches(turn * trims.period[k], -kOnWire))
        along.push_back(turn * trims.period[k]);
  }
  std::vector<Vec2> shifts;
  for (const double u : moves[0])
    for (const double v : moves[1]) shifts.push_back({u, v});
  return shifts;
}

std::array<std::array<Vec2, 2>, 2> closing_chords(const FaceTrims& trims, const Coedge& coedge) {
  const auto corner = [&](int i) { return trims.corners[static_cast<std::size_t>(i)]; };
  return {{{corner(coedge.from), end_point(coedge, false)},
           {end_point(coedge, true), corner(coedge.to)}}};
}

bool is_inside(const FaceTrims& trims, const Vec2& point) {
  for (int k = 0; k < 2; ++k)
    if (point[k] < trims.box.low[k] || point[k] > trims.box.high[k]) return false;
  if (trims.natural) return true;
  int winding = 0;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      const int sign = coedge.reversed ? -1 : 1;
      for (std::size_t k = 0; k < coedge.boxes.size(); ++k)
        if (may_cross(coedge.boxes[k], point))
          winding += sign * ray_crossings(PlanarPath{coedge.curve.spans[k].curve}, point);
      for (const auto& [from, to] : coedge.joints) winding += sign * ray_crossings(from, to, point);
      for (const auto& [from, to] : closing_chords(trims, coedge))
        winding += ray_crossings(from, to, point);
    }
  return winding > 0;
}

PartSide part_side(const FaceTrims& trims, const Interval& u, const Interval& v) {
  const PlanarBox box{{u.from * trims.scale[0], v.from * trims.scale[1]},
                      {u.to * trims.scale[0], v.to * trims.scale[1]}};
  for (const double turn_u : turns(trims.period[0]))
    for (const double turn_v : turns(trims.period[1])) {
      const PlanarBox moved{{box.low[0] + turn_u, box.low[1] + turn_v},
                            {box.high[0] + turn_u, box.high[1] + turn_v}};
      const PartSide side = side_of(trims, moved);
      if (side != PartSide::Outside) return side;
    }
  return PartSide::Outside;
}

bool is_inside_by_periods(const FaceTrims& trims, const Vec2& uv) {
  // The first place in the box of the trims or past it, and the way on to the next one.
  Vec2 first{uv[0] * trims.scale[0], uv[1] * trims.scale[1]}, step;
  for (int k = 0; k < 2; ++k) {
    const double period = trims.period[k];
    if (period > 0) first[k] += std::ceil((trims.box.low[k] - first[k]) / period) * period;
    step[k] = period > 0 ? period : kInfinity;
  }
  for (double u = first[0]; u <= trims.box.high[0]; u += step[0])
    for (double v = first[1]; v <= trims.box.high[1]; v += step[1])
      if (is_inside(trims, {u, v})) return true;
  return false;
}

std::optional<WirePlace> wire_near(const FaceTrims& trims, const Vec2& uv, double reach) {
  const Vec2 point{uv[0] * trims.scale[0], uv[1] * trims.scale[1]};
  std::optional<WirePlace> found;
  const auto look_at = [&](const Coedge& coedge, const Vec2& moved) {
    const double most = reach + coedge.tolerance;
    const PlanarBox near = grown({moved, moved}, most);
    if (std::ranges::all_of(coedge.boxes,
                            [&](const PlanarBox& box) { return are_disjoint(box, near); }))
      return;
    const PlanarFoot foot = nearest(coedge.curve, moved);
    if (foot.distance <= most && (!found || foot.distance < found->distance))
      found = WirePlace{&coedge, foot.parameter, foot.distance};
  };
  for (const double turn_u : turns(trims.period[0]))
    for (const double turn_v : turns(trims.period[1]))
      for (const auto& loop : trims.loops)
        for (const Coedge& coedge : loop) look_at(coedge, point + Vec2{turn_u, turn_v});
  return found;
}

std::optional<TrimPlace> border_at(const FaceTrims& trims, const Vec2& uv) {
  const Vec2 point{uv[0] * trims.scale[0], uv[1] * trims.scale[1]};
  for (const double turn_u : turns(trims.period[0]))
    for (const double turn_v : turns(trims.period[1])) {
      const Vec2 moved{point[0] + turn_u, point[1] + turn_v};
      const Coedge* const coedge = coedge_at(trims, moved);
      if (coedge == nullptr) continue;
      for (const bool last : {false, true}) {
        const int vertex = last ? coedge->end : coedge->start;
        const double own = trims.vertices[static_cast<std::size_t>(vertex)].tolerance;
        const double reach = kOnWire + std::max(coedge->tolerance, own);
        if (coedge->degenerated || distance(end_point(*coedge, last), moved) <= reach)
          return TrimPlace{coedge, vertex};
      }
      return TrimPlace{coedge, -1};
    }
  return std::nullopt;
}

}  // namespace blossom
