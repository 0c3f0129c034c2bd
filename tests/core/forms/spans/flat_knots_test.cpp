// SPDX-License-Identifier: LGPL-2.1-or-later
// B-splines as Bezier spans: the same points, ends that keep their bits, periods without end.

#include "core/forms/spans/flat_knots.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/forms/spans/homogeneous.h"
#include "core/forms/spline.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Random;
using testing::seeded;
using testing::uniform;

Vec4 random_pole(Random& random, bool rational) {
  const double w = rational ? uniform(random, 0.5, 2) : 1;
  return with_weight(
      w * Vec3{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)}, w);
}

std::vector<Vec4> random_poles(Random& random, std::size_t count, bool rational) {
  std::vector<Vec4> poles;
  while (poles.size() < count) poles.push_back(random_pole(random, rational));
  return poles;
}

void expect_no_gaps(const CurveSpans& curve) {
  for (std::size_t i = 1; i < curve.spans.size(); ++i) {
    EXPECT_EQ(curve.spans[i].place.from, curve.spans[i - 1].place.to);
    EXPECT_EQ(curve.spans[i].curve.points.front(), curve.spans[i - 1].curve.points.back());
  }
}

TEST(FlatKnots, ClampedSplineHasThePointsOfDeBoor) {
  Random random = seeded(1);
  const Spline spline{3, {0, 0.7, 1, 2.5}, {4, 2, 1, 4}, {}};
  std::vector<Vec4> poles = random_poles(random, 7, false);
  Spline full = spline;
  for (const Vec4& p : poles) full.points.push_back(head(p));
  const FlatKnots knots(3, spline.knots, spline.multiplicities, false);
  const auto spans = knots.spans({0, 2.5});
  ASSERT_EQ(spans.size(), 3U);
  const CurveSpans curve = spline_spans(knots, spans, poles);
  validate(curve, "spline");
  expect_no_gaps(curve);
  EXPECT_FALSE(curve.rational);
  EXPECT_EQ(curve.spans.front().curve.points.front(), poles.front());
  EXPECT_EQ(curve.spans.back().curve.points.back(), poles.back());
  for (double t = 0; t <= 2.5; t += 0.01)
    EXPECT_LT(distance(point_at(curve, t), point_at(full, t)), 1e-14) << t;
}

TEST(FlatKnots, PartOfARangeIsThePartOfTheCurve) {
  Random random = seeded(2);
  const std::array knots{0.0, 1.0, 2.0, 3.0};
  const std::array multiplicities{3, 1, 1, 3};
  const std::vector<Vec4> poles = random_poles(random, 5, true);
  const FlatKnots flat(2, knots, multiplicities, false);
  const CurveSpans whole = spline_spans(flat, flat.spans({0, 3}), poles);
  const CurveSpans part = spline_spans(flat, flat.spans({0.25, 2.5}), poles);
  expect_no_gaps(part);
  EXPECT_TRUE(part.rational);
  EXPECT_EQ(part.domain(), (Interval{0.25, 2.5}));
  for (double t = 0.25; t <= 2.5; t += 0.01)
    EXPECT_LT(distance(point_at(part, t), point_at(whole, t)), 1e-14) << t;
}

TEST(FlatKnots, SliversAtTheEndsOfARangeAreLeftOutAndWhatIsOutsideHasNoSpan) {
  const std::array knots{0.0, 1.0, 2.0};
  const std::array multiplicities{3, 1, 3};
  const FlatKnots flat(2, knots, multiplicities, false);
  EXPECT_EQ(flat.spans({0, 1 + 1e-14}).size(), 1U);
  EXPECT_EQ(flat.spans({0, 1 + 1e-14}).front().place.to, 1 + 1e-14);
  EXPECT_TRUE(flat.spans({3, 4}).empty());
}

TEST(FlatKnots, PeriodicSplineGoesOnBeyondItsPeriodInBothDirections) {
  Random random = seeded(3);
  const std::array knots{0.0, 1.0, 1.5, 3.0, 4.0};
  const std::array multiplicities{1, 2, 1, 1, 1};
  const std::vector<Vec4> poles = random_poles(random, 5, false);
  const FlatKnots flat(3, knots, multiplicities, true);
  const CurveSpans base = spline_spans(flat, flat.spans({0, 4}), poles);
  expect_no_gaps(base);
  EXPECT_LT(distance(point_at(base, 0), point_at(base, 4)), 1e-15);
  for (const double turns : {-2., 1., 3.}) {
    const Interval range{0.3 + 4 * turns, 3.9 + 4 * turns};
    const CurveSpans moved = spline_spans(flat, flat.spans(range), poles);
    expect_no_gaps(moved);
    for (double t = 0.3; t <= 3.9; t += 0.05)
      EXPECT_LT(distance(point_at(moved, t + 4 * turns), point_at(base, t)), 1e-13) << t;
  }
  const CurveSpans across = spline_spans(flat, flat.spans({3.5, 4.5}), poles);
  EXPECT_LT(distance(point_at(across, 4.25), point_at(base, 0.25)), 1e-14);
}

TEST(FlatKnots, PeriodicUniformQuadraticHasMidpointsAsJoints) {
  const std::array knots{0.0, 1.0, 2.0, 3.0};
  const std::array multiplicities{1, 1, 1, 1};
  const std::vector<Vec4> poles{{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 2, 0, 1}};
  const FlatKnots flat(2, knots, multiplicities, true);
  const CurveSpans curve = spline_spans(flat, flat.spans({0, 3}), poles);
  ASSERT_EQ(curve.spans.size(), 3U);
  for (const CurveSpan& span : curve.spans) {
    const auto& p = span.curve.points;
    EXPECT_TRUE(p[1] == poles[0] || p[1] == poles[1] || p[1] == poles[2]);
  }
  EXPECT_EQ(curve.spans[0].curve.points[2],
            0.5 * (curve.spans[0].curve.points[1] + curve.spans[1].curve.points[1]));
}

// At a knot of full multiplicity the curve goes through a control point; that of the first knot is
// the first one, whichever its multiplicity.
TEST(FlatKnots, PeriodicSplineBeginsAtTheLastCopyOfItsFirstKnot) {
  const std::array knots{0.0, 1.0, 2.0};
  const std::array multiplicities{2, 1, 2};
  const std::vector<Vec4> poles{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  const FlatKnots flat(2, knots, multiplicities, true);
  const CurveSpans curve = spline_spans(flat, flat.spans({0, 2}), poles);
  ASSERT_EQ(curve.spans.size(), 2U);
  EXPECT_EQ(curve.spans.front().curve.points.front(), poles[0]);
  EXPECT_EQ(curve.spans.back().curve.points.back(), poles[0]);
  EXPECT_EQ(curve.spans.front().curve.points[1], poles[1]);
}

TEST(SplinePatches, HaveThePointsOfTheirIsoCurves) {
  Random random = seeded(4);
  const std::array u_knots{0.0, 0.4, 1.0}, v_knots{-1.0, 0.0, 2.0};
  const std::array u_times{4, 1, 4}, v_times{3, 2, 3};
  const FlatKnots u(3, u_knots, u_times, false), v(2, v_knots, v_times, false);
  Grid<Vec4> net(5, 5);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) net(i, j) = random_pole(random, true);
  const auto u_spans = u.spans({0.1, 1}), v_spans = v.spans({-1, 2});
  const BezierSurface surface = spline_patches(u, u_spans, v, v_spans, net);
  validate(surface, "spline");
  ASSERT_EQ(surface.patches.rows(), 2);
  ASSERT_EQ(surface.patches.columns(), 2);
  EXPECT_EQ(surface.u_knots.front(), 0.1);
  for (int j = 0; j <= 3; ++j)
    EXPECT_EQ(surface.patches(0, 0).points(3, j % 3), surface.patches(1, 0).points(0, j % 3));
  // The border v = -1 is the curve of the first column.
  std::vector<Vec4> column;
  for (int i = 0; i < 5; ++i) column.push_back(net(i, 0));
  const CurveSpans border = spline_spans(u, u_spans, column);
  for (double t = 0.1; t <= 1; t += 0.01)
    EXPECT_LT(distance(point_at(surface, {t, -1}), point_at(border, t)), 1e-14) << t;
}

}  // namespace
}  // namespace blossom
