// SPDX-License-Identifier: LGPL-2.1-or-later
// Models from STEP files, and the damage that Open CASCADE reads over.

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include <BRep_Tool.hxx>
#include <Interface_Check.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Controller.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_BSplineCurveWithKnots.hxx>
#include <StepGeom_BSplineCurveWithKnotsAndRationalBSplineCurve.hxx>
#include <StepGeom_BSplineSurfaceWithKnots.hxx>
#include <StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface.hxx>
#include <StepGeom_SphericalSurface.hxx>
#include <StepShape_Edge.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <TColStd_HArray1OfInteger.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColStd_HArray2OfReal.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "adapters/occt/errors.h"
#include "adapters/occt/shapes/shapes_detail.h"

namespace blossom::occt {
namespace {

/// The first failure that concerns more than a name; names are odd in many good files.
std::string failure_of(const Interface_Check& check) {
  for (int i = 1; i <= check.NbFails(); ++i)
    if (const std::string fail = check.CFail(i); fail.find("(name)") == std::string::npos)
      return fail;
  return {};
}

/// The number of control points that the knots ask for is the number that is there.
std::string miscount(const Handle(TColStd_HArray1OfInteger) & multiplicities, int degree,
                     int points) {
  if (multiplicities.IsNull()) return "it has no knots";
  const int knots = std::accumulate(multiplicities->begin(), multiplicities->end(), 0);
  if (knots == points + degree + 1) return {};
  return std::to_string(knots) + " knots of degree " + std::to_string(degree) + " do not fit " +
         std::to_string(points) + " control points";
}

std::string weight_fault(double weight) {
  return weight > 0 ? "" : "a weight is " + std::to_string(weight) + ", weights must be positive";
}

template <class Surface>
std::string surface_miscount(const Surface& s) {
  const std::string u = miscount(s.UMultiplicities(), s.UDegree(), s.NbControlPointsListI());
  return u.empty() ? miscount(s.VMultiplicities(), s.VDegree(), s.NbControlPointsListJ()) : u;
}

template <class Curve>
std::string curve_miscount(const Curve& c) {
  return miscount(c.KnotMultiplicities(), c.Degree(), c.NbControlPointsList());
}

std::string rational_fault(
    const StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface& surface) {
  std::string fault = surface_miscount(surface);
  const Handle(TColStd_HArray2OfReal) weights = surface.WeightsData();
  if (weights.IsNull()) return fault.empty() ? "it has no weights" : fault;
  for (int i = 1; i <= weights->ColLength() && fault.empty(); ++i)
    for (int j = 1; j <= weights->RowLength() && fault.empty(); ++j)
      fault = weight_fault(weights->Value(i, j));
  return fault;
}

std::string rational_fault(const StepGeom_BSplineCurveWithKnotsAndRationalBSplineCurve& curve) {
  std::string fault = curve_miscount(curve);
  const Handle(TColStd_HArray1OfReal) weights = curve.WeightsData();
  if (weights.IsNull()) return fault.empty() ? "it has no weights" : fault;
  for (int i = 1; i <= weights->Length() && fault.empty(); ++i)
    fault = weight_fault(weights->Value(i));
  return fault;
}

/// What is wrong with the counts and weights of a B-spline; nothing for other entities.
std::string spline_fault(const Standard_Transient& entity) {
  if (const auto* s = dynamic_cast<const StepGeom_BSplineSurfaceWithKnots*>(&entity))
    return surface_miscount(*s);
  if (const auto* c = dynamic_cast<const StepGeom_BSplineCurveWithKnots*>(&entity))
    return curve_miscount(*c);
  if (const auto* s =
          dynamic_cast<const StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface*>(&entity))
    return rational_fault(*s);
  if (const auto* c =
          dynamic_cast<const StepGeom_BSplineCurveWithKnotsAndRationalBSplineCurve*>(&entity))
    return rational_fault(*c);
  return {};
}

/// Refuses geometry and topology that came in damaged: a coordinate that is no number, a point
/// where a curve should be, a row of control points that is not there. Other entities may be odd;
/// many files have some.
void check_entities(const Interface_InterfaceModel& model) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const Handle(Standard_Transient)& entity = model.Value(i);
    const std::string type = entity->DynamicType()->Name();
    if (!type.starts_with("StepGeom_") && !type.starts_with("StepShape_")) continue;
    const Handle(Interface_Check)& check = model.Check(i, true);
    std::string cause = check.IsNull() || !check->HasFailed() ? "" : failure_of(*check);
    if (cause.empty()) cause = spline_fault(*entity);
    if (cause.empty()) continue;
    const std::string label = model.StringLabel(entity)->ToCString();
    throw BadModel("is damaged: " + label + " (" + type.substr(type.find('_') + 1) + "): " + cause);
  }
}

/// How many edges the loops of a face use once in each direction, as seams.
int seams_of(const StepShape_FaceSurface& face) {
  std::map<const Standard_Transient*, int> uses;
  for (int i = 1; i <= face.NbBounds(); ++i) {
    const auto loop = Handle(StepShape_EdgeLoop)::DownCast(face.BoundsValue(i)->Bound());
    for (int k = 1; !loop.IsNull() && k <= loop->NbEdgeList(); ++k)
      ++uses[loop->EdgeListValue(k)->EdgeElement().get()];
  }
  return static_cast<int>(
      std::count_if(uses.begin(), uses.end(), [](const auto& use) { return use.second == 2; }));
}

/// Open CASCADE takes a seam that runs from a border to a pole of a sphere and back for a notch,
/// and then turns the border round: what is left is the part of the sphere that was missing.
bool is_turned_round(const StepShape_FaceSurface& face, const TopoDS_Shape& made) {
  if (!face.FaceGeometry()->IsKind(STANDARD_TYPE(StepGeom_SphericalSurface))) return false;
  if (made.ShapeType() != TopAbs_FACE || seams_of(face) == 0) return false;
  for (TopExp_Explorer it(made, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, TopoDS::Face(made))) return false;
  }
  return true;
}

/// Entities of one fault, and the first of them.
struct Faulty {
  int count = 0;
  std::string first;

  void add(const Interface_InterfaceModel& model, const Handle(Standard_Transient) & entity) {
    if (count++ == 0) first = model.StringLabel(entity)->ToCString();
  }
  void tell(const std::filesystem::path& file, const std::string& what) const {
    if (count == 0) return;
    const std::string text =
        file.string() + ": " + std::to_string(count) + " faces " + what + ", the first is " + first;
    Message::SendWarning(text.c_str());
  }
};

/// Faces that Open CASCADE could not make, or not as they are in the file: the model can be used
/// without them, but not silently.
void tell_lost_faces(const XSControl_WorkSession& session, const std::filesystem::path& file) {
  const Handle(Interface_InterfaceModel)& model = session.Model();
  const Handle(Transfer_TransientProcess)& made = session.TransferReader()->TransientProcess();
  Faulty lost, turned;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient)& entity = model->Value(i);
    const auto face = Handle(StepShape_FaceSurface)::DownCast(entity);
    if (face.IsNull()) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(made, entity);
    if (shape.IsNull())
      lost.add(*model, entity);
    else if (is_turned_round(*face, shape))
      turned.add(*model, entity);
  }
  lost.tell(file, "cannot be made and are left out");
  turned.tell(file,
              "on spheres are not what the file says: Open CASCADE takes their border for that of "
              "the rest of the sphere");
}

}  // namespace

std::string unit_named(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::pair<const char*, const char*> words[] = {
      {"milli", "MM"}, {"mm", "MM"},    {"centi", "CM"}, {"cm", "CM"},     {"kilo", "KM"},
      {"km", "KM"},    {"micro", "UM"}, {"um", "UM"},    {"inch", "INCH"}, {"foot", "FT"},
      {"feet", "FT"},  {"ft", "FT"},    {"mile", "MI"},  {"mil", "MIL"},   {"in", "INCH"},
      {"mi", "MI"},    {"uin", "UIN"},  {"m", "M"}};
  for (const auto& [word, unit] : words)
    if (name.starts_with(word)) return unit;
  return "MM";
}

void read_step(Document& document, const std::filesystem::path& file) {
  STEPControl_Controller::Init();
  STEPCAFControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  reader.SetPropsMode(true);
  reader.SetGDTMode(true);
  reader.SetMatMode(true);
  reader.SetViewMode(true);
  reader.SetSHUOMode(true);  // styles of single instances
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) throw BadModel("is no readable STEP file");
  check_entities(*reader.ChangeReader().Model());
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
  if (!lengths.IsEmpty()) document.unit = unit_named(lengths.First().ToCString());
  Handle(TDocStd_Document) target = document.handle();
  if (!reader.Transfer(target)) throw BadModel("holds no shape");
  tell_lost_faces(*reader.Reader().WS(), file);
}

}  // namespace blossom::occt
