// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter curves as planar Bezier spans.
#include "adapters/occt/convert/pcurves.h"

#include <gtest/gtest.h>

#include <cmath>

#include <Adaptor3d_CurveOnSurface.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

namespace blossom::occt {
namespace {

// A quintic spline with C2 knots; two of them are nearer to each other than curves are known.
Handle(Geom2d_BSplineCurve) with_two_near_knots() {
  TColStd_Array1OfReal knots(1, 5);
  knots(1) = 0;
  knots(2) = 0.3;
  knots(3) = 0.76084547271252867;
  knots(4) = 0.76084547290364857;
  knots(5) = 1;
  TColStd_Array1OfInteger multiplicities(1, 5);
  multiplicities.Init(3);
  multiplicities(1) = multiplicities(5) = 6;
  TColgp_Array1OfPnt2d poles(1, 15);
  for (int i = 1; i <= 15; ++i) poles(i) = gp_Pnt2d(i, std::sin(0.7 * i));
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, 5);
}

void expect_same(const Handle(Geom2d_BSplineCurve) & curve, const Interval& range) {
  const PlanarCurve made = planar_curve(curve, range);
  EXPECT_EQ(made.domain().from, range.from);
  EXPECT_EQ(made.domain().to, range.to);
  for (int i = 0; i <= 50; ++i) {
    const double t = at(range, i / 50.0);
    const Vec2 point = point_at(made, t);
    const gp_Pnt2d wanted = curve->Value(t);
    EXPECT_NEAR(point[0], wanted.X(), 1e-12);
    EXPECT_NEAR(point[1], wanted.Y(), 1e-12);
  }
}

// Open CASCADE's conversion gave spans of other memory where a range ended within 1e-12 of a knot.
TEST(PlanarCurve, OfARangeThatEndsAHairBeforeOneOfTwoNearKnotsIsTheCurve) {
  const auto curve = with_two_near_knots();
  expect_same(curve, {0, 1});
  for (const double before : {0.0, 8e-13, 1e-11, -8e-13, -1e-10})
    expect_same(curve, {0.2, 0.76084547271252867 - before});
  expect_same(curve, {0.76084547271252867 + 8e-13, 0.9});
}

TEST(PlanarCurve, OfAPeriodicSplineGoesOnOverItsStart) {
  TColStd_Array1OfReal knots(1, 5);
  for (int i = 1; i <= 5; ++i) knots(i) = i - 1;
  TColStd_Array1OfInteger multiplicities(1, 5);
  multiplicities.Init(1);
  TColgp_Array1OfPnt2d poles(1, 4);
  for (int i = 1; i <= 4; ++i) poles(i) = gp_Pnt2d(std::cos(1.5 * i), std::sin(1.5 * i));
  const Handle(Geom2d_BSplineCurve) curve =
      new Geom2d_BSplineCurve(poles, knots, multiplicities, 3, Standard_True);
  for (const double start : {-1.5, 0.0, 0.7, 3.2, 9.5}) expect_same(curve, {start, start + 3.5});
}

// From (0, 2) to (9, 2), with knots where another image of the same curve needs them.
Spline2 level_line(double along, double height) {
  return {3, {0, 1, 3}, {4, 2, 4}, {{0, 2}, {1, 2}, {along, height}, {5, 2}, {7, 2}, {9, 2}}};
}

TEST(PlanarCurve, OfACircleAsAPeriodicSplineIsTheSameFromAnyPeriod) {
  const Handle(Geom2d_BSplineCurve) circle = Geom2dConvert::CurveToBSplineCurve(
      new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(3, 1), gp_Dir2d(1, 0)), 2));
  ASSERT_TRUE(circle->IsPeriodic());
  for (const double from : {-9.0, -2.65558657871115, -0.56, 0.0, 1.0, 5.9, 12.0})
    for (const double width : {0.3, 2.0943951, 4.0, 6.28})
      expect_same(circle, {from, from + width});
}

TEST(SimplestCurve, OfASplineThatRunsEvenlyAlongALineIsThatLine) {
  const Handle(Geom2d_Curve) written = simplest_to_occt(level_line(2, 2), {1, 1});
  for (const double t : {0.0, 0.4, 1.0, 2.5, 3.0}) EXPECT_NEAR(written->Value(t).X(), 3 * t, 1e-14);
}

TEST(SimplestCurve, OfUnitSpeedIsALineOfOpenCascade) {
  const Spline2 line{1, {2, 5}, {2, 2}, {{1, -2}, {4, -2}}};
  const auto written = Handle(Geom2d_Line)::DownCast(simplest_to_occt(line, {1, 1}));
  ASSERT_FALSE(written.IsNull());
  EXPECT_NEAR(written->Value(3.5).X(), 2.5, 1e-15);
}

// On a cylinder of radius 4000, three metres long: Open CASCADE's adaptors would say that the curve
// ends where it does not, by some 1e-5.
TEST(SimplestCurve, IsTakenByOpenCascadeForWhatItIs) {
  const Vec2 scale{4000, 1};
  const Handle(Geom_CylindricalSurface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), scale[0]);
  for (const double aside : {3e-9, 1e-10, 4e-16, 0.0}) {
    const Spline2 line{1, {0, 3000}, {2, 2}, {{1, 0}, {1 + aside, 3000}}};
    const Handle(Geom2d_Curve) written = simplest_to_occt(line, scale);
    const Adaptor3d_CurveOnSurface adaptor(new Geom2dAdaptor_Curve(written, 0, 3000),
                                           new GeomAdaptor_Surface(cylinder));
    EXPECT_LE(adaptor.Value(3000).Distance(cylinder->Value(1 + aside, 3000)), 1e-11);
    EXPECT_EQ(Handle(Geom2d_Line)::DownCast(written).IsNull(), aside > 1e-15);
  }
}

TEST(SimplestCurve, OfASplineThatRunsUnevenlyOrAsideIsTheSpline) {
  for (const Spline2& other : {level_line(2.1, 2), level_line(2, 2 + 1e-9)})
    EXPECT_TRUE(Handle(Geom2d_Line)::DownCast(simplest_to_occt(other, {1, 1})).IsNull());
}

}  // namespace
}  // namespace blossom::occt
