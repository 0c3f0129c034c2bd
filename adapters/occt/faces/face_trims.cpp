// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/face_trims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/convert/pcurves.h"
#include "adapters/occt/convert/surfaces_detail.h"
#include "adapters/occt/faces/face_trims_detail.h"
#include "core/plane/loops.h"

namespace blossom::occt {
namespace {

constexpr int kMaxHalvings = 6;     // of a wire's span, to see whether it meets a rectangle
constexpr int kPointHalvings = 24;  // likewise a point: pieces are about as long as kOnBorder then

Coedge coedge_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  Interval range;
  const Handle(Geom2d_Curve) pcurve = chart_curve_of(edge, face, range);
  if (pcurve.IsNull()) throw BadModel("an edge has no parametric curve on the face it bounds");
  return {edge,
          planar_curve(pcurve, range),
          {},
          BRep_Tool::Degenerated(edge),
          BRep_Tool::Tolerance(edge),
          0,
          0};
}

Vec2 end_point(const Coedge& coedge, bool last) {
  const Interval domain = coedge.curve.domain();
  return point_at(coedge.curve, last != coedge.reversed() ? domain.to : domain.from);
}

// The starts and ends of coedges at one vertex of the model.
struct Meeting {
  TopoDS_Vertex vertex;
  std::vector<Coedge*> starts;
  std::vector<Coedge*> ends;
};

std::vector<Meeting> meetings(FaceTrims& trims) {
  std::vector<Meeting> all;
  const auto at_vertex = [&](const TopoDS_Vertex& vertex) -> Meeting& {
    if (vertex.IsNull()) throw BadModel("an edge of a face has no vertices");
    const auto known = std::find_if(all.begin(), all.end(), [&](const Meeting& meeting) {
      return meeting.vertex.IsSame(vertex);
    });
    return known != all.end() ? *known : all.emplace_back(Meeting{vertex, {}, {}});
  };
  for (auto& loop : trims.loops)
    for (Coedge& coedge : loop) {
      at_vertex(TopExp::FirstVertex(coedge.edge, Standard_True)).starts.push_back(&coedge);
      at_vertex(TopExp::LastVertex(coedge.edge, Standard_True)).ends.push_back(&coedge);
    }
  return all;
}

// Joins each end to a start, nearest pairs first.
void join(Meeting meeting, FaceTrims& trims) {
  if (meeting.starts.size() != meeting.ends.size()) throw BadModel("a wire of a face is open");
  while (!meeting.ends.empty()) {
    std::size_t best_end = 0, best_start = 0;
    double nearest_gap = std::numeric_limits<double>::infinity();
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
    trims.corners.push_back(end_point(*meeting.ends[best_end], true));
    trims.largest_gap = std::max(trims.largest_gap, nearest_gap);
    meeting.ends.erase(meeting.ends.begin() + static_cast<std::ptrdiff_t>(best_end));
    meeting.starts.erase(meeting.starts.begin() + static_cast<std::ptrdiff_t>(best_start));
  }
}

void set_curve(Coedge& coedge, PlanarCurve curve) {
  coedge.curve = std::move(curve);
  coedge.boxes.clear();
  for (const PlanarSpan& span : coedge.curve.spans)
    coedge.boxes.push_back(box_of(span.curve.points));
}

PlanarBox box_of_loops(const FaceTrims& trims) {
  PlanarBox box = box_of(trims.loops.front().front().curve);
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) box = united(box, box_of(coedge.curve));
  return box;
}

double power_of_two(double length) {
  return length > 0 && std::isfinite(length) ? std::exp2(std::round(std::log2(length))) : 1.0;
}

// The derivatives of a polynomial patch by their control points.
Vec2 chart_scale(const Geom_BezierSurface& patch) {
  const TColgp_Array2OfPnt& p = patch.Poles();
  const int rows = p.ColLength(), columns = p.RowLength();
  Vec2 sum;
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns; ++j) {
      if (i < rows) sum[0] += p(i, j).Distance(p(i + 1, j));
      if (j < columns) sum[1] += p(i, j).Distance(p(i, j + 1));
    }
  return {power_of_two(sum[0] / columns), power_of_two(sum[1] / rows)};
}

// Of a Bezier patch.
bool covers_most(const PlanarBox& box) {
  return std::min(box.high[0] - box.low[0], box.high[1] - box.low[1]) >= 0.5;
}

// The mean lengths of the surface's derivatives over the box, rounded to powers of two.
Vec2 chart_scale(const Handle(Geom_Surface) & surface, const PlanarBox& box) {
  constexpr int kSamples = 5;
  const auto patch = Handle(Geom_BezierSurface)::DownCast(surface);
  if (!patch.IsNull() && !patch->IsURational() && !patch->IsVRational() && covers_most(box))
    return chart_scale(*patch);
  // Keeps the polynomial of its last span, which a Bezier surface never leaves.
  const GeomAdaptor_Surface quick(surface);
  const bool one_span = quick.GetType() == GeomAbs_BezierSurface;
  Vec2 sum;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const double u = at({box.low[0], box.high[0]}, (i + 0.5) / kSamples);
      const double v = at({box.low[1], box.high[1]}, (j + 0.5) / kSamples);
      gp_Pnt point;
      gp_Vec du, dv;
      one_span ? quick.D1(u, v, point, du, dv) : surface->D1(u, v, point, du, dv);
      sum += {du.Magnitude(), dv.Magnitude()};
    }
  return {power_of_two(sum[0] / (kSamples * kSamples)),
          power_of_two(sum[1] / (kSamples * kSamples))};
}

double past(const PlanarBox& box, const PlanarBox& bounds) {
  double most = 0;
  for (int k = 0; k < 2; ++k)
    most = std::max({most, bounds.low[k] - box.low[k], box.high[k] - bounds.high[k]});
  return most;
}

// How far a piece goes past the bounds, at most kOnBorder too much. Its control points may go far
// beyond the piece, so it is halved as long as they tell of more than its ends.
double farthest_past(const PlanarBezier& piece, const PlanarBox& bounds, double known,
                     int halvings) {
  const double most = past(box_of(piece.points), bounds);
  for (const Vec3& end : {piece.points.front(), piece.points.back()})
    known = std::max(known, past(box_of(std::span<const Vec3>(&end, 1)), bounds));
  if (most <= known + kOnBorder || halvings == 0) return std::max(most, known);
  for (const Interval& half : {Interval{0, 0.5}, Interval{0.5, 1}})
    known = farthest_past(bezier_piece(piece, half), bounds, known, halvings - 1);
  return known;
}

double overshoot(const Handle(Geom_Surface) & surface, const FaceTrims& trims) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  PlanarBox bounds;
  surface->Bounds(bounds.low[0], bounds.high[0], bounds.low[1], bounds.high[1]);
  for (int k = 0; k < 2; ++k) {
    const bool periodic = trims.period[k] > 0;
    bounds.low[k] = periodic ? -kEndless : trims.scale[k] * bounds.low[k];
    bounds.high[k] = periodic ? kEndless : trims.scale[k] * bounds.high[k];
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

bool apart(const PlanarBox& a, const PlanarBox& b) {
  for (int k = 0; k < 2; ++k)
    if (a.low[k] > b.high[k] || a.high[k] < b.low[k]) return true;
  return false;
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

bool holds_end(const PlanarBox& box, const Vec3& end) {
  const Vec2 p = projected(end);
  return !apart(box, {p, p});
}

bool may_meet(const PlanarBezier& piece, const PlanarBox& box, int halvings) {
  if (apart(box_of(piece.points), box)) return false;
  if (piece.degree() == 1) return !lies_beside(piece, box);
  if (holds_end(box, piece.points.front()) || holds_end(box, piece.points.back())) return true;
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
  if (coedge_near(trims, box, kOnBorder + trims.largest_gap, halvings) != nullptr)
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
        if (!apart(coedge.boxes[k], near) && may_meet(coedge.curve.spans[k].curve, near, halvings))
          return &coedge;
    }
  return nullptr;
}

const Coedge* coedge_at(const FaceTrims& trims, const Vec2& point, Wires wires) {
  return coedge_near(trims, {point, point}, kOnBorder, kPointHalvings, wires);
}

FaceTrims face_trims(const TopoDS_Face& face) {
  FaceTrims trims;
  trims.face = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(trims.face);
  if (surface.IsNull()) throw BadModel("a face has no surface");
  for (TopoDS_Iterator wire(trims.face); wire.More(); wire.Next()) {
    if (wire.Value().ShapeType() != TopAbs_WIRE) continue;
    std::vector<Coedge> loop;
    for (TopoDS_Iterator edge(wire.Value()); edge.More(); edge.Next()) {
      const TopAbs_Orientation use = edge.Value().Orientation();
      if (use == TopAbs_FORWARD || use == TopAbs_REVERSED)
        loop.push_back(coedge_of(TopoDS::Edge(edge.Value()), trims.face));
      else if (use == TopAbs_INTERNAL)
        trims.inner.push_back(
            coedge_of(TopoDS::Edge(edge.Value().Oriented(TopAbs_FORWARD)), trims.face));
    }
    if (!loop.empty()) trims.loops.push_back(std::move(loop));
  }
  if (trims.loops.empty()) throw BadModel("a face has no wire");
  trims.scale = chart_scale(surface, box_of_loops(trims));
  for (auto& loop : trims.loops)
    for (Coedge& coedge : loop)
      set_curve(coedge, transformed(std::move(coedge.curve), trims.scale, {}));
  for (Coedge& coedge : trims.inner)
    set_curve(coedge, transformed(std::move(coedge.curve), trims.scale, {}));
  // A rectangle of a surface has its period, even where Open CASCADE gives it none.
  const Handle(Geom_Surface) whole = basis_of(surface);
  trims.period = {whole->IsUPeriodic() ? whole->UPeriod() * trims.scale[0] : 0,
                  whole->IsVPeriodic() ? whole->VPeriod() * trims.scale[1] : 0};
  for (Meeting& meeting : meetings(trims)) join(std::move(meeting), trims);
  trims.box = box_of_loops(trims);
  trims.overshoot = overshoot(surface, trims);
  trims.natural = is_natural(trims);
  return trims;
}

PlanarCurve chart_curve(const FaceTrims& trims, const Spline2& chart) {
  return transformed(simplest_curve(chart), trims.scale, {});
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
    if (reaches(0, kOnBorder)) along.push_back(0);
    for (int turn = -2; trims.period[k] > 0 && turn <= 2; ++turn)
      if (turn != 0 && reaches(turn * trims.period[k], -kOnBorder))
        along.push_back(turn * trims.period[k]);
  }
  std::vector<Vec2> shifts;
  for (const double u : moves[0])
    for (const double v : moves[1]) shifts.push_back({u, v});
  return shifts;
}

bool is_inside(const FaceTrims& trims, const Vec2& point) {
  for (int k = 0; k < 2; ++k)
    if (point[k] < trims.box.low[k] || point[k] > trims.box.high[k]) return false;
  if (trims.natural) return true;
  int winding = 0;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) {
      const int sign = coedge.reversed() ? -1 : 1;
      for (std::size_t k = 0; k < coedge.boxes.size(); ++k)
        if (may_cross(coedge.boxes[k], point))
          winding += sign * ray_crossings(PlanarPath{coedge.curve.spans[k].curve}, point);
      const auto corner = [&](int i) { return trims.corners[static_cast<std::size_t>(i)]; };
      winding += ray_crossings(corner(coedge.from), end_point(coedge, false), point) +
                 ray_crossings(end_point(coedge, true), corner(coedge.to), point);
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

TopoDS_Shape border_at(const FaceTrims& trims, const Vec2& uv) {
  const Vec2 point{uv[0] * trims.scale[0], uv[1] * trims.scale[1]};
  for (const double turn_u : turns(trims.period[0]))
    for (const double turn_v : turns(trims.period[1])) {
      const Vec2 moved{point[0] + turn_u, point[1] + turn_v};
      const Coedge* const coedge = coedge_at(trims, moved);
      if (coedge == nullptr) continue;
      for (const bool last : {false, true}) {
        const TopoDS_Vertex vertex = last ? TopExp::LastVertex(coedge->edge, Standard_True)
                                          : TopExp::FirstVertex(coedge->edge, Standard_True);
        const double reach = kOnBorder + std::max(coedge->tolerance, BRep_Tool::Tolerance(vertex));
        if (coedge->degenerated || distance(end_point(*coedge, last), moved) <= reach)
          return vertex;
      }
      return coedge->edge;
    }
  return {};
}

}  // namespace blossom::occt
