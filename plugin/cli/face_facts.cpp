// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/face_facts.h"

#include <utility>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

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

}  // namespace

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
  return facts;
}

}  // namespace blossom::cli
