// SPDX-License-Identifier: LGPL-2.1-or-later
// What faces have in common of the lines and conics in which their surfaces meet.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "core/bounds/box_tree.h"
#include "tests/support/measures.h"
#include "tests/support/shapes.h"

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

// Pairs of faces that cross in circles and ellipses, among them beside the pole of a ball and along
// the border of a surface.
std::vector<std::pair<const char*, std::array<TopoDS_Face, 2>>> round_pairs() {
  const auto plane = [](const gp_Pnt& at, const gp_Dir& normal) {
    return BRepBuilderAPI_MakeFace(gp_Pln(at, normal), -4, 4, -4, 4).Face();
  };
  const auto wall = [](double from, double to) {
    return BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 1), 0, 2 * testing::kPi, from, to).Face();
  };
  const auto ball = [](double radius) {
    return faces_of(BRepPrimAPI_MakeSphere(radius).Shape()).front();
  };
  const TopoDS_Face ring =
      faces_of(BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(0, 0, 1), gp_Dir(0, 0, 1)), 2, 1.2).Shape())
          .front();
  return {{"a wall across", {wall(-1, 2), plane({0, 0, 0.3}, {0, 0, 1})}},
          {"a wall at its border", {wall(0, 2), plane({0, 0, 0}, {0, 0, 1})}},
          {"a wall aslant", {wall(-2, 2), plane({0, 0, 0}, {0, 1, 1})}},
          {"a ball", {ball(1.5), plane({0, 0, 1}, {0, 0, 1})}},
          {"a ball beside its poles", {ball(1.5), plane({0.1, 0, 0}, {1, 0.1, 0.05})}},
          {"a ball and a ring", {ball(1.5), ring}}};
}

double length_of(const ShapeIntersection& found) {
  double sum = 0;
  for (const FaceIntersection& pair : found.pairs)
    for (const IntersectionCurve& curve : pair.found.curves) sum += curve.length;
  return sum;
}

TEST(KnownCrossings, OfSplinesAreThoseOfWhatTheyAre) {
  const auto spline = [](const TopoDS_Face& face) {
    return faces_of(BRepBuilderAPI_NurbsConvert(face, true).Shape()).front();
  };
  for (const auto& [name, faces] : round_pairs()) {
    SCOPED_TRACE(name);
    const double length = length_of(intersect({faces[0]}, {faces[1]}));
    EXPECT_GT(length, 2);
    for (const int splines : {1, 2, 3}) {
      SCOPED_TRACE(splines);
      const auto found = intersect({(splines & 1) != 0 ? spline(faces[0]) : faces[0]},
                                   {(splines & 2) != 0 ? spline(faces[1]) : faces[1]});
      EXPECT_EQ(found.status, Status::Complete);
      EXPECT_NEAR(length_of(found), length, 1e-9);
      EXPECT_EQ(found.certificate.depth, 0);  // nothing was searched
      for (const FaceIntersection& pair : found.pairs)
        for (const IntersectionCurve& curve : pair.found.curves) {
          EXPECT_TRUE(curve.conic);
          EXPECT_TRUE(curve.deviation.proven);
          EXPECT_LT(std::max(curve.deviation.a, curve.deviation.b), 1e-8);
        }
    }
  }
}

// A spline has other parameters than the cylinder that it is, so nothing but its points tells it.
TEST(KnownCrossings, AWallAndASplineOfItOverlap) {
  const gp_Cylinder cylinder(gp_Ax3(), 1);
  const TopoDS_Face wall = BRepBuilderAPI_MakeFace(cylinder, 0, 2, 0, 2).Face();
  const TopoDS_Face part = BRepBuilderAPI_MakeFace(cylinder, 1, 4, 1, 3).Face();
  const auto found =
      intersect({wall}, {faces_of(BRepBuilderAPI_NurbsConvert(part, true).Shape()).front()});
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_EQ(found.pairs[0].found.overlaps.size(), 1u);
  Vec2 low{9, 9}, high{-9, -9};  // of the wall's parameters
  for (const SurfacePoint& at : found.pairs[0].found.overlaps[0].boundary)
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], at.uv_a[k]);
      high[k] = std::max(high[k], at.uv_a[k]);
    }
  EXPECT_LT(distance(low, Vec2{1, 1}), 1e-9);
  EXPECT_LT(distance(high, Vec2{2, 2}), 1e-9);
}

}  // namespace
}  // namespace blossom::occt
