// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/adapters/occt/polar_bodies.h"

#include <cmath>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/faces/area.h"

namespace blossom::testing {
namespace {

/// A body of revolution round the z axis, from pole to pole.
TopoDS_Shape egg() {
  TColgp_Array1OfPnt points(1, 5);
  points(1) = gp_Pnt(0, 0, -14);
  points(2) = gp_Pnt(6, 0, -10);
  points(3) = gp_Pnt(9, 0, 0);
  points(4) = gp_Pnt(6, 0, 8);
  points(5) = gp_Pnt(0, 0, 13);
  BRepBuilderAPI_MakeWire wire(
      BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve()).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(points(5), points(1)).Edge());
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire(), true), gp::OZ()).Shape();
}

}  // namespace

TopoDS_Shape bored(const TopoDS_Shape& body, double angle, double up) {
  const gp_Dir axis(std::cos(angle) * std::cos(up), std::sin(angle) * std::cos(up), std::sin(up));
  return BRepAlgoAPI_Cut(body, BRepPrimAPI_MakeCylinder(gp_Ax2(gp::Origin(), axis), 2, 25)).Shape();
}

double area_of(const TopoDS_Shape& shape) {
  double sum = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    sum += occt::area(TopoDS::Face(it.Current()));
  return sum;
}

std::vector<PolarBody> polar_bodies() {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10).Shape();
  return {{"ball", ball},
          {"egg", egg()},
          {"spline ball", BRepBuilderAPI_NurbsConvert(ball, true).Shape()},
          {"spline egg", BRepBuilderAPI_NurbsConvert(egg(), true).Shape()}};
}

}  // namespace blossom::testing
