// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves to Bezier spans and back: the same points at the same parameters.

#include "adapters/occt/convert/curves.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <gp.hxx>

#include "adapters/occt/base/errors.h"
#include "core/base/unbounded.h"
#include "tests/adapters/occt/convert/surfaces_samples.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::NamedCurve;
using testing::Random;
using testing::uniform;

using testing::gap;
using testing::kPi;

/// The point of a span at local parameter t, by de Casteljau in long double.
Vec3 reference_point(const RationalBezierCurve& curve, double t) {
  std::vector<std::array<long double, 4>> points;
  for (const Vec4& p : curve.points) points.push_back({p[0], p[1], p[2], p[3]});
  for (std::size_t n = points.size() - 1; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t c = 0; c < 4; ++c)
        points[i][c] = (1 - static_cast<long double>(t)) * points[i][c] + t * points[i + 1][c];
  const auto& p = points.front();
  return {static_cast<double>(p[0] / p[3]), static_cast<double>(p[1] / p[3]),
          static_cast<double>(p[2] / p[3])};
}

double size_of(const CurveSpans& curve) {
  double size = 0;
  for (const CurveSpan& span : curve.spans)
    for (const Vec4& p : span.curve.points)
      size = std::max(size, max_norm(Vec3{p[0], p[1], p[2]} * (1 / p[3])));
  return size;
}

class EveryCurve : public ::testing::TestWithParam<int> {};

TEST_P(EveryCurve, HasTheSamePointsAtTheSameParameters) {
  Random random(static_cast<unsigned>(GetParam()));
  for (const NamedCurve& sample : testing::all_curves(random)) {
    const CurveSpans found = bezier_spans(sample.curve, sample.range);
    EXPECT_EQ(found.error == 0, sample.exact) << sample.name;
    EXPECT_LE(found.error, 1e-7) << sample.name;
    const double allowed = found.error + 64 * 0x1p-53 * size_of(found);
    for (const CurveSpan& span : found.spans)
      for (int k = 0; k < 20; ++k) {
        const double t = k < 2 ? k : uniform(random, 0, 1);
        const double parameter = parameter_at(span.law, span.place, t);
        EXPECT_LE(gap(reference_point(span.curve, t), sample.curve->Value(parameter)), allowed)
            << sample.name << " at " << parameter;
      }
  }
}

TEST_P(EveryCurve, IsCoveredWithoutGapsFromEndToEnd) {
  Random random(static_cast<unsigned>(GetParam()));
  for (const NamedCurve& sample : testing::all_curves(random)) {
    const CurveSpans found = bezier_spans(sample.curve, sample.range);
    EXPECT_EQ(found.spans.front().place.from, sample.range.from) << sample.name;
    EXPECT_EQ(found.spans.back().place.to, sample.range.to) << sample.name;
    for (std::size_t i = 1; i < found.spans.size(); ++i) {
      EXPECT_EQ(found.spans[i - 1].place.to, found.spans[i].place.from) << sample.name;
      EXPECT_EQ(found.spans[i - 1].curve.points.back(), found.spans[i].curve.points.front())
          << sample.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, EveryCurve, ::testing::Range(1, 6));

TEST(BezierSpans, QuarterCircleHasHandComputedPoints) {
  const Handle(Geom_Curve) circle = new Geom_Circle(gp::XOY(), 3);
  const CurveSpans found = bezier_spans(circle, {0, kPi / 2});
  ASSERT_EQ(found.spans.size(), 1u);
  const auto& points = found.spans.front().curve.points;
  EXPECT_EQ(points[0], (Vec4{3, 0, 0, 1}));
  EXPECT_EQ(points[2], (Vec4{0, 3, 0, 1}));
  EXPECT_NEAR(points[1][3], std::sqrt(0.5), 1e-16);
  EXPECT_NEAR(points[1][0] / points[1][3], 3, 1e-15);
  EXPECT_TRUE(found.rational);
  EXPECT_EQ(found.spans.front().law, ParameterLaw::Angle);
}

TEST(BezierSpans, FitsWithinTheToleranceThatIsAsked) {
  Random random(3);
  for (const NamedCurve& sample : testing::all_curves(random)) {
    if (sample.exact) continue;
    const CurveSpans coarse = bezier_spans(sample.curve, sample.range, 1e-4);
    const CurveSpans fine = bezier_spans(sample.curve, sample.range, 1e-10);
    EXPECT_LE(coarse.error, 1e-4) << sample.name;
    EXPECT_LE(fine.error, 1e-10) << sample.name;
    EXPECT_LT(coarse.spans.size(), fine.spans.size()) << sample.name;
  }
}

TEST(BezierSpans, RefusesRangesAndNumbersThatAreNone) {
  const Handle(Geom_Curve) line = new Geom_Line(gp::OX());
  EXPECT_THROW(bezier_spans(line, {0, kInfinity}), BadModel);
  EXPECT_THROW(bezier_spans(line, {std::nan(""), 1}), BadModel);
  EXPECT_THROW(bezier_spans(line, {1, 1}), BadModel);
  EXPECT_THROW(bezier_spans(line, {2, 1}), BadModel);
  EXPECT_THROW(bezier_spans(Handle(Geom_Curve)(), {0, 1}), BadModel);
  Random random(4);
  const auto bezier = testing::random_bezier_curve(random, 3, false);
  EXPECT_THROW(bezier_spans(bezier, {-0.5, 1}), BadModel);
  bezier->SetPole(2, gp_Pnt(0, 0, std::nan("")));
  EXPECT_THROW(bezier_spans(bezier, {0, 1}), BadModel);
}

TEST(BezierCurveRoundTrip, KeepsEveryBitOfPolynomialCurves) {
  Random random(5);
  for (int n = 1; n <= 25; ++n) {
    const auto curve = testing::random_bezier_curve(random, n, false);
    const RationalBezierCurve points = from_occt(*curve);
    const Handle(Geom_BezierCurve) back = to_occt(points);
    EXPECT_FALSE(back->IsRational());
    for (int i = 1; i <= n + 1; ++i) EXPECT_EQ(back->Pole(i).Distance(curve->Pole(i)), 0);
    EXPECT_EQ(from_occt(*back), points);
  }
}

TEST(BezierCurveRoundTrip, MovesRationalPointsByOneUlpAtMostAndThenNoMore) {
  Random random(6);
  for (int k = 0; k < 50; ++k) {
    const auto curve = testing::random_bezier_curve(random, 5, true);
    const Handle(Geom_BezierCurve) once = to_occt(from_occt(*curve));
    const Handle(Geom_BezierCurve) twice = to_occt(from_occt(*once));
    for (int i = 1; i <= 6; ++i) {
      EXPECT_EQ(once->Weight(i), curve->Weight(i));
      for (int c = 1; c <= 3; ++c) {
        const double x = curve->Pole(i).Coord(c), y = once->Pole(i).Coord(c);
        EXPECT_LE(std::abs(y - x), std::abs(std::nextafter(x, 2 * x) - x));
        EXPECT_EQ(twice->Pole(i).Coord(c), y);
      }
    }
  }
}

TEST(SplineToOcct, KeepsKnotsAndPointsBitForBit) {
  Random random(7);
  Spline spline{3, {0, 0.3, 1.1, 2}, {4, 1, 2, 4}, {}};
  Spline2 chart{3, spline.knots, spline.multiplicities, {}};
  for (int i = 0; i < 7; ++i) {
    spline.points.push_back(
        {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, 0, 1)});
    chart.points.push_back({uniform(random, -1, 1), uniform(random, -1, 1)});
  }
  const Handle(Geom_BSplineCurve) curve = to_occt(spline);
  const Handle(Geom2d_BSplineCurve) pcurve = to_occt(chart);
  ASSERT_EQ(curve->NbPoles(), 7);
  for (int i = 1; i <= 7; ++i) {
    const std::size_t k = static_cast<std::size_t>(i - 1);
    EXPECT_EQ(gap(spline.points[k], curve->Pole(i)), 0);
    EXPECT_EQ(pcurve->Pole(i).Coord(1), chart.points[k][0]);
    EXPECT_EQ(pcurve->Pole(i).Coord(2), chart.points[k][1]);
  }
  for (int i = 1; i <= 4; ++i) {
    EXPECT_EQ(curve->Knot(i), spline.knots[static_cast<std::size_t>(i - 1)]);
    EXPECT_EQ(pcurve->Multiplicity(i), spline.multiplicities[static_cast<std::size_t>(i - 1)]);
  }
}

TEST(CurveLength, OfAnEllipseIsItsEllipticIntegral) {
  for (const double minor : {3.0, 0.05}) {
    const GeomAdaptor_Curve ellipse(new Geom_Ellipse(gp::XOY(), 10, minor));
    const double exact = 40 * std::comp_ellint_2(std::sqrt(1 - minor * minor / 100));
    EXPECT_NEAR(curve_length(ellipse, {0, 2 * kPi}), exact, 1e-7 * exact);
    EXPECT_NEAR(curve_length(ellipse, {0, kPi / 2}), exact / 4, 1e-7 * exact);
  }
}

TEST(CurveLength, OfASplineWithManySpansIsTheSumOfTheirs) {
  const Spline spline{2,
                      {0, 1, 2, 3, 4},
                      {3, 1, 1, 1, 3},
                      {{0, 0, 0}, {9, 0, 0}, {9, 1, 0}, {0, 1, 0}, {0, 8, 5}, {1, 8, 0}}};
  const GeomAdaptor_Curve curve(to_occt(spline));
  double sum = 0;
  for (double at = 0; at < 4; at += 1.0 / 64) sum += curve_length(curve, {at, at + 1.0 / 64});
  EXPECT_NEAR(curve_length(curve, {0, 4}), sum, 2e-7 * sum);
}

TEST(SplineToOcct, RefusesWhatIsNoSpline) {
  EXPECT_THROW(to_occt(Spline{3, {0, 1}, {4, 4}, {{0, 0, 0}, {1, 1, 1}}}), Failure);
}

}  // namespace
}  // namespace blossom::occt
