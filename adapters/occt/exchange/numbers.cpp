// SPDX-License-Identifier: LGPL-2.1-or-later
// What is bad is left out, with the faces that it bounds, and the rest is used.

#include "adapters/occt/exchange/numbers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <BRepTools_ReShape.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_ListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves_detail.h"
#include "adapters/occt/convert/surfaces_detail.h"
#include "adapters/occt/exchange/detail.h"
#include "adapters/occt/exchange/places.h"

namespace blossom::occt {
namespace {

void check_tolerance(double tolerance) {
  if (!(std::isfinite(tolerance) && tolerance >= 0))
    throw BadModel("its tolerance is " + std::to_string(tolerance));
}

void check_face(const TopoDS_Face& face, const NumberSource& source) {
  check_place(face);
  TopLoc_Location location;
  const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, location);
  if (surface.IsNull()) {
    const std::string why = source.without_surface();
    if (!why.empty()) throw BadModel("its surface cannot be read: " + why);
    const bool triangles = !BRep_Tool::Triangulation(face, location).IsNull();
    throw BadModel(triangles ? "it has triangles and no surface" : "it has no surface");
  }
  check_inner_place(location, "its surface");
  check_numbers(*surface);
  check_tolerance(BRep_Tool::Tolerance(face));
}

void check_planar_numbers(const Geom2d_Curve& curve) {
  WeightRange weights;
  const auto check = [&](const gp_Pnt2d& point, double weight) {
    check_finite({point.X(), point.Y(), 0}, "a point of its curve in a face's parameters");
    check_weight(weight, "a weight of its curve in a face's parameters");
    weights.add(weight);
  };
  if (const auto* spline = dynamic_cast<const Geom2d_BSplineCurve*>(&curve)) {
    for (int i = 1; i <= spline->NbPoles(); ++i) check(spline->Pole(i), spline->Weight(i));
    for (int i = 1; i <= spline->NbKnots(); ++i)
      check_finite({spline->Knot(i), 0, 0}, "a knot of its curve in a face's parameters");
  } else if (const auto* bezier = dynamic_cast<const Geom2d_BezierCurve*>(&curve)) {
    for (int i = 1; i <= bezier->NbPoles(); ++i) check(bezier->Pole(i), bezier->Weight(i));
  } else if (const auto* trimmed = dynamic_cast<const Geom2d_TrimmedCurve*>(&curve)) {
    check_planar_numbers(*trimmed->BasisCurve());
  } else if (const auto* offset = dynamic_cast<const Geom2d_OffsetCurve*>(&curve)) {
    check_finite({offset->Offset(), 0, 0}, "the offset of its curve in a face's parameters");
    check_planar_numbers(*offset->BasisCurve());
  } else {
    check(curve.Value(0.5), 1);
  }
  weights.check();
}

void check_range(double first, double last) {
  check_finite({first, last, 0}, "its range");
  if (first > last) throw BadModel("its range runs backwards");
}

void check_representation(const BRep_CurveRepresentation& curve, const NumberSource& source,
                          bool has_curve) {
  check_inner_place(curve.Location(), "a curve of it");
  if (const auto* ranged = dynamic_cast<const BRep_GCurve*>(&curve))
    check_range(ranged->First(), ranged->Last());
  // A BREP file names the curve then, and Open CASCADE takes none for it.
  const bool told = source.names_curves();
  if (curve.IsCurve3D()) {
    if (told && has_curve && curve.Curve3D().IsNull())
      throw BadModel("the numbers of its curve make no curve");
    return;
  }
  if (!curve.IsCurveOnSurface()) return;
  if (curve.PCurve().IsNull()) {
    if (told) throw BadModel("the numbers of its curve in a face's parameters make no curve");
    return;
  }
  check_planar_numbers(*curve.PCurve());
  if (curve.IsCurveOnClosedSurface() && !curve.PCurve2().IsNull())
    check_planar_numbers(*curve.PCurve2());
}

void check_edge(const TopoDS_Edge& edge, const NumberSource& source) {
  check_place(edge);
  check_tolerance(BRep_Tool::Tolerance(edge));
  const bool has_curve = !BRep_Tool::Degenerated(edge);
  if (const auto* shape = dynamic_cast<const BRep_TEdge*>(edge.TShape().get()))
    for (const Handle(BRep_CurveRepresentation) & curve : shape->Curves())
      check_representation(*curve, source, has_curve);
  TopLoc_Location location;
  double first = 0, last = 0;
  const Handle(Geom_Curve)& curve = BRep_Tool::Curve(edge, location, first, last);
  if (curve.IsNull()) {
    if (has_curve && source.loses_curves())
      throw BadModel("the numbers of its curve make no curve");
    return;
  }
  check_numbers(*curve);
}

void check_vertex(const TopoDS_Vertex& vertex) {
  check_place(vertex);
  check_bounded(BRep_Tool::Pnt(vertex).XYZ(), "its point");
  check_tolerance(BRep_Tool::Tolerance(vertex));
}

/// What is wrong with one piece of a model; nothing if all is well.
template <class Check>
std::string fault_of(Check&& check) {
  try {
    check();
    return {};
  } catch (const Standard_Failure&) {
    return current_failure_text();
  } catch (const BadModel& bad) {
    return bad.what();
  }
}

}  // namespace

std::string NumberSource::without_surface() const {
  return brep_ == nullptr ? std::string() : why_without_surface(*brep_);
}

bool NumberSource::loses_curves() const {
  if (!lost_curves_) lost_curves_ = brep_ != nullptr && occt::loses_curves(*brep_);
  return *lost_curves_;
}

BadShapes::BadShapes(const TopoDS_Shape& part, const NumberSource& source) {
  TopTools_IndexedMapOfShape edges, vertices;
  TopExp::MapShapes(part, TopAbs_FACE, faces_);
  for (int i = 1; i <= faces_.Extent(); ++i)
    add("face", i, faces_(i), fault_of([&] { check_face(TopoDS::Face(faces_(i)), source); }));
  TopExp::MapShapes(part, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i)
    add("edge", i, edges(i), fault_of([&] { check_edge(TopoDS::Edge(edges(i)), source); }));
  TopExp::MapShapes(part, TopAbs_VERTEX, vertices);
  for (int i = 1; i <= vertices.Extent(); ++i)
    add("vertex", i, vertices(i), fault_of([&] { check_vertex(TopoDS::Vertex(vertices(i))); }));
  if (!bad_.empty()) find_faces(part);
}

std::vector<Replacement> BadShapes::removals() const {
  std::vector<Replacement> list;
  for (const auto& [number, cause] : lost_) list.push_back({TopoDS::Face(faces_(number)), {}});
  return list;
}

TopoDS_Shape BadShapes::without_loose(const TopoDS_Shape& part) const {
  BRepTools_ReShape without;
  for (const Bad& bad : bad_)
    if (bad.loose) without.Remove(bad.shape);
  return without.Apply(part);
}

bool BadShapes::any_loose() const {
  return std::ranges::any_of(bad_, [](const Bad& bad) { return bad.loose; });
}

void BadShapes::list(const std::string& part, ReadingReport& report) const {
  const std::vector<std::string> owner =
      part.empty() ? std::vector<std::string>() : std::vector{"part '" + part + "'"};
  for (const auto& [number, cause] : lost_)
    report.add({"face", cause, true, 1, {"face " + std::to_string(number)}, owner});
  for (const Bad& bad : bad_)
    if (bad.loose) report.add({bad.kind, bad.cause, true, 1, {bad.label()}, owner});
}

void BadShapes::add(const char* kind, int number, const TopoDS_Shape& shape,
                    const std::string& cause) {
  if (!cause.empty()) bad_.push_back({kind, number, shape, cause});
}

void BadShapes::find_faces(const TopoDS_Shape& part) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(part, TopAbs_EDGE, TopAbs_FACE, faces);
  TopExp::MapShapesAndAncestors(part, TopAbs_VERTEX, TopAbs_FACE, faces);
  for (Bad& bad : bad_) {
    if (bad.shape.ShapeType() == TopAbs_FACE) {
      lost_.try_emplace(bad.number, bad.cause);
      continue;
    }
    const TopTools_ListOfShape* bounded = faces.Seek(bad.shape);
    bad.loose = bounded == nullptr || bounded->IsEmpty();
    if (bad.loose) continue;
    for (const TopoDS_Shape& face : *bounded)
      lost_.try_emplace(faces_.FindIndex(face), bad.label() + ": " + bad.cause);
  }
}

namespace {

/// Takes bad shapes out of a part; its shape is null if nothing is left.
void clean(PlainPart& part, const BadShapes& bad) {
  if (const std::vector<Replacement> removals = bad.removals(); !removals.empty()) {
    Rebuild rebuild(removals);
    part.shape = rebuild(part.shape);
    for (NamedShape& named : part.named)
      named.shape = rebuild.find(named.shape) == nullptr ? rebuild(named.shape) : TopoDS_Shape();
    std::erase_if(part.named, [](const NamedShape& named) { return named.shape.IsNull(); });
  }
  if (!part.shape.IsNull() && bad.any_loose()) part.shape = bad.without_loose(part.shape);
}

}  // namespace

void leave_out_bad_shapes(PlainParts& parts, const NumberSource& source, ReadingReport& report) {
  for (PlainPart& part : parts) {
    if (part.shape.IsNull()) continue;
    const BadShapes bad(part.shape, source);
    if (bad.none()) continue;
    bad.list(part.name, report);
    clean(part, bad);
  }
  std::erase_if(parts, [](const PlainPart& part) { return part.shape.IsNull(); });
}

}  // namespace blossom::occt
