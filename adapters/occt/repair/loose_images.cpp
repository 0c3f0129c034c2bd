// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/loose_images.h"

#include <algorithm>
#include <cmath>
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
#include <Standard_Failure.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/repair/edge_tolerances.h"
#include "core/base/sampled_margin.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

constexpr double kShare = 1e-3;    // of an edge's length: what is nearer is left
constexpr double kNearer = 0.1;    // of how far a curve is off: what the new one may be
constexpr double kWanted = 1e-6;   // model units: better is not tried
constexpr int kSamples = 16;       // parts of an edge
constexpr int kMaxParts = 256;     // likewise
constexpr int kSteps = 20;         // of Newton's method
constexpr double kStill = 1e-12;   // model units: a step of it that is nothing any more
constexpr double kRegular = 1e-9;  // of a surface's derivatives: the least sine's square

using Stop = std::function<void()>;

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
    const gp_XY step = gp_XY(c * x - b * y, a * y - b * x) / determinant;
    uv += step;
    // What lies beyond the borders of a surface is no part of it.
    if (!surface.IsUPeriodic()) uv.SetX(std::clamp(uv.X(), u0, u1));
    if (!surface.IsVPeriodic()) uv.SetY(std::clamp(uv.Y(), v0, v1));
    if (std::abs(step.X()) * std::sqrt(a) + std::abs(step.Y()) * std::sqrt(c) <= kStill) break;
  }
  return uv;
}

// Feet of points of the curve at equal distances of its parameter.
struct Feet {
  Handle(TColgp_HArray1OfPnt2d) points;
  Handle(TColStd_HArray1OfReal) parameters;
  double farthest = 0;  // of the points from their feet
};

Feet feet_of(const Use& use, const Geom_Surface& surface, int parts) {
  Feet feet{new TColgp_HArray1OfPnt2d(1, parts + 1), new TColStd_HArray1OfReal(1, parts + 1)};
  for (int i = 0; i <= parts; ++i) {
    const double t = at(use.range, static_cast<double>(i) / parts);
    const gp_Pnt point = use.curve->Value(t);
    const gp_Pnt2d foot = foot_near(point, use.chart->Value(t), surface);
    feet.points->SetValue(i + 1, foot);
    feet.parameters->SetValue(i + 1, t);
    feet.farthest = std::max(feet.farthest, point.Distance(surface.Value(foot.X(), foot.Y())));
  }
  return feet;
}

Handle(Geom2d_Curve) through(const Feet& feet) try {
  Geom2dAPI_Interpolate made(feet.points, feet.parameters, Standard_False, Precision::PConfusion());
  made.Perform();
  return made.IsDone() ? Handle(Geom2d_Curve)(made.Curve().get()) : Handle(Geom2d_Curve)();
} catch (const Standard_Failure&) {  // such as of feet that are one point
  return {};
}

// The image of the curve in space with as few parts as make it a tenth as far off; null if none do.
// Images through more feet go through these, too, so none is nearer than the farthest of them.
Handle(Geom2d_Curve)
    better_image(const Use& use, const Handle(Geom_Surface) & surface, double gap) {
  const double wanted = std::min(kNearer * gap, kWanted);
  Handle(Geom2d_Curve) best;
  double least = kNearer * gap;
  for (int parts = kSamples; parts <= kMaxParts && (best.IsNull() || least > wanted); parts *= 2) {
    const Feet feet = feet_of(use, *surface, parts);
    if (feet.farthest > least) break;
    Use made = use;
    made.chart = through(feet);
    if (made.chart.IsNull()) break;
    const double left = largest_gap(made, surface, 4 * parts);
    if (left > least) continue;
    least = left;
    best = made.chart;
  }
  return best;
}

// The images of one face that are too far off, and better ones.
struct Better {
  Use given;
  Handle(Geom2d_Curve) chart;
  double gap = 0;
};

std::vector<Better> better_images(const TopoDS_Face& face, const TopTools_IndexedMapOfShape& unseen,
                                  const Stop& stop) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  std::vector<Better> found;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    if (stop) stop();
    const std::optional<Use> use = use_of(TopoDS::Edge(it.Current()), face);
    if (!use || BRep_Tool::Tolerance(use->edge) <= kLooseTolerance) continue;
    const double gap = largest_gap(*use, surface);
    if (gap <= kLooseTolerance) continue;
    if (gap <= kShare * length_of(*use) && !unseen.Contains(use->edge)) continue;
    const Handle(Geom2d_Curve) better = better_image(*use, surface, gap);
    if (!better.IsNull()) found.push_back({*use, better, gap});
  }
  return found;
}

// Remakes the loose curves of one face.
std::vector<RemadeImage> remake(const TopoDS_Face& face, const TopTools_IndexedMapOfShape& unseen,
                                const Stop& stop) {
  const std::vector<Better> better = better_images(face, unseen, stop);
  if (better.empty()) return {};
  const auto set = [&](const Use& use, const Handle(Geom2d_Curve) & chart) {
    BRep_Builder().UpdateEdge(use.edge, chart, face, BRep_Tool::Tolerance(use.edge));
  };
  const bool was_valid = BRepCheck_Analyzer(face).IsValid();
  for (const Better& each : better) set(each.given, each.chart);
  if (was_valid && !BRepCheck_Analyzer(face).IsValid()) {
    for (const Better& each : better) set(each.given, each.given.chart);
    return {};
  }
  std::vector<RemadeImage> made;
  for (const Better& each : better) made.push_back({face, each.given.edge, each.gap});
  return made;
}

// Lowers the tolerances of edges and vertices, unless a face is less valid for it.
class Lowering {
 public:
  explicit Lowering(const Stop& stop) : stop_(stop) {}

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
        if (checked_.Add(face) && !is_valid(face)) invalid.Add(face);
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

  bool is_valid(const TopoDS_Shape& face) const {
    if (stop_) stop_();
    return BRepCheck_Analyzer(face).IsValid();
  }

  bool are_valid(const TopTools_ListOfShape& faces) const {
    return std::all_of(faces.begin(), faces.end(),
                       [this](const TopoDS_Shape& face) { return is_valid(face); });
  }

  const Stop& stop_;
  std::vector<Part> parts_;
  TopTools_MapOfShape checked_;
};

void tighten_edges(const TopTools_IndexedMapOfShape& remade, const SharedParts& parts,
                   Lowering& lowering) {
  for (int i = 1; i <= remade.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(remade(i));
    const TopTools_ListOfShape& faces = parts.faces_of_edges.FindFromKey(edge);
    const double needed = needed_tolerance(edge, faces);
    lowering.add(
        Handle(BRep_TEdge)::DownCast(edge.TShape()), [needed] { return needed; }, faces);
  }
}

// What the ends of the edges at a vertex ask for.
double needed_at(const TopoDS_Vertex& vertex, const SharedParts& parts) {
  double needed = Precision::Confusion();
  for (const TopoDS_Shape& each : parts.edges_of_vertices.FindFromKey(vertex)) {
    const TopoDS_Edge edge = TopoDS::Edge(each);
    const TopTools_ListOfShape& faces = parts.faces_of_edges.FindFromKey(edge);
    for (TopoDS_Iterator end(edge.Oriented(TopAbs_FORWARD)); end.More(); end.Next())
      if (end.Value().IsSame(vertex))
        needed = std::max({needed, BRep_Tool::Tolerance(edge),
                           distance_at(TopoDS::Vertex(end.Value()), edge, faces)});
  }
  return kSampledMargin * needed;
}

// Those of the remade edges.
void tighten_vertices(const TopTools_IndexedMapOfShape& remade, const SharedParts& parts,
                      Lowering& lowering) {
  TopTools_IndexedMapOfShape ends;
  for (int i = 1; i <= remade.Extent(); ++i) TopExp::MapShapes(remade(i), TopAbs_VERTEX, ends);
  for (int i = 1; i <= ends.Extent(); ++i) {
    const TopoDS_Vertex vertex = TopoDS::Vertex(ends(i));
    if (BRep_Tool::Tolerance(vertex) <= kLooseTolerance) continue;
    lowering.add(
        Handle(BRep_TVertex)::DownCast(vertex.TShape()),
        [vertex, &parts] { return needed_at(vertex, parts); },
        parts.faces_of_vertices.FindFromKey(vertex));
  }
}

}  // namespace

std::vector<RemadeImage> remake_loose_images(const std::vector<TopoDS_Face>& faces,
                                             const SharedParts& parts,
                                             const TopTools_IndexedMapOfShape& unseen,
                                             const Stop& stop) {
  std::vector<RemadeImage> all;
  TopTools_IndexedMapOfShape remade;
  for (const TopoDS_Face& face : faces)
    for (RemadeImage& made : remake(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), unseen, stop)) {
      remade.Add(made.edge);
      all.push_back(std::move(made));
    }
  if (all.empty()) return all;
  Lowering lowering(stop);
  tighten_edges(remade, parts, lowering);
  tighten_vertices(remade, parts, lowering);
  lowering.settle();
  return all;
}

}  // namespace blossom::occt
