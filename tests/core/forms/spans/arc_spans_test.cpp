// SPDX-License-Identifier: LGPL-2.1-or-later
// Arcs as rational spans: on the circle, at their own angles, without gaps.

#include "core/forms/spans/arc_spans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace blossom {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(ArcSpans, QuarterCircleHasHandComputedPoints) {
  const auto spans = arc_spans({0, kPi / 2});
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_EQ(spans[0].cosine[0], 1);
  EXPECT_EQ(spans[0].cosine[2], 0);  // not 6e-17
  EXPECT_EQ(spans[0].sine[0], 0);
  EXPECT_EQ(spans[0].sine[2], 1);
  EXPECT_NEAR(spans[0].weight[1], std::sqrt(0.5), 1e-16);
}

TEST(ArcSpans, AreAtMostQuartersButForRounding) {
  EXPECT_EQ(arc_spans({0, 2 * kPi}).size(), 4U);
  EXPECT_EQ(arc_spans({0, kPi / 2 * (1 + 1e-10)}).size(), 1U);
  EXPECT_EQ(arc_spans({0, kPi / 2 * (1 + 1e-8)}).size(), 2U);
}

TEST(ArcSpans, WholeTurnEndsInTheBitsItBeganWith) {
  for (const double start : {0.0, 1.0, -2.7}) {
    const auto spans = arc_spans({start, start + 2 * kPi});
    EXPECT_EQ(spans.back().cosine[2], spans.front().cosine[0]);
    EXPECT_EQ(spans.back().sine[2], spans.front().sine[0]);
  }
}

TEST(ArcSpans, ShiftedCutsAreOffTheEvenOnesAndCoverTheSameArc) {
  const auto even = arc_spans({0, 2 * kPi}), shifted = arc_spans({0, 2 * kPi}, ArcCuts::Shifted);
  ASSERT_EQ(even.size(), shifted.size());
  EXPECT_EQ(shifted.front().place.from, 0);
  EXPECT_EQ(shifted.back().place.to, 2 * kPi);
  for (std::size_t i = 1; i < even.size(); ++i) {
    EXPECT_EQ(shifted[i].place.from, shifted[i - 1].place.to);
    EXPECT_GT(shifted[i].place.from - even[i].place.from, 0.1);
    EXPECT_LT(length(shifted[i].place), kPi);
  }
}

TEST(EllipseSpans, HaveTheEllipsesPointAtEveryAngle) {
  const Vec3 origin{1, 2, 3}, a{4, 1, 0}, b{0, -1, 2};
  for (const ArcCuts cuts : {ArcCuts::Even, ArcCuts::Shifted}) {
    const CurveSpans curve = ellipse_spans(origin, a, b, {-0.4, 5.1}, cuts);
    validate(curve, "ellipse");
    EXPECT_TRUE(curve.rational);
    for (double t = -0.4; t <= 5.1; t += 0.05)
      EXPECT_LT(distance(point_at(curve, t), origin + std::cos(t) * a + std::sin(t) * b), 1e-13)
          << t;
  }
}

TEST(HyperbolaSpans, HaveTheHyperbolasPointAtEveryParameter) {
  const Vec3 origin{1, 2, 3}, a{4, 1, 0}, b{0, -1, 2};
  const CurveSpans curve = hyperbola_spans(origin, a, b, {-3.1, 4});
  validate(curve, "hyperbola");
  EXPECT_TRUE(curve.rational);
  EXPECT_EQ(curve.error, 0);
  EXPECT_EQ(curve.domain(), (Interval{-3.1, 4}));
  for (double t = -3.1; t <= 4; t += 0.05)
    EXPECT_LT(distance(point_at(curve, t), origin + std::cosh(t) * a + std::sinh(t) * b), 1e-12)
        << t;
}

}  // namespace
}  // namespace blossom
