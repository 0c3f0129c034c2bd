// SPDX-License-Identifier: LGPL-2.1-or-later
// What faces have in common of the lines and conics in which their surfaces meet.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"
#include "core/bounds/box_tree.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

// The floor z = 0 up to an end in y, and a cylinder of radius 1 that lies on it from y = 0 to 2.
ShapeIntersection cylinder_on_floor(double end) {
  const gp_Pln floor(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const gp_Cylinder cylinder(gp_Ax3(gp_Pnt(0, 0, 1), gp_Dir(0, 1, 0), gp_Dir(0, 0, 1)), 1);
  const TopoDS_Face a = BRepBuilderAPI_MakeFace(floor, -1, 1, -2, end).Face();
  const TopoDS_Face b = BRepBuilderAPI_MakeFace(cylinder, 2, 4, 0, 2).Face();
  return intersect(std::vector{a}, std::vector{b});
}

TEST(KnownCrossings, TouchAlongThePartOfALineThatBothFacesHave) {
  const auto found = cylinder_on_floor(0.5);
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_EQ(found.pairs[0].found.curves.size(), 1u);
  EXPECT_NEAR(found.pairs[0].found.curves[0].length, 0.5, 1e-9);
}

TEST(KnownCrossings, TouchInAPointWhereOneFaceEndsAndTheOtherBegins) {
  const auto found = cylinder_on_floor(0);
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_TRUE(found.pairs[0].found.curves.empty());
  for (const Place& place : found.pairs[0].found.places)
    EXPECT_LT(distance(place.box_low, place.box_high), 1e-2);
}

// A torus turned from an arc of a whole turn, that closes but for rounding, has a seam there.
TEST(KnownCrossings, CirclesAreCutAtTheSeamOfASurfaceThatClosesWithoutAPeriod) {
  constexpr double kRadius = 10, kBend = 30, kPi = testing::kPi;
  for (const double start : {0.0, 0.7, 3.0}) {
    const Handle(Geom_Curve) circle = new Geom_Circle(
        gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(std::cos(start), std::sin(start), 0)),
        kRadius);
    const Handle(Geom_Curve) arc = new Geom_TrimmedCurve(circle, 0, 2 * kPi);
    const Handle(Geom_Surface) tube =
        new Geom_SurfaceOfRevolution(arc, gp_Ax1(gp_Pnt(kBend, 0, 0), gp_Dir(0, 1, 0)));
    const Handle(Geom_Surface) floor = new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
    const TopoDS_Face a = BRepBuilderAPI_MakeFace(tube, -kPi / 3, kPi / 3, 0, 2 * kPi, 1e-7).Face();
    const TopoDS_Face b = BRepBuilderAPI_MakeFace(floor, -20, 20, -20, 20, 1e-7).Face();
    const auto found = intersect(std::vector{a}, std::vector{b});
    EXPECT_EQ(found.status, Status::Complete);
    ASSERT_EQ(found.pairs.size(), 1u);
    double sum = 0;
    for (const IntersectionCurve& curve : found.pairs[0].found.curves) {
      EXPECT_TRUE(curve.deviation.proven);
      EXPECT_LT(curve.deviation.a, 1e-8);
      sum += curve.length;
    }
    EXPECT_NEAR(sum, 2 * kPi * kRadius, 1e-9);
  }
}

}  // namespace
}  // namespace blossom::occt
