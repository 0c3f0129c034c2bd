// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/convert/curve_breaks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>

namespace blossom::occt {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Handle(Geom2d_BSplineCurve) circle() {
  return Geom2dConvert::CurveToBSplineCurve(new Geom2d_Circle(gp_Ax2d({0, 0}, {1, 0}), 1));
}

void expect_at(const std::vector<double>& found, const std::vector<double>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-12);
}

// Open CASCADE's adaptors see no knot in the last of these.
TEST(CurveBreaks, ArePeriodicSplinesKnotsInAnyRange) {
  const Handle(Geom2d_BSplineCurve) spline = circle();
  ASSERT_TRUE(spline->IsPeriodic());
  const double third = kTurn / 3;
  expect_at(breaks_of(spline, {1, 4}), {third});
  expect_at(breaks_of(spline, {-1, 3}), {0, third});
  const double beyond = std::nextafter(std::nextafter(spline->LastParameter(), 7), 7);
  expect_at(breaks_of(spline, {0, beyond}), {third, 2 * third, 3 * third});
}

TEST(CurveBreaks, AreThoseOfTheCurveUnderATrim) {
  const Handle(Geom2d_Curve) trimmed = new Geom2d_TrimmedCurve(circle(), 0.5, 3);
  expect_at(breaks_of(trimmed, {0.5, 3}), {kTurn / 3});
  const Handle(Geom_Curve) whole = GeomConvert::CurveToBSplineCurve(new Geom_Circle(gp_Ax2(), 1));
  expect_at(breaks_of(whole, {1, 3}), {kTurn / 3});
  expect_at(breaks_of(Handle(Geom_Curve)(new Geom_Circle(gp_Ax2(), 1)), {1, 3}), {});
}

}  // namespace
}  // namespace blossom::occt
