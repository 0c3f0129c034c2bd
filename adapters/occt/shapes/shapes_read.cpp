// SPDX-License-Identifier: LGPL-2.1-or-later
// Models from STEP, IGES and BREP files.

#include <cmath>
#include <fstream>
#include <new>
#include <sstream>
#include <string>
#include <utility>

#include <BRep_CurveRepresentation.hxx>
#include <BRep_ListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/errors.h"
#include "adapters/occt/forms/curves_detail.h"
#include "adapters/occt/forms/surfaces_detail.h"
#include "adapters/occt/shapes/edge_tolerances.h"
#include "adapters/occt/shapes/loose_images.h"
#include "adapters/occt/shapes/shapes_detail.h"

namespace blossom::occt {
namespace {

std::string content_of(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) throw BadModel("no such file");
  if (error) throw BadModel("cannot be opened: " + error.message());
  if (fs::is_directory(status)) throw BadModel("is a folder");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw BadModel("cannot be opened for reading");
  std::ostringstream text;
  text << in.rdbuf();
  if (in.bad()) throw BadModel("cannot be read to its end");
  return std::move(text).str();
}

void read_iges(Document& document, const std::filesystem::path& file) {
  IGESControl_Controller::Init();
  IGESCAFControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) throw BadModel("is no readable IGES file");
  const auto model = Handle(IGESData_IGESModel)::DownCast(reader.Model());
  const Handle(TCollection_HAsciiString) unit = model->GlobalSection().UnitName();
  if (!unit.IsNull()) document.unit = unit_named(unit->ToCString());
  Handle(TDocStd_Document) target = document.handle();
  if (!reader.Transfer(target)) throw BadModel("holds no shape");
}

/// Returns why a surface was left out; empty when all is well.
std::string read_into(Document& document, Format format, const std::filesystem::path& file,
                      const std::string& text) {
  switch (format) {
    case Format::Step: read_step(document, file); break;
    case Format::Iges: read_iges(document, file); break;
    case Format::Brep: return read_brep(document, text);
  }
  return {};
}

/// Runs the check of one numbered piece of the model and puts its name before the cause.
template <class Check>
void named(const char* kind, int number, Check&& check) {
  try {
    guarded("reading its numbers", std::forward<Check>(check));
  } catch (const std::runtime_error& error) {
    throw BadModel(std::string(kind) + " " + std::to_string(number) + ": " + error.what());
  }
}

void check_tolerance(double tolerance) {
  if (!(std::isfinite(tolerance) && tolerance >= 0))
    throw BadModel("its tolerance is " + std::to_string(tolerance));
}

void check_face(const TopoDS_Face& face, const std::string& notes) {
  TopLoc_Location location;
  const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, location);
  if (surface.IsNull())
    throw BadModel(notes.empty() ? "it has no surface" : "its surface cannot be read: " + notes);
  check_numbers(*surface);
  check_tolerance(BRep_Tool::Tolerance(face));
}

void check_planar_numbers(const Geom2d_Curve& curve) {
  const auto check = [](const gp_Pnt2d& point, double weight) {
    check_finite({point.X(), point.Y(), 0}, "a point of its curve in a face's parameters");
    check_weight(weight, "a weight of its curve in a face's parameters");
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
}

void check_curves_in_faces(const TopoDS_Edge& edge) {
  const auto* shape = dynamic_cast<const BRep_TEdge*>(edge.TShape().get());
  if (shape == nullptr) return;
  for (const Handle(BRep_CurveRepresentation) & curve : shape->Curves()) {
    if (!curve->IsCurveOnSurface() || curve->PCurve().IsNull()) continue;
    check_planar_numbers(*curve->PCurve());
    if (curve->IsCurveOnClosedSurface() && !curve->PCurve2().IsNull())
      check_planar_numbers(*curve->PCurve2());
  }
}

void check_edge(const TopoDS_Edge& edge) {
  check_tolerance(BRep_Tool::Tolerance(edge));
  check_curves_in_faces(edge);
  TopLoc_Location location;
  double first = 0, last = 0;
  const Handle(Geom_Curve)& curve = BRep_Tool::Curve(edge, location, first, last);
  if (curve.IsNull()) return;
  check_numbers(*curve);
  check_finite({first, last, 0}, "its range");
}

void check_vertex(const TopoDS_Vertex& vertex) {
  check_finite(BRep_Tool::Pnt(vertex).XYZ(), "its point");
  check_tolerance(BRep_Tool::Tolerance(vertex));
}

/// Every face has a surface, and all numbers of surfaces, curves and points are numbers.
void check_geometry(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces,
                    const std::string& notes) {
  for (int i = 1; i <= faces.Extent(); ++i)
    named("face", i, [&] { check_face(TopoDS::Face(faces(i)), notes); });
  TopTools_IndexedMapOfShape edges, vertices;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i)
    named("edge", i, [&] { check_edge(TopoDS::Edge(edges(i))); });
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  for (int i = 1; i <= vertices.Extent(); ++i)
    named("vertex", i, [&] { check_vertex(TopoDS::Vertex(vertices(i))); });
}

void tell(const RaisedTolerances& raised, const std::filesystem::path& file) {
  const int count = raised.edges.Extent() + raised.vertices.Extent();
  if (count == 0) return;
  std::ostringstream text;
  text << file.string() << ": " << count << " edges and vertices get tolerances of up to "
       << raised.largest()
       << ", since curves are farther apart than Open CASCADE measured at a few points";
  Message::SendInfo(text.str().c_str());
}

/// Only BREP files state tolerances; others have those that Open CASCADE's readers find.
void heal(const TopoDS_Shape& shape, Format format, const std::filesystem::path& file) {
  RaisedTolerances raised;
  if (format != Format::Brep) raised = raise_tolerances(shape);
  if (const RemadeImages made = remake_loose_images(shape, raised.edges); made.count > 0) {
    std::ostringstream text;
    text << file.string() << ": " << made.count << " curves in the parameters of faces are up to "
         << made.worst << " off those in space, which lie on the faces; they are made anew";
    Message::SendWarning(text.str().c_str());
  }
  tell(raised, file);
  const int missing = count_missing_curves(shape);
  if (missing == 0) return;
  add_missing_curves(shape);
  const int left = count_missing_curves(shape);
  const std::string text = file.string() + ": " + std::to_string(missing) +
                           " edges have no curve in the parameters of their face; " +
                           std::to_string(missing - left) + " are made from their curves in space";
  Message::SendWarning(text.c_str());
}

bool is_empty(const TopoDS_Shape& shape) {
  return shape.IsNull() || (shape.ShapeType() != TopAbs_VERTEX && !TopoDS_Iterator(shape).More());
}

}  // namespace

Model read_model(const std::filesystem::path& file) {
  const Format format = format_of(file);
  const std::lock_guard guard(exchange_lock());
  Model model;
  try {
    guarded("reading", [&] {
      const std::string text = content_of(file);
      check_whole(format, text);
      const std::string notes = read_into(model.impl_->document, format, file, text);
      model.impl_->refresh();
      if (is_empty(model.shape())) throw BadModel("holds no shape");
      check_geometry(model.shape(), model.impl_->faces, notes);
      heal(model.shape(), format, file);
    });
  } catch (const std::runtime_error& error) {
    throw BadModel(file.string() + ": " + error.what());
  } catch (const std::bad_alloc&) {
    throw BadModel(file.string() + ": asks for more memory than there is; perhaps it is damaged");
  }
  model.impl_->file = file;
  return model;
}

}  // namespace blossom::occt
