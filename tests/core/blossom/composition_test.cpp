// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/composition.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/blossom/detail/composition.h"
#include "core/forms/algebra/de_casteljau.h"
#include "tests/core/forms/exact_forms.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::coordinate_gap;
using testing::exact;
using testing::exact_gap;
using testing::exact_point;
using testing::pick;
using testing::random_patch;
using testing::Rational;
using testing::seeded;
using testing::uniform;

template <class Point = Vec2>
BezierCurveOf<Point> random_parameters(testing::Random& random, int degree, double low,
                                       double high) {
  BezierCurveOf<Point> curve;
  for (int k = 0; k <= degree; ++k) {
    Point uv;
    for (int x = 0; x < Point::kDimension; ++x) uv[x] = uniform(random, low, high);
    curve.points.push_back(uv);
  }
  return curve;
}

template <class Point>
auto exact_composition(const BezierPatchOf<Point>& patch, const auto& curve) {
  return detail::composition(exact(patch.points), detail::parameter_forms(exact(curve.points)));
}

// z = u v over the unit square.
BezierPatch saddle() {
  BezierPatch patch{Grid<Vec3>(2, 2)};
  patch.points(0, 1) = {0, 1, 0};
  patch.points(1, 0) = {1, 0, 0};
  patch.points(1, 1) = {1, 1, 1};
  return patch;
}

TEST(Composition, OfTheSaddleWithAParabolaIsTheTwistedCubic) {
  const BezierCurve cubic = composition(saddle(), BezierCurve2{{{0, 0}, {0.5, 0}, {1, 1}}});

  // (t, t^2, t^3), its degree raised from 3 to 4.
  EXPECT_EQ(cubic.points,
            (std::vector<Vec3>{
                {0, 0, 0}, {0.25, 0, 0}, {0.5, 1.0 / 6, 0}, {0.75, 0.5, 0.25}, {1, 1, 1}}));
}

TEST(Composition, WithAnIsoLineIsTheIsoCurve) {
  const BezierCurve line = on_segment(saddle(), {0.25, 1}, {0.25, 0});

  EXPECT_EQ(line.points, (std::vector<Vec3>{{0.25, 1, 0.25}, {0.25, 0.5, 0.125}, {0.25, 0, 0}}));
}

TEST(Composition, WithAPointIsThePoint) {
  EXPECT_EQ(composition(saddle(), BezierCurve2{{{0.5, 0.25}}}).points,
            (std::vector<Vec3>{{0.5, 0.25, 0.125}}));
}

TEST(Composition, OfAFunctionWithADiagonalIsAFunction) {
  BezierFunction2 uv{Grid<double>(2, 2, 0.0)};
  uv.points(1, 1) = 1;

  EXPECT_EQ(on_segment(uv, {0, 0}, {1, 1}).points, (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(point_at(on_segment(uv, {0, 0}, {1, 1}), 0.5), 0.25);
}

TEST(Composition, WithARationalCircleLiesOnTheCircle) {
  // A quarter of the unit circle in the parameters of the plane z = 0.
  RationalBezierPatch plane{Grid<Vec4>(2, 2)};
  plane.points(0, 0) = {0, 0, 0, 1};
  plane.points(0, 1) = {0, 1, 0, 1};
  plane.points(1, 0) = {1, 0, 0, 1};
  plane.points(1, 1) = {1, 1, 0, 1};
  const BezierCurve circle{{{1, 0, 1}, {1, 1, 1}, {0, 2, 2}}};

  const RationalBezierCurve result = composition(plane, circle);

  ASSERT_EQ(result.degree(), 4);
  for (double t : {0.0, 0.3, 0.7, 1.0}) {
    const Vec4 h = point_at(result, t);
    EXPECT_NEAR(h[0] * h[0] + h[1] * h[1], h[3] * h[3], 1e-14);
  }
}

class CompositionProperty : public ::testing::TestWithParam<int> {};

TEST_P(CompositionProperty, OverRationalsIsThePatchOnTheCurveExactly) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 3), m = pick(random, 0, 3), d = pick(random, 0, 3);
  const BezierPatch patch = random_patch(random, n, m);
  const BezierCurve2 curve = random_parameters(random, d, -1, 2);

  const auto result = exact_composition(patch, curve);

  // Equal at more parameters than its degree, so equal everywhere.
  for (int k = 0; k <= d * (n + m); ++k) {
    const Rational t = Rational(k, 7);
    const auto uv = exact_point(exact(curve.points), t);
    EXPECT_EQ(exact_point(result, t), exact_point(exact(patch.points), uv[0], uv[1]));
  }
}

TEST_P(CompositionProperty, OfRationalCurvesOverRationalsIsExact) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 2), m = pick(random, 0, 2), d = pick(random, 0, 3);
  const RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
  const BezierCurve curve = random_parameters<Vec3>(random, d, 0.5, 1);

  const auto result = exact_composition(patch, curve);

  for (int k = 0; k <= d * (n + m); ++k) {
    const Rational t = Rational(k, 7);
    const auto h = exact_point(exact(curve.points), t);
    Rational scale = 1;
    for (int i = 0; i < n + m; ++i) scale *= h[2];
    EXPECT_EQ(exact_point(result, t),
              exact_point(exact(patch.points), h[0] / h[2], h[1] / h[2]) * scale);
  }
}

TEST_P(CompositionProperty, InDoubleIsWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 5), m = pick(random, 0, 5), d = pick(random, 0, 6);
  const bool inside = GetParam() % 2 == 0;
  const RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
  const BezierCurve2 curve = random_parameters(random, d, inside ? 0 : -1, inside ? 1 : 2);

  const RationalBezierCurve computed = composition(patch, curve);
  const auto expected = exact_composition(patch, curve);

  ASSERT_EQ(computed.degree(), d * (n + m));
  const double bound = composition_error(n, m, d) * composition_growth(n, m, curve);
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_LE(exact_gap(computed.points[k], expected[k]), bound);
}

TEST_P(CompositionProperty, WithARationalCurveInDoubleIsWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 4), m = pick(random, 0, 4), d = pick(random, 0, 6);
  const RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
  const BezierCurve curve = random_parameters<Vec3>(random, d, -1, 1);

  const RationalBezierCurve computed = composition(patch, curve);
  const auto expected = exact_composition(patch, curve);

  const double bound = composition_error(n, m, d) * composition_growth(n, m, curve);
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_LE(exact_gap(computed.points[k], expected[k]), bound);
}

TEST_P(CompositionProperty, InTheUnitSquareStaysInTheHullOfTheNet) {
  auto random = seeded(GetParam());
  const BezierPatch patch = random_patch(random, 3, 3);
  const BezierCurve2 curve = random_parameters(random, 5, 0, 1);

  for (const Vec3& point : composition(patch, curve).points)
    EXPECT_LE(max_norm(point), 1 + composition_error(3, 3, 5));
}

INSTANTIATE_TEST_SUITE_P(Seeds, CompositionProperty, ::testing::Range(0, 40));

TEST(Composition, GrowthIsOneInTheUnitSquareAndKnownByHandOutside) {
  EXPECT_EQ(composition_growth(3, 2, BezierCurve2{{{0.25, 1}, {0, 0.5}}}), 1);
  EXPECT_EQ(composition_growth(3, 2, BezierCurve2{{{-1, 0}, {0, 3}}}), 27 * 25);
  EXPECT_EQ(composition_growth(1, 0, BezierCurve{{{3, 0, 2}}}), 4);
}

TEST(Composition, RefusesEmptyCurvesAndTooHighDegrees) {
  EXPECT_THROW(composition(saddle(), BezierCurve2{}), InvalidInput);
  EXPECT_THROW(composition(BezierPatch{}, BezierCurve2{{{0, 0}}}), InvalidInput);
  const BezierCurve2 curve{std::vector<Vec2>(12, Vec2{0.5, 0.5})};
  EXPECT_THROW(composition(BezierPatch{Grid<Vec3>(4, 4)}, curve), InvalidInput);
}

}  // namespace
}  // namespace blossom
