// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter curves as planar Bezier spans.
#include "adapters/occt/convert/pcurves.h"

#include <gtest/gtest.h>

#include <cmath>

#include <Geom2d_BSplineCurve.hxx>
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

}  // namespace
}  // namespace blossom::occt
