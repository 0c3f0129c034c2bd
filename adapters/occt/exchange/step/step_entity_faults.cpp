// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_entity_faults.h"

#include <cstddef>
#include <cstring>
#include <numeric>
#include <string_view>

#include <Interface_Check.hxx>
#include <StepGeom_BSplineCurveWithKnots.hxx>
#include <StepGeom_BSplineCurveWithKnotsAndRationalBSplineCurve.hxx>
#include <StepGeom_BSplineSurfaceWithKnots.hxx>
#include <StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepRepr_ItemDefinedTransformation.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_RepresentationRelationship.hxx>
#include <StepShape_ContextDependentShapeRepresentation.hxx>
#include <StepShape_PolyLoop.hxx>
#include <StepShape_VertexPoint.hxx>
#include <TColStd_HArray1OfInteger.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColStd_HArray2OfReal.hxx>

#include "adapters/occt/convert/curves_detail.h"

namespace blossom::occt {
namespace {

using Entity = Handle(Standard_Transient);

bool is_of(const Entity& entity, const char* room) {
  return std::strncmp(entity->DynamicType()->Name(), room, std::strlen(room)) == 0;
}

/// Units of lengths and of angles, and what says which of them hold. Without these, lengths are
/// taken as millimetres and angles as radians.
bool is_unit(const Entity& entity) {
  const std::string_view type = entity->DynamicType()->Name();
  const auto names = [&](std::string_view word) {
    return type.find(word) != std::string_view::npos;
  };
  return names("LengthUnit") || names("LengthMeasureWithUnit") || names("PlaneAngleUnit") ||
         names("PlaneAngleMeasureWithUnit") || names("GlobalUnitAssigned") || names("GlobUnitAss");
}

constexpr std::string_view kCountFault = "Count of Parameters is not ";

/// Open CASCADE says "Parameter n0.3 (edge_end) : Unresolved reference", or of an entity that has
/// none of its fields then, "Count of Parameters is not 4 for edge_curve".
Fault in_words(std::string_view fail) {
  constexpr auto npos = std::string_view::npos;
  if (fail.starts_with(kCountFault)) {
    const std::string_view rest = fail.substr(kCountFault.size());
    return {"it does not have " + std::string(rest.substr(0, rest.find(' '))) + " parameters",
            Harm::Field};
  }
  const std::size_t open = fail.find('('), close = fail.find(')');
  const std::string field = fail.starts_with("Parameter") && open != npos && close != npos
                                ? std::string(fail.substr(open + 1, close - open - 1))
                                : "";
  if (field.empty()) return {std::string(fail)};
  if (fail.find("Unresolved") != npos) return {field + " is not in the file", Harm::Field, true};
  if (fail.find("illegal type") != npos) return {field + " is of another kind", Harm::Field};
  if (fail.find("not an Entity") != npos) return {field + " is missing", Harm::Field};
  for (const char* number : {"Real", "Integer", "number"})
    if (fail.find(std::string(" ") + number) != npos)  // 0 of coordinates
      return {field + " is no number", Harm::Field, false, field != "coordinates", true};
  for (const char* list : {"LIST", "List", "list", "Count"})
    if (fail.find(list) != npos) return {field + " is no list of the right length", Harm::Field};
  return {field + " cannot be read"};
}

/// "(BOUNDED_CURVE()B_SPLINE_CURVE(...)...)".
bool is_complex(const StepData_StepModel& model, const Entity& entity) {
  return model.TypeName(entity, false)[0] == '(';
}

/// The worst of what loading says. Names are odd in many good files.
/// in_parts   of a complex entity: if the count of one part is wrong, the others are there
Fault loading_fault(const Interface_Check& check, bool in_parts) {
  Fault worst;
  for (int i = 1; i <= check.NbFails(); ++i) {
    const std::string_view fail = check.CFail(i);
    if (fail.find("(name)") != std::string_view::npos) continue;
    Fault fault = in_words(fail);
    if (in_parts && fail.starts_with(kCountFault)) fault.harm = Harm::None;
    if (worst.cause.empty() || (worst.harm == Harm::None && fault.harm == Harm::Field))
      worst = fault;
  }
  return worst;
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
  if (surface.BSplineSurfaceWithKnots().IsNull() || surface.RationalBSplineSurface().IsNull())
    return "it has no fields";
  std::string fault = surface_miscount(surface);
  const Handle(TColStd_HArray2OfReal) weights = surface.WeightsData();
  if (weights.IsNull()) return fault.empty() ? "it has no weights" : fault;
  for (int i = 1; i <= weights->ColLength() && fault.empty(); ++i)
    for (int j = 1; j <= weights->RowLength() && fault.empty(); ++j)
      fault = weight_fault(weights->Value(i, j));
  return fault;
}

std::string rational_fault(const StepGeom_BSplineCurveWithKnotsAndRationalBSplineCurve& curve) {
  if (curve.BSplineCurveWithKnots().IsNull() || curve.RationalBSplineCurve().IsNull())
    return "it has no fields";
  std::string fault = curve_miscount(curve);
  const Handle(TColStd_HArray1OfReal) weights = curve.WeightsData();
  if (weights.IsNull()) return fault.empty() ? "it has no weights" : fault;
  for (int i = 1; i <= weights->Length() && fault.empty(); ++i)
    fault = weight_fault(weights->Value(i));
  return fault;
}

/// Open CASCADE takes a corner for a point in space without asking.
std::string corner_fault(const StepShape_VertexPoint& vertex) {
  const auto point = Handle(StepGeom_CartesianPoint)::DownCast(vertex.VertexGeometry());
  if (point.IsNull()) return "its point is missing";
  if (point->NbCoordinates() == 3) return {};
  return "its point has " + std::to_string(point->NbCoordinates()) + " coordinates instead of 3";
}

/// Likewise the corners of a loop of lines.
std::string polygon_fault(const StepShape_PolyLoop& loop) {
  for (int i = 1; i <= loop.NbPolygon(); ++i) {
    const Handle(StepGeom_CartesianPoint) point = loop.PolygonValue(i);
    if (point.IsNull() || point->NbCoordinates() != 3)
      return "corner " + std::to_string(i) + " has no 3 coordinates";
  }
  return {};
}

std::string place_fault(const StepGeom_CartesianPoint& point) {
  for (int i = 1; i <= point.NbCoordinates(); ++i)
    if (!is_bounded({point.CoordinatesValue(i), 0, 0})) return "a coordinate is not finite";
  return {};
}

/// Of a curve in parameters: Open CASCADE takes the first item for it without asking.
std::string planar_fault(const StepRepr_DefinitionalRepresentation& planar) {
  const bool has_curve =
      planar.NbItems() > 0 && !Handle(StepGeom_Curve)::DownCast(planar.ItemsValue(1)).IsNull();
  return has_curve ? "" : "it has no curve";
}

/// What is wrong with an entity that Open CASCADE loads without a word; nothing for most.
std::string silent_fault(const Standard_Transient& entity) {
  if (const auto* p = dynamic_cast<const StepGeom_CartesianPoint*>(&entity)) return place_fault(*p);
  if (const auto* v = dynamic_cast<const StepShape_VertexPoint*>(&entity)) return corner_fault(*v);
  if (const auto* l = dynamic_cast<const StepShape_PolyLoop*>(&entity)) return polygon_fault(*l);
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
  if (const auto* planar = dynamic_cast<const StepRepr_DefinitionalRepresentation*>(&entity))
    return planar_fault(*planar);
  return {};
}

}  // namespace

bool is_geometry(const Entity& entity) {
  return is_of(entity, "StepGeom_") || is_of(entity, "StepShape_") ||
         entity->IsKind(STANDARD_TYPE(StepRepr_DefinitionalRepresentation));
}

bool is_assembly(const Entity& entity) {
  return entity->IsKind(STANDARD_TYPE(StepRepr_NextAssemblyUsageOccurrence)) ||
         entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationRelationship)) ||
         entity->IsKind(STANDARD_TYPE(StepRepr_ItemDefinedTransformation)) ||
         entity->IsKind(STANDARD_TYPE(StepRepr_MappedItem)) ||
         entity->IsKind(STANDARD_TYPE(StepShape_ContextDependentShapeRepresentation));
}

bool loses_unit(const Entity& entity, const Fault& fault) {
  return is_unit(entity) && !fault.cause.starts_with("dimensions") && fault.harm == Harm::Field;
}

Fault fault_of(const StepData_StepModel& model, int number) {
  const Handle(Interface_Check) check = model.Check(number, true);
  const Entity& entity = model.Value(number);
  Fault fault;
  if (!check.IsNull() && check->HasFailed())
    fault = loading_fault(*check, is_complex(model, entity));
  if (loses_unit(entity, fault)) fault.cause += ": lengths or angles may be wrong";
  if (fault.harm == Harm::Field || !is_geometry(entity)) return fault;
  if (const std::string silent = silent_fault(*entity); !silent.empty())
    return {silent, Harm::Field, false, entity->IsKind(STANDARD_TYPE(StepShape_PolyLoop)),
            entity->IsKind(STANDARD_TYPE(StepGeom_Point))};
  return fault;
}

}  // namespace blossom::occt
