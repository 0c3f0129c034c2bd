// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/face_facts.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/soundness.h"
#include "plugin/cli/reading.h"
#include "plugin/cli/supervision.h"

namespace blossom::cli {
namespace {

const char* surface_word(GeomAbs_SurfaceType type) {
  switch (type) {
    case GeomAbs_Plane: return "plane";
    case GeomAbs_Cylinder: return "cylinder";
    case GeomAbs_Cone: return "cone";
    case GeomAbs_Sphere: return "sphere";
    case GeomAbs_Torus: return "torus";
    case GeomAbs_BezierSurface: return "bezier";
    case GeomAbs_BSplineSurface: return "bspline";
    case GeomAbs_SurfaceOfRevolution: return "revolution";
    case GeomAbs_SurfaceOfExtrusion: return "extrusion";
    case GeomAbs_OffsetSurface: return "offset";
    case GeomAbs_OtherSurface: break;
  }
  return "other";
}

int count(const TopoDS_Face& face, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(face, kind, map);
  return map.Extent();
}

// Open CASCADE's check takes for ever with some curves.
std::vector<std::string> problems_of(const TopoDS_Face& face, int number,
                                     const std::filesystem::path& file) {
  const std::string step = "checking face " + std::to_string(number) + " of " + file.string();
  if (has_failed(step)) return {"Open CASCADE's check of it crashes or never ends"};
  enter(Phase::Optional, file.string(), step);
  allow_processor_time(reading_allowance(file));
  std::vector<std::string> problems = occt::face_problems(face);
  enter(Phase::Working, "looking at the faces of " + file.string());
  return problems;
}

}  // namespace

FaceFacts face_facts(const TopoDS_Face& face, int number, const std::filesystem::path& file) {
  FaceFacts facts;
  facts.number = number;
  facts.wires = count(face, TopAbs_WIRE);
  facts.edges = count(face, TopAbs_EDGE);
  facts.tolerance = BRep_Tool::Tolerance(face);
  if (BRep_Tool::Surface(face).IsNull()) {
    facts.surface = "none";
    facts.problems = {"the face has no surface"};
    return facts;
  }
  const BRepAdaptor_Surface surface(face, Standard_False);
  facts.surface = surface_word(surface.GetType());
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
  facts.problems = problems_of(face, number, file);
  return facts;
}

}  // namespace blossom::cli
