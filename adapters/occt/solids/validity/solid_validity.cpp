// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/validity/solid_validity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_Shell.hxx>
#include <BRepCheck_Solid.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <IntRes2d_IntersectionPoint.hxx>
#include <IntRes2d_IntersectionSegment.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/check_words.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/solids/validity/faces_to_check.h"
#include "adapters/occt/solids/validity/polygon_faces.h"
#include "adapters/occt/solids/validity/sound_faces.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "core/base/sampled_margin.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

bool new_faces_are_valid(const TopoDS_Shape& shape, const TopTools_MapOfShape& known) {
  FacesToCheck faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    if (known.Contains(face) || is_sound_polygon(face)) continue;
    const TopoDS_Face copy = faces.add(face);
    // The loops of polygons are in doubt already.
    if (!is_held_polygon(copy) && is_sound_face(copy)) continue;
    if (has_hole_astray(copy) || !BRepCheck_Analyzer(copy).IsValid()) return false;
  }
  return true;
}

bool shells_are_valid(const TopoDS_Solid& solid) {
  for (TopoDS_Iterator it(solid); it.More(); it.Next()) {
    if (it.Value().ShapeType() != TopAbs_SHELL) continue;
    const Handle(BRepCheck_Shell) shell = new BRepCheck_Shell(TopoDS::Shell(it.Value()));
    shell->InContext(solid);
    if (!finds_nothing(shell->Status()) || !finds_nothing(shell->StatusOnShape(solid)))
      return false;
  }
  return true;
}

constexpr int kAreaSteps = 8;      // of each edge: chords of a circle enclose 0.9 of it
constexpr double kAreaMargin = 4;  // of what is covered: a face with less is looked at exactly

// By chords, which take next to no time. A face that goes round, as the side of a cylinder does,
// may have no area by them.
bool may_be_covered(const TopoDS_Face& face) {
  gp_XYZ area, origin;
  double length = 0, widest = 0;
  bool first = true;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    Interval range;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
    if (curve.IsNull()) continue;
    widest = std::max(widest, BRep_Tool::Tolerance(edge));
    gp_XYZ before = curve->Value(range.from).XYZ();
    if (std::exchange(first, false)) origin = before;
    const double sign = edge.Orientation() == TopAbs_REVERSED ? -0.5 : 0.5;
    for (int i = 1; i <= kAreaSteps; ++i) {
      const gp_XYZ next = curve->Value(at(range, static_cast<double>(i) / kAreaSteps)).XYZ();
      area += sign * (before - origin).Crossed(next - origin);
      length += (next - before).Modulus();
      before = next;
    }
  }
  return area.Modulus() <= kAreaMargin * widest * length;
}

bool is_sliver(const TopoDS_Face& face) {
  if (!may_be_covered(face)) return false;
  const FaceTrims trims = face_trims(face);
  return std::ranges::any_of(trims.loops, [&](const std::vector<Coedge>& loop) {
    return is_covered(trims, loop, Precision::Confusion());
  });
}

constexpr std::array kBetween{0.25, 0.5, 0.75};  // samples from a vertex to a crossing

// An edge with its curve in the parameters of one face.
struct ChartedEdge {
  TopoDS_Edge edge;
  Handle(Geom2d_Curve) chart;
  Interval range;
};

std::vector<ChartedEdge> charted_edges(const TopoDS_Face& face) {
  std::vector<ChartedEdge> all;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    ChartedEdge made{TopoDS::Edge(it.Current()), {}, {}};
    if (BRep_Tool::Degenerated(made.edge)) continue;
    made.chart = BRep_Tool::CurveOnSurface(made.edge, face, made.range.from, made.range.to);
    if (made.chart.IsNull() || curve_of(made.edge).curve.IsNull()) continue;
    all.push_back(std::move(made));
  }
  return all;
}

double length_by_chords(const RangedCurve& of) {
  const gp_Pnt middle = of.curve->Value(at(of.range, 0.5));
  return middle.Distance(of.curve->Value(of.range.from)) +
         middle.Distance(of.curve->Value(of.range.to));
}

// The parameter at which an edge ends in a vertex; of a closed one the end nearer to another
// parameter.
double end_beside(const TopoDS_Edge& edge, const TopoDS_Vertex& vertex, double t) {
  if (!TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge)))
    return BRep_Tool::Parameter(vertex, edge);
  const Interval range = curve_of(edge).range;
  return t - range.from < range.to - t ? range.from : range.to;
}

// Whether two edges, from a vertex of both up to a crossing, come no farther from each other than
// their tolerances and their ends in the vertex say, by samples, and no longer than curves do that
// touch with a radius as long as the longer edge: others only go in nearly the same direction.
bool are_one_up_to(const ChartedEdge& a, const ChartedEdge& b, const TopoDS_Vertex& vertex,
                   const IntRes2d_IntersectionPoint& crossing) {
  const RangedCurve of_a = curve_of(a.edge), of_b = curve_of(b.edge);
  const double t = crossing.ParamOnFirst();
  const Interval between{end_beside(a.edge, vertex, t), t};
  const gp_Pnt from = of_a.curve->Value(between.from);
  const gp_Pnt end = of_b.curve->Value(end_beside(b.edge, vertex, crossing.ParamOnSecond()));
  const double stated = BRep_Tool::Tolerance(a.edge) + BRep_Tool::Tolerance(b.edge);
  const double radius = std::max(length_by_chords(of_a), length_by_chords(of_b));
  if (from.Distance(of_a.curve->Value(t)) > std::sqrt(8 * radius * stated)) return false;
  const double most = stated + from.Distance(end);
  return std::ranges::all_of(kBetween, [&](double part) {
    return foot_on(of_b, of_a.curve->Value(at(between, part))).distance <= most;
  });
}

// Each once.
std::vector<TopoDS_Vertex> common_ends(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  TopTools_IndexedMapOfShape of_a, of_b;
  TopExp::MapShapes(a, TopAbs_VERTEX, of_a);
  TopExp::MapShapes(b, TopAbs_VERTEX, of_b);
  std::vector<TopoDS_Vertex> common;
  for (int i = 1; i <= of_a.Extent(); ++i)
    if (of_b.Contains(of_a(i))) common.push_back(TopoDS::Vertex(of_a(i)));
  return common;
}

// Where two curves cross, and where stretches begin along which they are one for Open CASCADE.
std::vector<IntRes2d_IntersectionPoint> crossings_of(const ChartedEdge& a, const ChartedEdge& b) {
  const Geom2dAPI_InterCurveCurve met(new Geom2d_TrimmedCurve(a.chart, a.range.from, a.range.to),
                                      new Geom2d_TrimmedCurve(b.chart, b.range.from, b.range.to),
                                      Precision::PConfusion());
  std::vector<IntRes2d_IntersectionPoint> found;
  for (int k = 1; k <= met.NbPoints(); ++k) found.push_back(met.Intersector().Point(k));
  for (int k = 1; k <= met.NbSegments(); ++k) {
    const IntRes2d_IntersectionSegment& run = met.Intersector().Segment(k);
    if (run.HasFirstPoint()) found.push_back(run.FirstPoint());
  }
  return found;
}

// The crossings of two edges that the nearest one of their common vertices may stand for are
// covered.
bool cover_crossings(const ChartedEdge& a, const ChartedEdge& b, const TopoDS_Face& face) {
  const std::vector<TopoDS_Vertex> ends = common_ends(a.edge, b.edge);
  if (ends.empty()) return false;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  bool any = false;
  for (const IntRes2d_IntersectionPoint& crossing : crossings_of(a, b)) {
    const gp_Pnt point = surface->Value(crossing.Value().X(), crossing.Value().Y());
    const auto past = [&](const TopoDS_Vertex& end) {
      return BRep_Tool::Pnt(end).Distance(point) - BRep_Tool::Tolerance(end);
    };
    const TopoDS_Vertex& vertex = *std::ranges::min_element(ends, {}, past);
    if (past(vertex) <= 0 || !are_one_up_to(a, b, vertex, crossing)) continue;
    BRep_Builder().UpdateVertex(vertex, kSampledMargin * BRep_Tool::Pnt(vertex).Distance(point));
    any = true;
  }
  return any;
}

bool cover_corners_of(const TopoDS_Face& face) {
  const std::vector<ChartedEdge> edges = charted_edges(face);
  bool any = false;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = i + 1; k < edges.size(); ++k)
      if (!edges[i].edge.IsSame(edges[k].edge))
        any = cover_crossings(edges[i], edges[k], face) || any;
  return any;
}

}  // namespace

bool has_covered_face(const std::vector<TopoDS_Solid>& solids, const TopTools_MapOfShape& known) {
  for (const TopoDS_Solid& solid : solids)
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
      if (!known.Contains(it.Current()) && is_sliver(TopoDS::Face(it.Current()))) return true;
  return false;
}

bool cover_tangent_corners(const std::vector<TopoDS_Solid>& solids,
                           const TopTools_MapOfShape& known) {
  return guarded("covering corners", [&] {
    bool any = false;
    for (const TopoDS_Solid& solid : solids)
      for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face face = TopoDS::Face(it.Current());
        if (!known.Contains(face) && !BRepCheck_Analyzer(face).IsValid())
          any = cover_corners_of(face) || any;
      }
    return any;
  });
}

bool is_valid(const TopoDS_Solid& solid, const TopTools_MapOfShape& known) {
  const Handle(BRepCheck_Solid) whole = new BRepCheck_Solid(solid);
  return finds_nothing(whole->Status()) && shells_are_valid(solid) &&
         new_faces_are_valid(solid, known);
}

bool are_valid(const std::vector<TopoDS_Solid>& solids, const TopTools_MapOfShape& known,
               const WorkLimit& limit) {
  return guarded("checking solids", [&] {
    return std::ranges::all_of(solids, [&](const TopoDS_Solid& solid) {
      check_limit(&limit, "checking solids");
      return is_valid(solid, known);
    });
  });
}

bool are_valid(const std::vector<SolidFace>& faces, const TopTools_MapOfShape& known) {
  return guarded("checking faces", [&] {
    return std::ranges::all_of(
        faces, [&](const SolidFace& of) { return new_faces_are_valid(of.face, known); });
  });
}

}  // namespace blossom::occt
