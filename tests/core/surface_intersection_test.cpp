// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surface_intersection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/base/errors.h"
#include "core/forms/evaluation.h"
#include "tests/support/cubic_family.h"
#include "tests/support/intersection_checks.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

using testing::constant;
using testing::Cubic;
using testing::cubic_pair;
using testing::CubicPair;
using testing::in_some_place;
using testing::linear;
using testing::loop;
using testing::on_some_curve;
using testing::projected_length;
using testing::total_projected_length;

constexpr double kA = 0.43, kB = 0.57;
const Cubic kX = linear(-kA, 1, 0);
const Cubic kY = linear(-kB, 0, 1);

int closed_curves(const SurfaceIntersection& found) {
  return static_cast<int>(std::count_if(found.curves.begin(), found.curves.end(),
                                        [](const IntersectionCurve& c) { return c.closed; }));
}

Vec3 on_base(double x, double y) { return {x, y, testing::base_cubic()(x, y)}; }

// Every sample on both surfaces, and the splines as near to them as the report says.
void expect_sound(const SurfaceIntersection& found, const CubicPair& pair) {
  for (const IntersectionCurve& curve : found.curves) {
    ASSERT_GE(curve.samples.size(), 48u);
    for (const SurfacePoint& sample : curve.samples) {
      EXPECT_LE(distance(point_at(pair.a, sample.uv_a), sample.point), 1e-13);
      EXPECT_LE(distance(point_at(pair.b, sample.uv_b), sample.point), 1e-11);
    }
    double between = 0;
    for (int i = 0; i <= 1000; ++i) {
      const double t = at(curve.curve.domain(), i / 1000.0);
      between = std::max(between, distance(point_at(pair.a, point_at(curve.chart_a, t)),
                                           point_at(pair.b, point_at(curve.chart_b, t))));
    }
    EXPECT_LE(between, 1.1 * curve.deviation.between + 1e-12);
    EXPECT_LE(std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}), 1e-7);
  }
}

struct RegularRow {
  const char* name;
  Cubic h;
  int open;
  int closed;
  double length;
  double relative = 1e-6;
};

class RegularFamily : public ::testing::TestWithParam<RegularRow> {};

TEST_P(RegularFamily, IsFoundCompletely) {
  const RegularRow& row = GetParam();
  const CubicPair pair = cubic_pair(row.h);

  const SurfaceIntersection found = intersect(pair.a, pair.b);

  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_EQ(closed_curves(found), row.closed);
  EXPECT_EQ(static_cast<int>(found.curves.size()), row.open + row.closed);
  EXPECT_TRUE(found.points.empty());
  EXPECT_TRUE(found.places.empty());
  EXPECT_NEAR(total_projected_length(found), row.length, row.relative * row.length);
  expect_sound(found, pair);
}

const Cubic kLine = linear(-0.6, 1, 0.2);
const Cubic kMiddleY = linear(-0.5, 0, 1);
using std::numbers::pi;

// Lengths with six digits are those of the closed forms' table; the loops' are exact.
INSTANTIATE_TEST_SUITE_P(
    Rows, RegularFamily,
    ::testing::Values(
        RegularRow{"transversal", linear(-0.5, 1, 0) + 0.3 * kMiddleY + 0.4 * (kMiddleY * kMiddleY),
                   1, 0, 1.06716, 1e-5},
        RegularRow{"loop_2e_1", loop(kA, kB, 0.2), 0, 1, 0.4 * pi},
        RegularRow{"loop_1e_1", loop(kA, kB, 0.1), 0, 1, 0.2 * pi},
        RegularRow{"loop_5e_2", loop(kA, kB, 0.05), 0, 1, 0.1 * pi},
        RegularRow{"loop_2e_2", loop(kA, kB, 0.02), 0, 1, 0.04 * pi},
        RegularRow{"loop_1e_2", loop(kA, kB, 0.01), 0, 1, 0.02 * pi},
        RegularRow{"loop_5e_3", loop(kA, kB, 0.005), 0, 1, 0.01 * pi},
        RegularRow{"loop_1e_3", loop(kA, kB, 0.001), 0, 1, 0.002 * pi},
        RegularRow{"near_tangent_1e_2", kLine* kLine + constant(-1e-4), 2, 0, 2.03961, 1e-5},
        RegularRow{"near_crossing_1e_3", kX* kY + constant(-1e-3), 2, 0, 1.89283, 1e-5},
        RegularRow{"near_crossing_1e_5", kX* kY + constant(-1e-5), 2, 0, 1.98928, 1e-5},
        RegularRow{"oval_and_branch",
                   kY* kY + -1.0 * (linear(-0.2, 1, 0) * linear(-0.4, 1, 0) * linear(-0.7, 1, 0)),
                   1, 1, 1.49686, 1e-5},
        RegularRow{"small_oval_and_branch",
                   kY* kY + -1.0 * (linear(-0.3, 1, 0) * linear(-0.33, 1, 0) * linear(-0.7, 1, 0)),
                   1, 1, 1.04805, 1e-5},
        RegularRow{"near_disjoint", loop(kA, kB, 0) + constant(1e-6), 0, 0, 0}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(SurfaceIntersection, ATouchIsAPointWithinTolerance) {
  const CubicPair pair = cubic_pair(loop(kA, kB, 0));

  const SurfaceIntersection found = intersect(pair.a, pair.b);

  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_TRUE(found.curves.empty());
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_LE(distance(found.points[0].point, on_base(kA, kB)), 1e-9);
  ASSERT_EQ(found.places.size(), 1u);
  EXPECT_EQ(found.places[0].kind, PlaceKind::Touch);
  EXPECT_TRUE(in_some_place(found, on_base(kA, kB), 1e-12));
}

TEST(SurfaceIntersection, ANodeIsNamedAndNoArmIsLost) {
  const CubicPair pair = cubic_pair(kX * kY);

  const SurfaceIntersection found = intersect(pair.a, pair.b);

  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.nodes.size(), 1u);
  EXPECT_LE(distance(found.nodes[0].point, on_base(kA, kB)), 1e-6);
  for (int i = 0; i <= 500; ++i) {
    const double t = i / 500.0;
    for (const Vec3& p : {on_base(kA, t), on_base(t, kB)})
      EXPECT_TRUE(on_some_curve(found, p, 1e-4) || in_some_place(found, p, 1e-7)) << t;
  }
}

struct ContactRow {
  const char* name;
  Cubic h;
  int curves;  ///< pieces between borders, nodes and places
  int tangential;
  int points;
  int nodes;
  PlaceKind kind;  ///< of the only place
  double length;   ///< in the plane
  double relative = 1e-6;
};

class ContactFamily : public ::testing::TestWithParam<ContactRow> {};

TEST_P(ContactFamily, IsRightUpToTheListedPlace) {
  const ContactRow& row = GetParam();
  const CubicPair pair = cubic_pair(row.h);

  const SurfaceIntersection found = intersect(pair.a, pair.b);

  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_EQ(static_cast<int>(found.curves.size()), row.curves);
  EXPECT_EQ(static_cast<int>(found.points.size()), row.points);
  EXPECT_EQ(static_cast<int>(found.nodes.size()), row.nodes);
  const auto tangential = std::count_if(found.curves.begin(), found.curves.end(),
                                        [](const auto& curve) { return curve.tangential; });
  EXPECT_EQ(tangential, row.tangential);
  ASSERT_EQ(found.places.size(), 1u);
  EXPECT_EQ(found.places[0].kind, row.kind);
  EXPECT_NEAR(total_projected_length(found), row.length, row.relative * row.length);
  for (const IntersectionCurve& curve : found.curves)
    for (const SurfacePoint& sample : curve.samples)
      EXPECT_LE(distance(point_at(pair.a, sample.uv_a), point_at(pair.b, sample.uv_b)), 1e-8);
}

const Cubic kX3 = linear(-0.3, 1, 0), kX6 = linear(-0.6, 1, 0);

// A curve through a cusp is led into its place, a little short of the tip.
INSTANTIATE_TEST_SUITE_P(
    Rows, ContactFamily,
    ::testing::Values(ContactRow{"tangent_curve", kLine* kLine, 1, 1, 0, 0, PlaceKind::Tangential,
                                 1.019803903},
                      ContactRow{"tangent_curve_raised", kLine* kLine + constant(2e-9), 1, 1, 0, 0,
                                 PlaceKind::Tangential, 1.019803903},
                      ContactRow{"crossing", kX* kY, 4, 0, 0, 1, PlaceKind::Node, 2},
                      ContactRow{"node", kY* kY + -1.0 * (kX * kX * linear(-kA + 0.3, 1, 0)), 3, 0,
                                 0, 1, PlaceKind::Node, 2.120883067},
                      ContactRow{"cusp", kY* kY + -1.0 * (kX * kX * kX), 1, 0, 0, 0,
                                 PlaceKind::Cusp, 1.450442489},
                      ContactRow{"acnode", kY* kY + -1.0 * (kX3 * kX3 * kX6), 1, 0, 1, 0,
                                 PlaceKind::Touch, 1.184664331}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(SurfaceIntersection, TwoBranchesNearerThanTheToleranceAreAStripOfContact) {
  const CubicPair pair = cubic_pair(kLine * kLine + constant(-1e-8));

  const SurfaceIntersection found = intersect(pair.a, pair.b);

  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_TRUE(found.curves[0].tangential);
  EXPECT_NEAR(total_projected_length(found), std::sqrt(1.04), 1e-6);
  for (int i = 0; i <= 200; ++i) {
    const double y = i / 200.0;
    EXPECT_TRUE(in_some_place(found, on_base(0.6 - 0.2 * y, y), 1e-4)) << y;
    EXPECT_TRUE(on_some_curve(found, on_base(0.6 - 0.2 * y, y), 2e-4)) << y;
  }
}

// What the engine does not classify it lists: all of the truth lies in the places.
TEST(SurfaceIntersection, AnOverlapLiesInTheListedPlacesAndIsNotCalledComplete) {
  const CubicPair pair = cubic_pair(constant(0));

  const SurfaceIntersection found = intersect(pair.a, pair.b, {.budget = 20'000});

  EXPECT_NE(found.status, Status::Complete);
  EXPECT_FALSE(found.certificate.reasons.empty());
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j)
      EXPECT_TRUE(in_some_place(found, on_base(i / 20.0, j / 20.0), 1e-9)) << i << " " << j;
}

TEST(SurfaceIntersection, TheTimeLimitEndsTheSearchForContacts) {
  const CubicPair pair = cubic_pair(kLine * kLine + constant(-1e-4));

  const SurfaceIntersection found = intersect(pair.a, pair.b, {.time_limit = 1e-6});

  EXPECT_EQ(found.status, Status::Stopped);
  const auto& reasons = found.certificate.reasons;
  EXPECT_NE(std::find(reasons.begin(), reasons.end(), "the time limit is reached"), reasons.end());
  EXPECT_FALSE(found.places.empty());
}

struct LoopRow {
  double scale;
  CellForm form;
};

class RandomSmallLoops : public ::testing::TestWithParam<LoopRow> {};

TEST_P(RandomSmallLoops, AreNeverLost) {
  std::mt19937_64 random(20260101);
  std::uniform_real_distribution<double> place(0.15, 0.85);
  for (int i = 0; i < 300; ++i) {
    const double a = place(random), b = place(random);
    const CubicPair pair = cubic_pair(loop(a, b, 1e-3, GetParam().scale));

    const SurfaceIntersection found = intersect(pair.a, pair.b, {.form = GetParam().form});

    EXPECT_EQ(found.status, Status::Complete) << a << " " << b;
    ASSERT_EQ(found.curves.size(), 1u) << a << " " << b;
    EXPECT_TRUE(found.curves[0].closed);
    EXPECT_NEAR(projected_length(found.curves[0]), 2e-3 * pi, 2e-9 * pi);
  }
}

INSTANTIATE_TEST_SUITE_P(Scales, RandomSmallLoops,
                         ::testing::Values(LoopRow{1, CellForm::Auto}, LoopRow{8, CellForm::Auto},
                                           LoopRow{1, CellForm::Monomial}));

TEST(SurfaceIntersection, CountsTheFormItsCellsCameFrom) {
  const CubicPair pair = cubic_pair(loop(kA, kB, 0.1));

  const Certificate bezier = intersect(pair.a, pair.b, {.form = CellForm::Bezier}).certificate;
  const Certificate monomial = intersect(pair.a, pair.b, {.form = CellForm::Monomial}).certificate;

  EXPECT_GT(bezier.cells_bezier, 0);
  EXPECT_EQ(bezier.cells_monomial, 0);
  EXPECT_GT(monomial.cells_monomial, 0);
  EXPECT_EQ(monomial.cells_bezier, 0);
}

TEST(SurfaceIntersection, IsTheSameWithArgumentsSwapped) {
  const CubicPair pair =
      cubic_pair(kY * kY + -1.0 * (linear(-0.2, 1, 0) * linear(-0.4, 1, 0) * linear(-0.7, 1, 0)));

  const SurfaceIntersection there = intersect(pair.a, pair.b), back = intersect(pair.b, pair.a);

  EXPECT_EQ(back.status, there.status);
  EXPECT_EQ(back.curves.size(), there.curves.size());
  EXPECT_EQ(closed_curves(back), closed_curves(there));
  EXPECT_NEAR(total_projected_length(back), total_projected_length(there), 1e-7);
}

// The same surface cut into spans, with knots that are not its own parameters' halves.
BezierSurface split_in_u(const BezierSurface& whole, double cut) {
  const auto& net = whole.patches(0, 0).points;
  RationalBezierPatch low{net}, high{net};
  for (int level = 1; level < net.rows(); ++level)
    for (int i = net.rows() - 1; i >= level; --i)
      for (int j = 0; j < net.columns(); ++j)
        low.points(i, j) = (1 - cut) * low.points(i - 1, j) + cut * low.points(i, j);
  for (int level = 1; level < net.rows(); ++level)
    for (int i = 0; i + level < net.rows(); ++i)
      for (int j = 0; j < net.columns(); ++j)
        high.points(i, j) = (1 - cut) * high.points(i, j) + cut * high.points(i + 1, j);
  BezierSurface split{{2, 2 + 3 * cut, 5}, {0, 1}};
  split.patches = Grid<RationalBezierPatch>(2, 1);
  split.patches(0, 0) = low;
  split.patches(1, 0) = high;
  return split;
}

TEST(SurfaceIntersection, RunsThroughTheKnotsOfASurfaceOfSeveralSpans) {
  const CubicPair pair = cubic_pair(loop(kA, kB, 0.2));
  const BezierSurface a = split_in_u(pair.a, 0.37);

  const SurfaceIntersection found = intersect(a, pair.b);

  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_TRUE(found.curves[0].closed);
  EXPECT_NEAR(total_projected_length(found), 0.4 * pi, 1e-6);
  for (const SurfacePoint& sample : found.curves[0].samples)
    EXPECT_NEAR(sample.uv_a[0], 2 + 3 * sample.point[0], 1e-12);
}

TEST(SurfaceIntersection, LooksOnlyAtSpansThatTheOtherSurfaceMeets) {
  constexpr int kSpans = 40;
  BezierSurface strip;
  strip.v_knots = {0, 1};
  strip.patches = Grid<RationalBezierPatch>(kSpans, 1);
  for (int i = 0; i <= kSpans; ++i) strip.u_knots.push_back(i);
  for (int i = 0; i < kSpans; ++i)
    strip.patches(i, 0) = testing::quadrilateral({1.0 * i, 0, 0}, {1.0 * i, 1, 0},
                                                 {1.0 * i + 1, 0, 0}, {1.0 * i + 1, 1, 0})
                              .patches(0, 0);
  const BezierSurface wall =
      testing::quadrilateral({3.3, 0, -1}, {3.3, 0, 1}, {3.4, 1, -1}, {3.4, 1, 1});

  const SurfaceIntersection found = intersect(strip, wall);
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_NEAR(found.curves[0].length, std::sqrt(1.01), 1e-12);
  EXPECT_LT(found.certificate.cells_bezier + found.certificate.cells_monomial, kSpans);
}

// A quarter cylinder of radius 2 with its angle as parameter, and the plane x + z = 1.
TEST(SurfaceIntersection, OfARationalSurfaceKeepsTheSurfacesOwnAngle) {
  BezierSurface cylinder{{0, pi / 2}, {0, 3}};
  cylinder.u_law = ParameterLaw::Angle;
  cylinder.rational = true;
  const double w = std::sqrt(0.5);
  Grid<Vec4> net(3, 2);
  for (int j = 0; j < 2; ++j) {
    net(0, j) = {2, 0, 3.0 * j, 1};
    net(1, j) = {2 * w, 2 * w, 3.0 * j * w, w};
    net(2, j) = {0, 2, 3.0 * j, 1};
  }
  cylinder.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{net});
  BezierSurface plane{{0, 1}, {0, 1}};
  Grid<Vec4> corners(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) corners(i, j) = {-1.0 + 4 * i, -3.0 + 6 * j, 2.0 - 4 * i, 1};
  plane.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{corners});

  const SurfaceIntersection found = intersect(cylinder, plane);

  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.curves.size(), 1u);
  for (const SurfacePoint& sample : found.curves[0].samples) {
    EXPECT_NEAR(sample.point[0], 2 * std::cos(sample.uv_a[0]), 1e-12);
    EXPECT_NEAR(sample.point[1], 2 * std::sin(sample.uv_a[0]), 1e-12);
    EXPECT_NEAR(sample.point[0] + sample.point[2], 1, 1e-12);
  }
  const auto& curve = found.curves[0];
  for (int i = 0; i <= 100; ++i) {
    const double t = at(curve.curve.domain(), i / 100.0);
    const Vec2 uv = point_at(curve.chart_a, t);
    EXPECT_LE(distance(point_at(curve.curve, t), {2 * std::cos(uv[0]), 2 * std::sin(uv[0]), uv[1]}),
              1e-7);
  }
}

// A half cylinder of two spans about the z axis, and the plane x = 0 that holds its knot line.
TEST(SurfaceIntersection, AlongAKnotLineIsFoundAndProven) {
  BezierSurface cylinder{{0, pi / 2, pi}, {0, 3}};
  cylinder.u_law = ParameterLaw::Angle;
  cylinder.rational = true;
  cylinder.patches = Grid<RationalBezierPatch>(2, 1);
  const double w = std::sqrt(0.5);
  for (int span = 0; span < 2; ++span) {
    Grid<Vec4> net(3, 2);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j) {
        const double x = span == 0 ? (i < 2 ? 1 : 0) : (i > 0 ? -1 : 0);
        const double y = (span == 0) == (i == 0) && i != 1 ? 0 : 1;
        const double weight = i == 1 ? w : 1;
        net(i, j) = {weight * x, weight * y, weight * 3.0 * j, weight};
      }
    cylinder.patches(span, 0) = RationalBezierPatch{net};
  }
  BezierSurface plane{{0, 1}, {0, 1}};
  Grid<Vec4> corners(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) corners(i, j) = {0, -2.0 + 4.3 * i, -1.0 + 5.1 * j, 1};
  plane.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{corners});

  const SurfaceIntersection found = intersect(cylinder, plane);

  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_NEAR(found.curves[0].length, 3, 1e-12);
  for (const SurfacePoint& sample : found.curves[0].samples)
    EXPECT_NEAR(sample.uv_a[0], pi / 2, 1e-9);

  plane.patches(0, 0).points(1, 1)[0] = 1e-18;
  const SurfaceIntersection turned = intersect(cylinder, plane);
  EXPECT_EQ(turned.status, Status::Complete);
  EXPECT_EQ(turned.curves.size(), 1u);
}

TEST(SurfaceIntersection, TangentToAKnotLineEndsSoonAndLosesNothing) {
  const CubicPair pair = cubic_pair(loop(kA, kB, 0.2));
  const BezierSurface a = split_in_u(pair.a, kA + 0.2);

  const SurfaceIntersection found = intersect(a, pair.b);

  EXPECT_LT(found.certificate.critical, 5000);
  for (int i = 0; i < 400; ++i) {
    const double angle = 2 * pi * i / 400;
    const Vec3 p = on_base(kA + 0.2 * std::cos(angle), kB + 0.2 * std::sin(angle));
    EXPECT_TRUE(on_some_curve(found, p, 5e-4) || in_some_place(found, p, 1e-9)) << angle;
  }
  EXPECT_TRUE(found.status != Status::Complete || closed_curves(found) == 1);
}

TEST(SurfaceIntersection, OfPatchesThatShareACornerIsThatPoint) {
  const auto bilinear = [](Vec3 o, Vec3 e, Vec3 f) {
    BezierSurface s{{0, 1}, {0, 1}};
    Grid<Vec4> net(2, 2);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const Vec3 p = o + double(i) * e + double(j) * f;
        net(i, j) = {p[0], p[1], p[2], 1};
      }
    s.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{net});
    return s;
  };
  const BezierSurface a = bilinear({0, 0, 0}, {-1, 0, 0}, {0, -1, 0});
  const BezierSurface b = bilinear({0, 0, 0}, {1, 0, 0.5}, {0, 1, -0.3});

  const SurfaceIntersection found = intersect(a, b);

  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_TRUE(found.curves.empty());
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_LE(norm(found.points[0].point), 1e-12);
}

TEST(SurfaceIntersection, KeepsWhatItHasWhenTheBudgetIsSpent) {
  const CubicPair pair = cubic_pair(loop(kA, kB, 0.1));

  const SurfaceIntersection found = intersect(pair.a, pair.b, {.budget = 40});

  EXPECT_EQ(found.status, Status::Stopped);
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * pi * i / 100;
    const Vec3 p = on_base(kA + 0.1 * std::cos(angle), kB + 0.1 * std::sin(angle));
    EXPECT_TRUE(on_some_curve(found, p, 1e-4) || in_some_place(found, p, 1e-9)) << angle;
  }
}

TEST(SurfaceIntersection, StopsWhenItIsCancelled) {
  const CubicPair pair = cubic_pair(constant(0));
  int asked = 0;

  const SurfaceIntersection found =
      intersect(pair.a, pair.b, {.cancelled = [&] { return ++asked == 3; }});

  EXPECT_EQ(found.status, Status::Stopped);
  EXPECT_EQ(asked, 3);
}

TEST(SurfaceIntersection, RefusesSurfacesThatAreNone) {
  const CubicPair pair = cubic_pair(loop(kA, kB, 0.1));
  const auto with = [&](const Vec4& point) {
    BezierSurface broken = pair.a;
    broken.patches(0, 0).points(1, 2) = point;
    return broken;
  };
  BezierSurface knots = pair.a;
  knots.u_knots = {1, 1};

  EXPECT_THROW(intersect(with({std::numeric_limits<double>::quiet_NaN(), 0, 0, 1}), pair.b),
               InvalidInput);
  EXPECT_THROW(intersect(pair.b, with({0, 0, 0, 0})), InvalidInput);
  EXPECT_THROW(intersect(pair.b, with({0, 0, 0, -1})), InvalidInput);
  EXPECT_THROW(intersect(knots, pair.b), InvalidInput);
  EXPECT_THROW(intersect(BezierSurface{}, pair.b), InvalidInput);
  EXPECT_THROW(intersect(pair.a, pair.b, {.tolerances = {.point = 0}}), InvalidInput);
}

}  // namespace
}  // namespace blossom
