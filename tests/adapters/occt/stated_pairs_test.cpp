// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of trimmed elementary faces with lengths that geometry gives, named after Open CASCADE's
// own tests of them. Two branches that are one regular closed curve count once here.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax3.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTurn = 2 * kPi;
const gp_Pnt O(0, 0, 0);

TopoDS_Face face(const Handle(Geom_Surface) & surface, const Interval& u, const Interval& v) {
  return BRepBuilderAPI_MakeFace(surface, u.from, u.to, v.from, v.to, 1e-7);
}

TopoDS_Face turned(const TopoDS_Face& whole, const gp_Ax1& axis, double degrees) {
  gp_Trsf turn;
  turn.SetRotation(axis, degrees * kPi / 180);
  return TopoDS::Face(whole.Moved(turn));
}

TopoDS_Face torus(double major, double minor, double to_u = kTurn) {
  return face(new Geom_ToroidalSurface(gp_Ax3(O, gp::DZ()), major, minor), {0, to_u}, {0, kTurn});
}

TopoDS_Face cylinder(const gp_Ax3& at, double radius, const Interval& v) {
  return face(new Geom_CylindricalSurface(at, radius), {0, kTurn}, v);
}

TopoDS_Face cone(const gp_Ax3& at, double half_angle, double radius, const Interval& v) {
  return face(new Geom_ConicalSurface(at, half_angle, radius), {0, kTurn}, v);
}

TopoDS_Face plane(const gp_Ax3& at, const Interval& u, const Interval& v) {
  return face(new Geom_Plane(at), u, v);
}

TopoDS_Face extruded_circle(double radius, const gp_Dir& along, const Interval& v) {
  return face(new Geom_SurfaceOfLinearExtrusion(
                  new Geom_Circle(gp_Ax2(O, gp::DZ(), gp::DX()), radius), along),
              {0, kTurn}, v);
}

struct Row {
  const char* name;
  TopoDS_Face a, b;
  int branches;   // curves that go on across a seam are one
  double length;  // of all; 0: not stated
  double within = 1e-6;
};

std::vector<Row> rows() {
  const gp_Ax3 down_1(gp_Pnt(0, 518.47, 0), gp_Dir(0, -1, 0));
  const gp_Ax3 down_2(gp_Pnt(0, -440.74363604, 0), gp_Dir(0, -1, 0));
  const gp_Ax3 x0(O, gp::DX());
  return {
      {"bug23177_2", torus(100, 10), plane(x0, {-120, 120}, {-120, 120}), 2, 2 * kTurn * 10},
      {"bug24418_2", torus(25, 24, kPi / 2),
       cone(gp_Ax3(gp_Pnt(20, 20, 10), gp::DZ()), std::atan(-0.05), 10, {0, std::hypot(40, 2)}), 1,
       0},
      {"bug24648", cone(gp_Ax3(O, gp::DZ()), kPi / 3, 0, {0, 60}), torus(30, 20), 2, kTurn * 45},
      {"bug28222_3", cylinder(gp_Ax3(gp_Pnt(-9, -5, -2.2058), gp_Dir(0, -1, 0)), 0.001, {-10, 0}),
       cylinder(gp_Ax3(gp_Pnt(0, 0, -2.2058), gp_Dir(0, 0, -1)), 9, {-5, 5}), 1, 0.5368099717},
      {"bug370",
       face(new Geom_SphericalSurface(gp_Ax3(O, gp::DZ()), 1), {0, kTurn}, {-kPi / 2, kPi / 2}),
       plane(x0, {0, 1.000001}, {-1, 1e-6}), 1, kPi / 2 + 1e-6, 2e-6},
      {"bug24313", extruded_circle(100, gp::DZ(), {-50, 50}), plane(x0, {-120, 120}, {-120, 120}),
       2, 200},
      {"bug29807_svm01", cone(down_1, 14.999999999912038 * kPi / 180, 0, {0, 1e6}),
       cone(down_2, 45.110284878807235 * kPi / 180, 0, {0, 1e6}), 1, 2202.91, 0.005},
      {"bug17194_1", extruded_circle(20, gp_Dir(50, 0, 30), {0, std::hypot(50, 30)}),
       plane(gp_Ax3(gp_Pnt(10, 0, 0), gp_Dir(1, 0, 4)), {-100, 100}, {-100, 100}), 1, 70.41863730},
      {"bug22990",
       face(new Geom_SphericalSurface(gp_Ax3(O, gp::DZ()), 10), {0, kTurn}, {-kPi / 2, kPi / 2}),
       plane(gp_Ax3(gp_Pnt(2, 0, 0), gp::DX()), {-100, 100}, {-100, 100}), 1,
       kTurn * std::sqrt(96)},
  };
}

void expect_answer(const Row& row, const ShapeIntersection& found) {
  int branches = 0;
  double length = 0, deviation = 0;
  for (const FaceIntersection& pair : found.pairs) {
    branches += static_cast<int>(pair.chains.size());
    for (const IntersectionCurve& curve : pair.found.curves) {
      length += curve.length;
      deviation = std::max({deviation, curve.deviation.a, curve.deviation.b});
      EXPECT_TRUE(curve.deviation.proven);
    }
  }
  EXPECT_LE(found.status, Status::Tolerance);
  EXPECT_EQ(branches, row.branches);
  EXPECT_LE(deviation, 1.01e-7);
  if (row.length > 0) {
    EXPECT_NEAR(length, row.length, row.within);
  }
}

TEST(StatedPairs, HaveTheBranchesAndLengthsOfGeometry) {
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.name);
    expect_answer(row, intersect({row.a}, {row.b}));
    expect_answer(row, intersect({row.b}, {row.a}));
  }
}

// Two tubes of radius 65 and 50 that cross in one curve. It touches two generatrices of the wider
// one, a quarter of a turn from its seam.
TEST(StatedPairs, CurveMayTouchTheLineBetweenTwoSpansOfAnArc) {
  const gp_Ax1 upright(O, gp::DZ()), tilt(gp_Pnt(0, 500, 0), gp::DX());
  const TopoDS_Face wide =
      turned(turned(cylinder(gp_Ax3(O, gp::DY()), 65, {0, 1000}), upright, 180),
             gp_Ax1(O, gp_Dir(0, -1, 0)), -90);
  const TopoDS_Face narrow =
      turned(turned(cylinder(gp_Ax3(gp_Pnt(50, 500, -2000), gp::DZ()), 50, {0, 4000}), tilt, -77),
             upright, 180);
  expect_answer({"bug26509_2", wide, narrow, 1, 1881.92, 0.005}, intersect({wide}, {narrow}));
}

}  // namespace
}  // namespace blossom::occt
