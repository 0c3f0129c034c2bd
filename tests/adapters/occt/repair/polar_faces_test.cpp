// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces from pole to pole with holes: halves that readers of STEP understand.

#include "adapters/occt/repair/polar_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/faces/area.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;

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

TopoDS_Shape bored(const TopoDS_Shape& body, double angle, double up) {
  const gp_Dir axis(std::cos(angle) * std::cos(up), std::sin(angle) * std::cos(up), std::sin(up));
  return BRepAlgoAPI_Cut(body, BRepPrimAPI_MakeCylinder(gp_Ax2(gp::Origin(), axis), 2, 25)).Shape();
}

double area_of(const TopoDS_Shape& shape) {
  double sum = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    sum += area(TopoDS::Face(it.Current()));
  return sum;
}

struct Body {
  const char* name;
  TopoDS_Shape shape;
};

std::vector<Body> polar_bodies() {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10).Shape();
  return {{"ball", ball},
          {"egg", egg()},
          {"spline ball", BRepBuilderAPI_NurbsConvert(ball, true).Shape()},
          {"spline egg", BRepBuilderAPI_NurbsConvert(egg(), true).Shape()}};
}

// Holes on the seam, which they interrupt, beside it, and on both sides.
TEST(PolarFaces, AreCutIntoValidHalvesThatMakeThemUp) {
  for (const Body& body : polar_bodies())
    for (const double angle : {0.0, 2.0, 6.0}) {
      const TopoDS_Shape shape = bored(body.shape, angle, 0.3);
      const auto halves = polar_faces(shape);
      ASSERT_EQ(halves.size(), 1U) << body.name << " at " << angle;
      const auto& [number, pieces] = *halves.begin();
      ASSERT_EQ(pieces.size(), 2U);
      double sum = 0;
      for (const TopoDS_Face& piece : pieces) {
        EXPECT_TRUE(BRepCheck_Analyzer(piece).IsValid());
        EXPECT_TRUE(polar_halves(piece).empty());
        sum += area(piece);
      }
      TopTools_IndexedMapOfShape faces;
      TopExp::MapShapes(shape, TopAbs_FACE, faces);
      const double whole = area(TopoDS::Face(faces(number)));
      EXPECT_NEAR(sum, whole, 1e-9 * whole) << body.name << " at " << angle;
    }
}

TEST(PolarFaces, LeaveOtherFacesAlone) {
  for (const Body& body : polar_bodies()) EXPECT_TRUE(polar_faces(body.shape).empty()) << body.name;
  EXPECT_TRUE(polar_faces(bored(BRepPrimAPI_MakeSphere(10, 0, kPi / 2).Shape(), 0, 0.4)).empty());
  EXPECT_TRUE(polar_faces(bored(BRepPrimAPI_MakeCone(10, 0, 20).Shape(), 0, 0.1)).empty());
}

// Without halves, Open CASCADE's reader gives the piece that was cut out for 8 of these 12.
TEST(PolarFaces, ComeBackFromStepAsTheyWere) {
  const testing::Folder folder;
  for (const Body& body : polar_bodies())
    for (const double angle : {0.0, 2.0, 6.0}) {
      const TopoDS_Shape shape = bored(body.shape, angle, 0.3);
      Model model;
      model.add(shape, "part");
      write_model(model, folder / "part.step");
      const Model back = read_model(folder / "part.step");
      EXPECT_TRUE(back.reading().losses.empty());
      EXPECT_TRUE(BRepCheck_Analyzer(back.shape()).IsValid());
      EXPECT_NEAR(area_of(back.shape()), area_of(shape), 1e-6 * area_of(shape))
          << body.name << " at " << angle;
      EXPECT_EQ(model.face_count(), 3) << "the model that was written has changed";
    }
}

}  // namespace
}  // namespace blossom::occt
