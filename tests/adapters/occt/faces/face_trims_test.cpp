// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/face_trims.h"

#include <gtest/gtest.h>

#include <cstddef>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/pcurves.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::kPi;

TopoDS_Face square() { return BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4); }

TopoDS_Face square_with_hole() {
  const gp_Circ circle(gp_Ax2(gp_Pnt(2, 2, 0), gp_Dir(0, 0, -1)), 1);
  BRepBuilderAPI_MakeFace maker(square());
  maker.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)));
  return maker.Face();
}

Spline2 line(const Vec2& from, const Vec2& to) { return {1, {0, 1}, {2, 2}, {from, to}}; }

void expect_intervals(const std::vector<Interval>& found, const std::vector<Interval>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(found[i].from, wanted[i].from, 1e-9);
    EXPECT_NEAR(found[i].to, wanted[i].to, 1e-9);
  }
}

// The control points of a circle lie outside of it, and of the surface that it just fits in.
TEST(FaceTrims, OvershootIsOfTheWireAndNotOfItsControlPoints) {
  const Handle(Geom_Plane) plane = new Geom_Plane(gp_Pln());
  const auto disc_in_a_square = [&](double half) {
    const Handle(Geom_RectangularTrimmedSurface) bounded =
        new Geom_RectangularTrimmedSurface(plane, -half, half, -half, half);
    const Handle(Geom_Surface) square = GeomConvert::SurfaceToBSplineSurface(bounded);
    const Handle(Geom2d_Curve) circle = new Geom2d_Circle(gp_Ax2d({0, 0}, {1, 0}), 1);
    TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle, square);
    BRepLib::BuildCurve3d(edge);
    return TopoDS::Face(
        BRepBuilderAPI_MakeFace(square, BRepBuilderAPI_MakeWire(edge).Wire()).Face());
  };
  EXPECT_LE(face_trims(disc_in_a_square(1)).overshoot, 1e-7);
  EXPECT_NEAR(face_trims(disc_in_a_square(0.9)).overshoot, 0.1, 1e-7);
}

TEST(ClipToTrims, CurveInsideANaturalFaceIsWhole) {
  EXPECT_TRUE(face_trims(square()).natural);
  expect_intervals(clip_to_trims(face_trims(square()), line({1, 1}, {4, 3})), {{0, 1}});
}

TEST(ClipToTrims, CurveThatLeavesIsCutAtTheBorder) {
  expect_intervals(clip_to_trims(face_trims(square()), line({-4, 1}, {6, 1})), {{0.4, 0.8}});
  expect_intervals(clip_to_trims(face_trims(square()), line({5, 1}, {6, 1})), {});
}

TEST(ClipToTrims, HoleIsOutside) {
  EXPECT_FALSE(face_trims(square_with_hole()).natural);
  expect_intervals(clip_to_trims(face_trims(square_with_hole()), line({0, 2}, {4, 2})),
                   {{0, 0.25}, {0.75, 1}});
}

TEST(ClipToTrims, BorderCountsAsInside) {
  expect_intervals(clip_to_trims(face_trims(square_with_hole()), line({-1, 0}, {3, 0})),
                   {{0.25, 1}});
}

TEST(ClipToTrims, OrientationOfTheFaceDoesNotMatter) {
  const TopoDS_Face turned = TopoDS::Face(square_with_hole().Reversed());
  expect_intervals(clip_to_trims(face_trims(turned), line({0, 2}, {4, 2})), {{0, 0.25}, {0.75, 1}});
}

TEST(ClipToTrims, PeriodsOfTheSurfaceAreTakenOff) {
  const TopoDS_Face band =
      BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 2), 1, 3, 0, 3, 1e-7);
  expect_intervals(clip_to_trims(face_trims(band), line({2 * kPi, 1}, {2 * kPi + 4, 1})),
                   {{0.25, 0.75}});
}

TEST(FaceTrims, SidesOfASeamHaveCornersOfTheirOwn) {
  const FaceTrims trims = face_trims(
      BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(), 2), 0, 2 * kPi, 0, 3, 1e-7));
  EXPECT_EQ(trims.corners.size(), 4u);
  EXPECT_LE(trims.largest_gap, 1e-12);
  EXPECT_DOUBLE_EQ(trims.period[0], 2 * kPi * trims.scale[0]);
}

TEST(FaceTrims, RefuseAFaceWithoutWires) {
  TopoDS_Face bare;
  BRep_Builder().MakeFace(bare, new Geom_Plane(gp_Pln()), 1e-7);
  EXPECT_THROW(face_trims(bare), BadModel);
}

class PlanarCurveOf : public ::testing::Test {
 protected:
  static void expect_same(const Handle(Geom2d_Curve) & curve, const Interval& range, double error) {
    const PlanarCurve converted = planar_curve(curve, range);
    for (double s = 0; s <= 1; s += 1.0 / 64) {
      const gp_Pnt2d wanted = curve->Value(at(range, s));
      const Vec2 found = point_at(converted, at(range, s));
      EXPECT_LE(distance(found, Vec2{wanted.X(), wanted.Y()}), error) << "at " << s;
    }
  }
};

TEST_F(PlanarCurveOf, ConicsKeepTheirAngle) {
  const gp_Ax22d turned(gp_Pnt2d(1, 2), gp_Dir2d(0.6, 0.8), gp_Dir2d(0.8, -0.6));
  expect_same(new Geom2d_Circle(turned, 2), {0.3, 5}, 1e-14);
  expect_same(new Geom2d_Ellipse(turned, 3, 1), {-1, 2}, 1e-14);
}

TEST_F(PlanarCurveOf, OtherCurvesAreWithinTheirError) {
  expect_same(new Geom2d_Hyperbola(gp_Ax2d(), 2, 1), {-1, 1}, 1e-8);
  const Handle(Geom2d_Curve) ellipse = new Geom2d_Ellipse(gp_Ax2d(), 3, 2);
  expect_same(new Geom2d_OffsetCurve(ellipse, 0.5), {0, 3}, 1e-8);
}

TEST_F(PlanarCurveOf, EmptyRangeIsRefused) {
  EXPECT_THROW(planar_curve(new Geom2d_Circle(gp_Ax2d(), 1), {1, 1}), BadModel);
}

TEST(PartSide, KnowsPeriods) {
  const Handle(Geom_CylindricalSurface) wall = new Geom_CylindricalSurface(gp_Ax3(), 1);
  const FaceTrims trims = face_trims(BRepBuilderAPI_MakeFace(wall, 6, 7, 0, 1, 1e-7));
  const double turn = 2 * kPi;
  EXPECT_NE(part_side(trims, {6.2 - turn, 6.4 - turn}, {0.2, 0.8}), PartSide::Outside);
  EXPECT_EQ(part_side(trims, {3, 4}, {0.2, 0.8}), PartSide::Outside);
}

// Points of a whole turn are in a face that is trimmed to another turn of the same surface.
TEST(FaceTrims, KnowThePeriodOfASurfaceThatEndsAfterOneTurn) {
  const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(gp_Ax3(), 3, 1);
  const Handle(Geom_Surface) turn =
      new Geom_RectangularTrimmedSurface(torus, 0, 0.5 * kPi, kPi, 3 * kPi);
  ASSERT_FALSE(turn->IsVPeriodic());
  const FaceTrims trims = face_trims(BRepBuilderAPI_MakeFace(turn, 1e-7).Face());
  EXPECT_NEAR(trims.period[1], 2 * kPi * trims.scale[1], 1e-12);
  for (const double v : {0.5 * kPi, 1.5 * kPi, 2.5 * kPi}) {
    EXPECT_EQ(part_side(trims, {1, 1}, {v, v}), PartSide::Inside) << v;
    EXPECT_EQ(part_side(trims, {2, 2}, {v, v}), PartSide::Outside) << v;
  }
}

}  // namespace
}  // namespace blossom::occt
