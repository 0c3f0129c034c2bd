// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/curve_queries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2d.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;

TopoDS_Edge segment(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepBuilderAPI_MakeEdge(from, to);
}

gp_Circ unit_circle() { return gp_Circ(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 1); }

TEST(OcctCurveQueries, CircleAndLineMeetAtTheirOwnParameters) {
  const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(unit_circle());
  const CurveIntersection found = intersect(circle, segment({0.5, -2, 0}, {0.5, 2, 0}));
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.points.size(), 2U);
  EXPECT_NEAR(found.points[0].a, kPi / 3, 1e-13);
  EXPECT_NEAR(found.points[1].a, 5 * kPi / 3, 1e-13);
  EXPECT_NEAR(found.points[0].b, 2 + std::sqrt(0.75), 1e-13);  // a line's parameter is its length
  EXPECT_NEAR(found.points[1].b, 2 - std::sqrt(0.75), 1e-13);
}

TEST(OcctCurveQueries, EllipsesOfConfocalQuadricsMeetInFourPoints) {
  const TopoDS_Edge wide =
      BRepBuilderAPI_MakeEdge(gp_Elips(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 2, 1));
  const TopoDS_Edge tall = BRepBuilderAPI_MakeEdge(
      gp_Elips(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(0, 1, 0)), 2, 1));
  const CurveIntersection found = intersect(wide, tall);
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.points.size(), 4U);
  for (const CurvePoint& p : found.points)
    EXPECT_NEAR(std::abs(p.point[0]), 2 / std::sqrt(5.0), 1e-13);
}

TEST(OcctCurveQueries, PlacedEdgesMeetInModelSpace) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(0, 0, 5));
  const TopoDS_Edge a = TopoDS::Edge(segment({-1, 0, 0}, {1, 0, 0}).Moved(TopLoc_Location(move)));
  EXPECT_EQ(intersect(a, segment({0, -1, 5}, {0, 1, 5})).points.size(), 1U);
  EXPECT_EQ(intersect(a, segment({0, -1, 0}, {0, 1, 0})).points.size(), 0U);
}

TEST(OcctCurveQueries, PlanarCurvesKeepTheirParametersAndZ0) {
  const Handle(Geom2d_Curve) circle = new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(0, 0), gp_Dir2d(1, 0)), 2);
  const Handle(Geom2d_Curve) line = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(0, 1));
  const CurveIntersection found =
      blossom::intersect(bezier_spans(circle, {0, 2 * kPi}), bezier_spans(line, {-1, 5}));
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_NEAR(found.points[0].a, kPi / 2, 1e-13);
  EXPECT_NEAR(found.points[0].b, 2, 1e-13);
  EXPECT_TRUE(found.points[0].proven);
}

TEST(OcctCurveQueries, LoopsOfAnEdgeAreFound) {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = {0, 0, 0};
  poles(2) = {3, 2, 1};
  poles(3) = {-2, 2, 1};
  poles(4) = {1, 0, 0};
  const CurveIntersection found =
      self_intersections(BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)(new Geom_BezierCurve(poles))));
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_EQ(found.points.size(), 1U);
}

TEST(OcctCurveQueries, LinesMeetASphereAtItsParameters) {
  const TopoDS_Face sphere = BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), 1));
  const CurveSurfaceIntersection found = intersect(segment({0.3, -2, 0.6}, {0.3, 2, 0.6}), sphere);
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.points.size(), 2U);
  for (const CurveSurfacePoint& p : found.points) EXPECT_NEAR(p.uv[1], std::asin(0.6), 1e-12);
}

TEST(OcctCurveQueries, ASeamIsNoBorder) {
  const TopoDS_Face sphere = BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), 1));
  const CurveSurfaceIntersection found = intersect(segment({-2, 0, 0.6}, {2, 0, 0.6}), sphere);
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.points.size(), 2U);
  EXPECT_TRUE(found.points[0].proven && found.points[1].proven);
  EXPECT_TRUE(found.places.empty());
}

// A square with a square hole.
TopoDS_Face frame() {
  const auto square = [](double r, bool reversed) {
    BRepBuilderAPI_MakeWire wire;
    const gp_Pnt p[] = {{-r, -r, 0}, {r, -r, 0}, {r, r, 0}, {-r, r, 0}};
    for (int i = 0; i < 4; ++i) wire.Add(segment(p[i], p[(i + 1) % 4]));
    return reversed ? TopoDS::Wire(wire.Wire().Reversed()) : wire.Wire();
  };
  BRepBuilderAPI_MakeFace face(gp_Pln(), square(2, false));
  face.Add(square(1, true));
  return face;
}

TEST(OcctCurveQueries, PointsOutsideOfTheTrimsAreLeftOut) {
  const auto at = [](double x) { return intersect(segment({x, 0.1, -1}, {x, 0.1, 1}), frame()); };
  EXPECT_EQ(at(1.5).points.size(), 1U);
  EXPECT_EQ(at(1.5).status, Status::Complete);
  EXPECT_EQ(at(0).points.size(), 0U);
  EXPECT_EQ(at(0).status, Status::Complete);
  EXPECT_EQ(at(1).points.size(), 1U);
  EXPECT_EQ(at(1).status, Status::Tolerance);
  EXPECT_EQ(at(1).places.size(), 1U);
}

TEST(OcctCurveQueries, GivesNoReasonForATouchOutsideOfTheTrims) {
  const gp_Circ ring(gp_Ax2({0, 0.1, 1}, gp::DY()), 1);  // its lowest point is in the hole
  const CurveSurfaceIntersection found = intersect(BRepBuilderAPI_MakeEdge(ring), frame());
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.points.empty());
  EXPECT_TRUE(found.places.empty());
  EXPECT_TRUE(found.certificate.reasons.empty());
}

TEST(OcctCurveQueries, RefusesEdgesWithoutCurves) {
  EXPECT_THROW(bezier_spans(TopoDS_Edge()), BadModel);
  EXPECT_THROW(bezier_spans(Handle(Geom2d_Curve)(), {0, 1}), BadModel);
}

}  // namespace
}  // namespace blossom::occt
