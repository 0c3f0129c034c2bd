// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/shapes/loose_images.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/forms/edge_charts.h"
#include "adapters/occt/shapes/edge_tolerances.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

constexpr double kLoose = 1e-4;    // model units
constexpr double kShare = 1e-3;    // of an edge's length: likewise
constexpr double kNearer = 0.1;    // of how far a curve is off: what the new one may be
constexpr double kWanted = 1e-6;   // model units: better is not tried
constexpr int kSamples = 16;       // parts of an edge
constexpr int kMostParts = 256;    // likewise
constexpr int kSteps = 20;         // of Newton's method
constexpr double kRegular = 1e-9;  // of a surface's derivatives: the least sine's square
constexpr double kMargin = 1.1;    // of distances between samples

// An edge of a face with both its curves.
struct Use {
  TopoDS_Edge edge;
  Handle(Geom_Curve) curve;
  Handle(Geom2d_Curve) chart;
  Interval range;
};

std::optional<Use> use_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  Use use{edge, {}, {}, {}};
  if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) return std::nullopt;
  Interval of_chart;
  use.chart = chart_curve_of(edge, face, of_chart);
  use.curve = BRep_Tool::Curve(edge, use.range.from, use.range.to);
  if (use.chart.IsNull() || use.curve.IsNull()) return std::nullopt;
  if (of_chart.from != use.range.from || of_chart.to != use.range.to) return std::nullopt;
  return use;
}

double largest_gap(const Use& use, const Handle(Geom_Surface) & surface, int samples = kSamples) {
  double largest = 0;
  for (int i = 0; i <= samples; ++i) {
    const double t = at(use.range, static_cast<double>(i) / samples);
    const gp_Pnt2d uv = use.chart->Value(t);
    largest = std::max(largest, use.curve->Value(t).Distance(surface->Value(uv.X(), uv.Y())));
  }
  return largest;
}

double length_of(const Use& use) {
  double length = 0;
  for (int i = 0; i < kSamples; ++i)
    length += use.curve->Value(at(use.range, static_cast<double>(i) / kSamples))
                  .Distance(use.curve->Value(at(use.range, (i + 1.0) / kSamples)));
  return length;
}

// The foot of a point on a surface, by Gauss and Newton's method from near by.
gp_Pnt2d foot_near(const gp_Pnt& point, const gp_Pnt2d& start, const Geom_Surface& surface) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface.Bounds(u0, u1, v0, v1);
  gp_XY uv = start.XY();
  for (int i = 0; i < kSteps; ++i) {
    gp_Pnt on;
    gp_Vec du, dv;
    surface.D1(uv.X(), uv.Y(), on, du, dv);
    const gp_Vec off(on, point);
    const double a = du.Dot(du), b = du.Dot(dv), c = dv.Dot(dv);
    const double determinant = a * c - b * b;
    if (!(determinant > kRegular * a * c)) break;
    const double x = du.Dot(off), y = dv.Dot(off);
    uv += gp_XY(c * x - b * y, a * y - b * x) / determinant;
    // What lies beyond the borders of a surface is no part of it.
    if (!surface.IsUPeriodic()) uv.SetX(std::clamp(uv.X(), u0, u1));
    if (!surface.IsVPeriodic()) uv.SetY(std::clamp(uv.Y(), v0, v1));
  }
  return uv;
}

Handle(Geom2d_Curve) through_feet(const Use& use, const Geom_Surface& surface, int parts) {
  const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, parts + 1);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, parts + 1);
  for (int i = 0; i <= parts; ++i) {
    const double t = at(use.range, static_cast<double>(i) / parts);
    points->SetValue(i + 1, foot_near(use.curve->Value(t), use.chart->Value(t), surface));
    parameters->SetValue(i + 1, t);
  }
  Geom2dAPI_Interpolate made(points, parameters, Standard_False, Precision::PConfusion());
  made.Perform();
  return made.IsDone() ? Handle(Geom2d_Curve)(made.Curve().get()) : Handle(Geom2d_Curve)();
}

// The image of the curve in space with as few parts as make it a tenth as far off; null if none do.
Handle(Geom2d_Curve)
    better_image(const Use& use, const Handle(Geom_Surface) & surface, double gap) {
  const double wanted = std::min(kNearer * gap, kWanted);
  Handle(Geom2d_Curve) best;
  double least = kNearer * gap;
  for (int parts = kSamples; parts <= kMostParts && (best.IsNull() || least > wanted); parts *= 2) {
    Use made = use;
    made.chart = through_feet(use, *surface, parts);
    if (made.chart.IsNull()) break;
    const double left = largest_gap(made, surface, 4 * parts);
    if (left > least) continue;
    least = left;
    best = made.chart;
  }
  return best;
}

// Remakes the loose curves of one face, and adds their edges to those that are remade.
RemadeImages remake(const TopoDS_Face& face, const TopTools_IndexedMapOfShape& unseen,
                    TopTools_IndexedMapOfShape& remade) {
  RemadeImages made;
  std::vector<Use> given;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  bool was_valid = false;
  const auto set = [&](const Use& use, const Handle(Geom2d_Curve) & chart) {
    BRep_Builder().UpdateEdge(use.edge, chart, face, BRep_Tool::Tolerance(use.edge));
  };
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const std::optional<Use> use = use_of(TopoDS::Edge(it.Current()), face);
    if (!use || BRep_Tool::Tolerance(use->edge) <= kLoose) continue;
    const double gap = largest_gap(*use, surface);
    if (gap <= kLoose) continue;
    if (gap <= kShare * length_of(*use) && !unseen.Contains(use->edge)) continue;
    const Handle(Geom2d_Curve) better = better_image(*use, surface, gap);
    if (better.IsNull()) continue;
    if (given.empty()) was_valid = BRepCheck_Analyzer(face).IsValid();
    given.push_back(*use);
    set(*use, better);
    made = {made.count + 1, std::max(made.worst, gap)};
  }
  if (!given.empty() && was_valid && !BRepCheck_Analyzer(face).IsValid()) {
    for (const Use& use : given) set(use, use.chart);
    return {};
  }
  for (const Use& use : given) remade.Add(use.edge);
  return made;
}

using Users = TopTools_IndexedDataMapOfShapeListOfShape;

// Lowers the tolerances of edges and vertices, unless a face is less valid for it.
class Lowering {
 public:
  // needed   asked again whenever the tolerance is lowered
  template <class Part>
  void add(const Handle(Part) & part, std::function<double()> needed,
           const TopTools_ListOfShape& faces) {
    const auto set = [part](double tolerance) { part->Tolerance(tolerance); };
    parts_.push_back({std::move(needed), set, part->Tolerance(), faces});
    lower(parts_.back());
  }

  // To check each face once is enough where none is less valid; what bounds the others is lowered
  // again one by one.
  void settle() {
    TopTools_IndexedMapOfShape invalid;
    for (const Part& part : parts_)
      for (const TopoDS_Shape& face : part.faces)
        if (checked_.Add(face) && !BRepCheck_Analyzer(face).IsValid()) invalid.Add(face);
    std::erase_if(parts_, [&](const Part& part) {
      return std::none_of(part.faces.begin(), part.faces.end(),
                          [&](const TopoDS_Shape& face) { return invalid.Contains(face); });
    });
    for (const Part& part : parts_) part.set(part.given);
    for (const Part& part : parts_)
      if (lower(part) && !are_valid(part.faces)) {
        part.set(part.given);
        if (!are_valid(part.faces)) lower(part);
      }
  }

 private:
  struct Part {
    std::function<double()> needed;
    std::function<void(double)> set;
    double given;
    TopTools_ListOfShape faces;
  };

  static bool lower(const Part& part) {
    const double needed = part.needed();
    if (needed < part.given) part.set(needed);
    return needed < part.given;
  }

  static bool are_valid(const TopTools_ListOfShape& faces) {
    return std::all_of(faces.begin(), faces.end(),
                       [](const TopoDS_Shape& face) { return BRepCheck_Analyzer(face).IsValid(); });
  }

  std::vector<Part> parts_;
  TopTools_MapOfShape checked_;
};

void tighten_edges(const TopTools_IndexedMapOfShape& remade, const Users& faces_of,
                   Lowering& lowering) {
  for (int i = 1; i <= remade.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(remade(i));
    const TopTools_ListOfShape& faces = faces_of.FindFromKey(edge);
    const double needed = needed_tolerance(edge, faces);
    lowering.add(
        Handle(BRep_TEdge)::DownCast(edge.TShape()), [needed] { return needed; }, faces);
  }
}

// What the ends of the edges at a vertex ask for.
double needed_at(const TopoDS_Vertex& vertex, const TopTools_ListOfShape& edges,
                 const Users& faces_of) {
  double needed = Precision::Confusion();
  for (const TopoDS_Shape& each : edges) {
    const TopoDS_Edge edge = TopoDS::Edge(each);
    if (!faces_of.Contains(edge)) continue;
    const auto& own = faces_of.FindFromKey(edge);
    for (TopoDS_Iterator end(edge.Oriented(TopAbs_FORWARD)); end.More(); end.Next())
      if (end.Value().IsSame(vertex))
        needed = std::max({needed, BRep_Tool::Tolerance(edge),
                           distance_at(TopoDS::Vertex(end.Value()), edge, own)});
  }
  return kMargin * needed;
}

// Those of the remade edges.
void tighten_vertices(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& remade,
                      const Users& faces_of, Lowering& lowering) {
  TopTools_IndexedMapOfShape ends;
  for (int i = 1; i <= remade.Extent(); ++i) TopExp::MapShapes(remade(i), TopAbs_VERTEX, ends);
  Users edges, faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_VERTEX, TopAbs_EDGE, edges);
  TopExp::MapShapesAndAncestors(shape, TopAbs_VERTEX, TopAbs_FACE, faces);
  for (int i = 1; i <= ends.Extent(); ++i) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(ends(i));
    if (BRep_Tool::Tolerance(vertex) <= kLoose) continue;
    const TopTools_ListOfShape at = edges.FindFromKey(vertex);
    lowering.add(
        Handle(BRep_TVertex)::DownCast(vertex.TShape()),
        [vertex, at, &faces_of] { return needed_at(vertex, at, faces_of); },
        faces.FindFromKey(vertex));
  }
}

bool is_loose(const TopoDS_Face& face) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (BRep_Tool::Tolerance(TopoDS::Edge(it.Current())) > kLoose) return true;
  return false;
}

}  // namespace

RemadeImages remake_loose_images(const TopoDS_Shape& shape,
                                 const TopTools_IndexedMapOfShape& unseen) {
  RemadeImages all;
  TopTools_IndexedMapOfShape faces, remade;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face face = TopoDS::Face(faces(i).Oriented(TopAbs_FORWARD));
    if (!is_loose(face)) continue;
    const RemadeImages made = remake(face, unseen, remade);
    all = {all.count + made.count, std::max(all.worst, made.worst)};
  }
  if (all.count == 0) return all;
  Users faces_of;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  Lowering lowering;
  tighten_edges(remade, faces_of, lowering);
  tighten_vertices(shape, remade, faces_of, lowering);
  lowering.settle();
  return all;
}

}  // namespace blossom::occt
