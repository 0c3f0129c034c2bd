// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/info.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/base/surface_words.h"
#include "adapters/occt/faces/area.h"
#include "plugin/reports/text/number_text.h"

namespace blossom::reports {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kNoDirection = 1e-12;  // of an axis or a place: so small, a coordinate is 0

struct Counted {
  TopAbs_ShapeEnum kind;
  const char* one;
  const char* many;
};

constexpr std::array kCounted = {
    Counted{TopAbs_SOLID, "solid", "solids"}, Counted{TopAbs_SHELL, "shell", "shells"},
    Counted{TopAbs_FACE, "face", "faces"}, Counted{TopAbs_EDGE, "edge", "edges"},
    Counted{TopAbs_VERTEX, "vertex", "vertices"}};

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

// The point of an axis, a centre or a ring that a point of the surface, at `u`, belongs to.
gp_Pnt middle_of(const BRepAdaptor_Surface& surface, double u, const gp_Pnt& point) {
  const auto on_axis = [&](const gp_Ax1& axis) {
    return axis.Location().Translated(gp_Vec(axis.Direction()) *
                                      gp_Vec(axis.Location(), point).Dot(axis.Direction()));
  };
  if (surface.GetType() == GeomAbs_Cylinder) return on_axis(surface.Cylinder().Axis());
  if (surface.GetType() == GeomAbs_Cone) return on_axis(surface.Cone().Axis());
  if (surface.GetType() == GeomAbs_Sphere) return surface.Sphere().Location();
  const gp_Torus torus = surface.Torus();
  const gp_Ax3& frame = torus.Position();
  const gp_Vec outward =
      gp_Vec(frame.XDirection()) * std::cos(u) + gp_Vec(frame.YDirection()) * std::sin(u);
  return torus.Location().Translated(outward * torus.MajorRadius());
}

void measure_round(const BRepAdaptor_Surface& surface, const FaceFacts& face, bool reversed,
                   Measures& measures) {
  const auto place = [&](const gp_Ax1& axis) {
    measures.point = occt::vec(axis.Location());
    measures.direction = occt::vec(axis.Direction());
  };
  switch (surface.GetType()) {
    case GeomAbs_Cylinder:
      measures.radii = {surface.Cylinder().Radius()};
      place(surface.Cylinder().Axis());
      break;
    case GeomAbs_Cone:
      measures.half_angle = std::abs(surface.Cone().SemiAngle());
      place(surface.Cone().Axis());
      break;
    case GeomAbs_Sphere:
      measures.radii = {surface.Sphere().Radius()};
      measures.point = occt::vec(surface.Sphere().Location());
      break;
    case GeomAbs_Torus:
      measures.radii = {surface.Torus().MajorRadius(), surface.Torus().MinorRadius()};
      place(surface.Torus().Axis());
      break;
    default: return;
  }
  gp_Pnt point;
  gp_Vec du, dv;
  const double u = at(face.u, 0.5);
  surface.D1(u, at(face.v, 0.5), point, du, dv);
  const double outward = du.Crossed(dv).Dot(gp_Vec(middle_of(surface, u, point), point));
  measures.hollow = reversed ? outward > 0 : outward < 0;
}

void measure(const BRepAdaptor_Surface& surface, bool reversed, FaceFacts& face) {
  if (surface.GetType() != GeomAbs_Plane)
    return measure_round(surface, face, reversed, face.measures);
  const gp_Ax3 frame = surface.Plane().Position();
  const Vec3 normal = occt::vec(frame.Direction());
  face.measures.direction = (reversed == frame.Direct() ? -1.0 : 1.0) * normal;
}

std::optional<double> area_of(const TopoDS_Face& face) try {
  return occt::area(face);
} catch (const std::runtime_error&) {
  return std::nullopt;
}

FaceFacts face_facts(const TopoDS_Face& face, int number, std::vector<std::string> problems) {
  FaceFacts facts;
  facts.number = number;
  facts.problems = std::move(problems);
  facts.wires = count(face, TopAbs_WIRE);
  facts.edges = count(face, TopAbs_EDGE);
  facts.tolerance = BRep_Tool::Tolerance(face);
  if (BRep_Tool::Surface(face).IsNull()) {
    facts.surface = "none";
    return facts;
  }
  BRepTools::UVBounds(face, facts.u.from, facts.u.to, facts.v.from, facts.v.to);
  const BRepAdaptor_Surface surface(face, Standard_False);
  facts.surface = occt::surface_word(surface.GetType());
  if (surface.GetType() == GeomAbs_BezierSurface || surface.GetType() == GeomAbs_BSplineSurface) {
    const bool bezier = surface.GetType() == GeomAbs_BezierSurface;
    facts.degree_u = surface.UDegree();
    facts.degree_v = surface.VDegree();
    facts.spans_u = bezier ? 1 : surface.NbUKnots() - 1;
    facts.spans_v = bezier ? 1 : surface.NbVKnots() - 1;
    facts.rational = surface.IsURational() || surface.IsVRational();
  }
  facts.periodic_u = surface.IsUPeriodic();
  facts.periodic_v = surface.IsVPeriodic();
  measure(surface, face.Orientation() == TopAbs_REVERSED, facts);
  return facts;
}

// None of what has no vertex, or no end.
std::optional<occt::LeastBox> box_of(const TopoDS_Shape& shape,
                                     const std::function<bool()>& cancelled,
                                     occt::KeptForms* forms) try {
  return occt::least_box(shape, cancelled, forms);
} catch (const occt::BadModel&) {
  return std::nullopt;
}

void put_measures(const Measures& measures, Json& json) {
  if (measures.radii.size() == 1) json["radius"] = measures.radii.front();
  if (measures.radii.size() > 1) json["radii"] = measures.radii;
  if (measures.half_angle) json["half_angle"] = *measures.half_angle;
  const bool round = !measures.radii.empty() || measures.half_angle;
  if (measures.point) json[measures.direction ? "on_axis" : "centre"] = measures.point->coordinates;
  if (measures.direction) json[round ? "axis" : "normal"] = measures.direction->coordinates;
  if (round) json["hollow"] = measures.hollow;
}

Json face_json(const FaceFacts& face) {
  Json json = {{"number", face.number}, {"name", face.name}, {"surface", face.surface}};
  if (face.degree_u > 0) {
    json["degree"] = {face.degree_u, face.degree_v};
    json["spans"] = {face.spans_u, face.spans_v};
    json["rational"] = face.rational;
  }
  if (face.surface != "none")
    json["parameters"] = {{face.u.from, face.u.to}, {face.v.from, face.v.to}};
  put_measures(face.measures, json);
  if (face.area) json["area"] = *face.area;
  if (face.colour) json["colour"] = *face.colour;
  json["periodic"] = {face.periodic_u, face.periodic_v};
  json["wires"] = face.wires;
  json["edges"] = face.edges;
  json["tolerance"] = face.tolerance;
  json["valid"] = face.problems.empty();
  json["problems"] = face.problems;
  return json;
}

}  // namespace

TopoDS_Shape subject_of(const Input& input) {
  if (!input.selected.IsNull()) return input.selected;
  const bool all = input.faces.size() == input.model.face_names().size();
  if (all) return input.model.shape();
  return occt::compound_of(input.faces);
}

ModelFacts model_facts(const Input& input, const std::vector<std::vector<std::string>>& problems,
                       FaceDetail detail, const std::function<bool()>& cancelled,
                       occt::KeptForms* forms) {
  ModelFacts facts;
  std::vector<std::optional<occt::FaceColour>> colours;
  if (detail == FaceDetail::Full) colours = occt::face_colours(input.model);
  const std::vector<std::string> names = input.model.face_names();
  for (std::size_t i = 0; i < input.faces.size(); ++i) {
    facts.faces.push_back(face_facts(input.faces[i], input.numbers[i], problems[i]));
    FaceFacts& face = facts.faces.back();
    face.name = given_name(names[static_cast<std::size_t>(face.number - 1)]);
    if (detail == FaceDetail::Full) {
      face.colour = colours[static_cast<std::size_t>(face.number - 1)];
      if (face.problems.empty() && !cancelled()) face.area = area_of(input.faces[i]);
    }
    ++facts.surfaces[face.surface];
    facts.valid = facts.valid && face.problems.empty();
  }
  ShapeAnalysis_ShapeTolerance tolerances;
  const TopoDS_Shape subject = subject_of(input);
  facts.least_tolerance = tolerances.Tolerance(subject, -1);
  facts.largest_tolerance = tolerances.Tolerance(subject, 1);
  // Numbers that are none would go into the box, too.
  if (facts.valid) facts.box = box_of(subject, cancelled, forms);
  return facts;
}

std::vector<ShapeCount> shape_counts(const TopoDS_Shape& shape) {
  std::vector<ShapeCount> counts;
  for (const auto& [kind, one, many] : kCounted) counts.push_back({count(shape, kind), one, many});
  return counts;
}

Json info_report(const Input& input, const ModelFacts& facts) {
  Json json = {{"schema", "blossom.info/1"},
               {"file", input.name},
               {"unit", "mm"},
               {"file_unit", input.model.file_unit()}};
  for (const ShapeCount& each : shape_counts(subject_of(input)))
    json["counts"][each.many] = each.count;
  json["surfaces"] = facts.surfaces;
  json["box"] = nullptr;
  if (facts.box) {
    json["box"] = {facts.box->box.low.coordinates, facts.box->box.high.coordinates};
    json["box_precision"] = facts.box->precision;
  }
  json["tolerance"] = {{"least", facts.least_tolerance}, {"largest", facts.largest_tolerance}};
  json["valid"] = facts.valid;
  json["faces"] = Json::array();
  for (const FaceFacts& face : facts.faces) json["faces"].push_back(face_json(face));
  return json;
}

std::string triple(const Vec3& vector) {
  const auto text = [](double x) {
    return number_text(std::abs(x) < kNoDirection ? 0 : rounded(x));
  };
  return text(vector[0]) + ", " + text(vector[1]) + ", " + text(vector[2]);
}

std::string measures_text(const Measures& of) {
  const bool round = !of.radii.empty() || of.half_angle;
  if (!round) return of.direction ? "normal " + triple(*of.direction) : "";
  std::string text = of.hollow ? ", hollow" : "";
  if (of.half_angle)
    return "half angle " + number_text(rounded(*of.half_angle * kDegrees)) + "°" + text;
  if (of.radii.size() == 1) return "radius " + number_text(rounded(of.radii[0])) + text;
  return "radii " + number_text(rounded(of.radii[0])) + " and " +
         number_text(rounded(of.radii[1])) + text;
}

}  // namespace blossom::reports
