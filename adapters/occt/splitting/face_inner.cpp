// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges inside of a face that FaceSplitter splits: internal ones, and those of other shapes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/pcurves.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "adapters/occt/splitting/edges_in_reach.h"
#include "adapters/occt/splitting/face_splitter.h"
#include "core/base/sampled_margin.h"
#include "core/base/unbounded.h"
#include "core/curve_intersection.h"

namespace blossom::occt {
namespace {

constexpr double kReach = 10;    // tolerances: what is so near a pole, or its surface, is on it
constexpr int kTurns = 2;        // periods that trims reach beyond the first one at most
constexpr double kOnEnd = 1e-9;  // of an edge: a place so near its end is it

}  // namespace

void FaceSplitter::add_inner_stops(LiftedCut& lifted_cut) {
  for (std::size_t i = 0; i < trims_.inner.size(); ++i) {
    const int index = static_cast<int>(i);
    check_limit(limit_, "dividing faces");
    const PlanarCrossings common =
        crossings(lifted_cut.curve, trims_.inner[i].curve, reach(lifted_cut));
    for (const PlanarCrossing& crossing : common.points) {
      const TrimMeeting meeting{crossing.a, inner_loop(), index, crossing.b};
      lifted_cut.stops.emplace_back(crossing.a,
                                    vertex_of(meeting, 0, inverse_sine(lifted_cut, meeting)));
    }
    for (const PlanarOverlap& run : common.overlaps)
      lifted_cut.runs.push_back({run.a, inner_loop(), index, run.b});
    if (!common.complete)
      note(lifted_cut.cut, "runs so close to an edge that not all crossings are sure");
  }
}

// An end is perhaps that of another edge, or on the border.
int FaceSplitter::inner_vertex(int index, int split) {
  const Coedge& of = coedge(inner_loop(), index);
  const Vec2 point = point_at(of.curve, splits_.parameter(edge_of(of), split));
  if (const int known = vertex_of_shape(splits_.vertex(edge_of(of), split), point); known >= 0)
    return known;
  vertices_.push_back({point, inner_loop(), index, split});
  return static_cast<int>(vertices_.size()) - 1;
}

// None of a vertex that has not been made.
TopoDS_Vertex FaceSplitter::shape_of(const Vertex& of) const {
  return of.split >= 0 ? splits_.vertex(edge_of(coedge(of.loop, of.coedge)), of.split) : of.shape;
}

// Of the vertices that stand for a shape, as on both sides of a seam, the nearest; -1 if none does.
int FaceSplitter::vertex_of_shape(const TopoDS_Vertex& shape, const Vec2& point) const {
  int nearest = -1;
  double least = kInfinity;
  const auto consider = [&](int vertex) {
    const double gap = distance(vertices_[static_cast<std::size_t>(vertex)].point, point);
    if (gap >= least) return;
    least = gap;
    nearest = vertex;
  };
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vertex& of = vertices_[i];
    const TopoDS_Vertex own = shape_of(of);
    if (!own.IsNull() && splits_.are_one(own, shape)) consider(static_cast<int>(i));
  }
  for (const auto& [other, vertex] : aliases_)
    if (splits_.are_one(other, shape)) consider(vertex);
  return nearest;
}

// Of a shape that touches itself, other vertices may be at the same place: they are one from now
// on.
int FaceSplitter::vertex_at_place(const TopoDS_Vertex& shape, const Vec2& point) {
  const gp_Pnt place = BRep_Tool::Pnt(shape);
  const auto is_there = [&](const TopoDS_Vertex& other) {
    return !other.IsNull() && BRep_Tool::Pnt(other).Distance(place) <= tolerance_;
  };
  std::vector<TopoDS_Vertex> known;
  for (const Vertex& of : vertices_) known.push_back(shape_of(of));
  for (const auto& [other, vertex] : aliases_) known.push_back(other);
  const auto found = std::ranges::find_if(known, is_there);
  if (found == known.end()) return -1;
  splits_.unite(*found, shape);
  return vertex_of_shape(shape, point);
}

bool FaceSplitter::add_inner_arcs() {
  for (std::size_t i = 0; i < trims_.inner.size(); ++i) {
    const int index = static_cast<int>(i);
    for (const EdgePiece& piece : splits_.pieces(edge_of(trims_.inner[i]))) {
      PlanarPath path = bezier_pieces(trims_.inner[i].curve, piece.range);
      if (path.empty()) continue;
      const int from = inner_vertex(index, piece.from), to = inner_vertex(index, piece.to);
      arcs_.push_back({from, to, std::move(path), false});
      origins_.push_back({piece.edge, runs_along(inner_loop(), index, piece), -1, inner_loop()});
    }
  }
  return !trims_.inner.empty();
}

bool FaceSplitter::add_coincident_arcs() {
  if (coincident_.empty()) return false;
  const std::size_t before = arcs_.size();
  const SurfaceProjector feet(face_, tolerance_);
  for (const auto& [edge, reach, along] : coincident_)
    for (const EdgePiece& piece : splits_.pieces(edge)) {
      const double middle = at(piece.range, 0.5);
      if (std::ranges::none_of(
              along, [&](const Interval& run) { return run.from <= middle && middle <= run.to; }))
        add_coincident_arc(piece, reach, feet);
    }
  return arcs_.size() > before;
}

// A pole is one vertex but a whole side of the chart: it is split where the edge comes to it.
void FaceSplitter::add_coincident(const TopoDS_Edge& edge, double reach,
                                  const std::vector<Interval>& along) {
  coincident_.push_back({edge, reach, along});
  for (std::size_t loop = 0; loop < trims_.loops.size(); ++loop)
    for (std::size_t i = 0; i < trims_.loops[loop].size(); ++i)
      if (trims_.loops[loop][i].degenerated)
        split_pole_at(edge, static_cast<int>(loop), static_cast<int>(i));
}

void FaceSplitter::split_pole_at(const TopoDS_Edge& edge, int loop, int index) {
  const Coedge& pole = coedge(loop, index);
  const SurfaceProjector feet(face_, tolerance_);
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  const CurveBeside beside(curve, range, feet);
  const auto come = [&](double there, double from) {
    if (!(std::abs(there - from) > kOnEnd * length(range))) return;
    const Vec2 uv = beside.end_jet(there, from, {}).uv;
    const Vec2 at{uv[0] * trims_.scale[0], uv[1] * trims_.scale[1]};
    for (int turn = -2; turn <= 2; ++turn) {
      const PlanarFoot foot = nearest(pole.curve, at + static_cast<double>(turn) * trims_.period);
      if (foot.distance <= kReach * tolerance_) splits_.add(edge_of(pole), foot.parameter, face_);
    }
  };
  const TopoDS_Vertex there = TopExp::FirstVertex(edge_of(pole));
  for (int i = splits_.count(edge) - 1; i >= 0; --i) {
    if (!splits_.are_one(splits_.vertex(edge, i), there)) continue;
    come(splits_.parameter(edge, i), range.from);
    come(splits_.parameter(edge, i), range.to);
  }
}

FaceSplitter::CoincidentCurve FaceSplitter::coincident_curve(const TopoDS_Edge& edge,
                                                             const SurfaceProjector& feet) const {
  CoincidentCurve of;
  Interval range;
  of.curve = BRep_Tool::Curve(edge, range.from, range.to);
  const double allowed = std::max(kReach * tolerance_, BRep_Tool::Tolerance(edge));
  const ChartImage image = image_of(of.curve, range, feet, {}, allowed);
  of.image = image.chart;
  of.tolerance = std::max(BRep_Tool::Tolerance(edge), kSampledMargin * image.deviation);
  of.chart = transformed(planar_curve(image.chart, range), trims_.scale, {});
  return of;
}

// The edge that takes the place of a piece of another shape's, its chart curve moved by periods,
// between vertices of this face: what it meets here may be known to this face alone.
TopoDS_Edge FaceSplitter::coincident_edge(const EdgePiece& piece, const CoincidentCurve& of,
                                          const Vec2& shift, int from, int to) {
  TopLoc_Location location;
  const Handle(Geom_Surface) raw = BRep_Tool::Surface(face_, location);
  const gp_Vec2d move(shift[0] / trims_.scale[0], shift[1] / trims_.scale[1]);
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, of.curve, of.tolerance);
  builder.UpdateEdge(edge, Handle(Geom2d_Curve)::DownCast(of.image->Translated(move)), raw,
                     location, of.tolerance);
  builder.Range(edge, piece.range.from, piece.range.to);
  leave_periods(edge);
  const auto add = [&](int vertex, const TopoDS_Vertex& shape, TopAbs_Orientation end) {
    Vertex& own = vertices_[static_cast<std::size_t>(vertex)];
    if (own.shape.IsNull())
      own.shape =
          own.split < 0 ? shape : splits_.vertex(edge_of(coedge(own.loop, own.coedge)), own.split);
    builder.Add(edge, own.shape.Oriented(end));
  };
  add(from, TopExp::FirstVertex(piece.edge), TopAbs_FORWARD);
  add(to, TopExp::LastVertex(piece.edge), TopAbs_REVERSED);
  return edge;
}

// Whether an edge is near a cut from a place to one of its ends.
bool FaceSplitter::leads_to_end(const FaceCut& cut, double at, const TopoDS_Edge& edge) const {
  const RangedCurve beside = curve_of(edge);
  const double near = kReach * std::max(tolerance_, cut.tolerance);
  const Interval domain = cut.chart.domain();
  return std::ranges::any_of(std::array{domain.from, domain.to}, [&](double end) {
    return std::ranges::all_of(std::array{0.0, 0.5}, [&](double part) {
      return foot_on(beside, pnt(space_point(cut, end + part * (at - end)))).distance <= near;
    });
  });
}

// Where a cut and an edge of another shape meet: a stop of the cut over each place of it in the
// face.
void FaceSplitter::meet_at(int cut, double at, const TopoDS_Vertex& shape) {
  for (LiftedCut& lifted_cut : lifted_cuts_) {
    if (lifted_cut.cut != cut) continue;
    const Vec2 point = point_at(lifted_cut.curve, at);
    if (!is_inside(trims_, point)) continue;
    int vertex = vertex_of_shape(shape, point);
    if (vertex < 0) {
      vertex = static_cast<int>(vertices_.size());
      vertices_.push_back({point, -1, -1, -1, shape});
    }
    lifted_cut.stops.emplace_back(at, vertex);
  }
}

void FaceSplitter::meet_cuts(const TopoDS_Edge& lying) {
  const auto boxes = edges_in_reach({lying}, [this](const TopoDS_Edge&) { return tolerance_; });
  if (boxes.empty()) return;
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    const FaceCut& cut = cuts_[i];
    if (!blossom::meet(boxes.front().box, spline_box(cut.curve))) continue;
    IntersectionOptions options;
    options.tolerances.point = std::max(tolerance_, cut.tolerance);
    const CurveIntersection common =
        intersect(bezier_spans(space_curve(cut), cut.chart.domain()), bezier_spans(lying), options);
    for (const CurvePoint& point : common.points)
      if (!leads_to_end(cut, point.a, lying))
        meet_at(static_cast<int>(i), point.a,
                splits_.vertex(lying, splits_.add(lying, point.b, {})));
  }
}

// What does not, but begins or ends on a border, may leave a surface that ends beside the face.
bool FaceSplitter::lies_in_face(const EdgePiece& piece, double reach,
                                const SurfaceProjector& feet) const {
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(piece.edge, first, last);
  const auto point = [&](double part) {
    const gp_Pnt of = curve->Value(at(piece.range, part));
    return Vec3{of.X(), of.Y(), of.Z()};
  };
  for (const double part : {0.5, 0.2, 0.8})
    if (std::abs(feet.height(point(part))) > reach) return false;
  const Vec2 uv = feet.foot(point(0.5), {});
  const Vec2 chart{uv[0] * trims_.scale[0], uv[1] * trims_.scale[1]};
  // Trims may be longer than a period.
  const int turns_u = trims_.period[0] > 0 ? kTurns : 0,
            turns_v = trims_.period[1] > 0 ? kTurns : 0;
  for (int i = -turns_u; i <= turns_u; ++i)
    for (int j = -turns_v; j <= turns_v; ++j)
      if (is_inside(trims_, {chart[0] + i * trims_.period[0], chart[1] + j * trims_.period[1]}))
        return true;
  return false;
}

void FaceSplitter::add_coincident_arc(const EdgePiece& piece, double reach,
                                      const SurfaceProjector& feet) {
  if (!lies_in_face(piece, reach, feet)) return;
  const CoincidentCurve of = coincident_curve(piece.edge, feet);
  const auto vertex = [&](const TopoDS_Vertex& shape, const Vec2& point) {
    if (const int known = vertex_of_shape(shape, point); known >= 0) return known;
    if (const int known = vertex_at_place(shape, point); known >= 0) return known;
    vertices_.push_back({point, -1, -1, -1, shape});
    return static_cast<int>(vertices_.size()) - 1;
  };
  for (const Vec2& shift : period_shifts(trims_, of.chart)) {
    const PlanarCurve moved = transformed(of.chart, {1, 1}, shift);
    if (!is_inside(trims_, point_at(moved, at(piece.range, 0.5)))) continue;
    PlanarPath path = bezier_pieces(moved, piece.range);
    if (path.empty()) continue;
    const int from = vertex(TopExp::FirstVertex(piece.edge), start_of(path));
    const int to = vertex(TopExp::LastVertex(piece.edge), end_of(path));
    arcs_.push_back({from, to, std::move(path), false});
    origins_.push_back({coincident_edge(piece, of, shift, from, to), {}, -1, -1, piece.edge});
  }
}

// Of arcs that divide nothing, those that stay: the face's own internal edges, and cuts if wanted.
std::vector<int> FaceSplitter::imprints_among(const std::vector<int>& arcs, OpenCuts open) const {
  std::vector<int> kept;
  for (const int arc : arcs) {
    const Origin& of = origins_[static_cast<std::size_t>(arc)];
    if (of.lifted_cut >= 0 ? open == OpenCuts::Imprint : of.loop == inner_loop())
      kept.push_back(arc);
  }
  return kept;
}

}  // namespace blossom::occt
