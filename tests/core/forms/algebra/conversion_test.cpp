// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/conversion.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/errors.h"
#include "core/blossom/detail/closed_form.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/forms/algebra/detail/conversion.h"
#include "tests/support/exact.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::coordinate_gap;
using testing::exact;
using testing::exact_gap;
using testing::random_curve;
using testing::random_patch;
using testing::random_triangle;
using testing::Rational;
using testing::seeded;
using testing::uniform;

using ExactPoint = Vec<Rational, 3>;

constexpr Origin kOrigins[] = {Origin::Start, Origin::Middle};

TEST(MonomialForm, OfAParabolaIsKnownByHand) {
  const BezierCurve2 parabola{{{0, 0}, {1, 2}, {2, 0}}};  // (2t, 4t - 4t^2)

  const auto start = monomial_form(parabola, Origin::Start);
  const auto middle = monomial_form(parabola, Origin::Middle);

  EXPECT_EQ(start.coefficients, (std::vector<Vec2>{{0, 0}, {2, 4}, {0, -4}}));
  EXPECT_EQ(middle.coefficients, (std::vector<Vec2>{{1, 1}, {1, 0}, {0, -1}}));
  EXPECT_EQ(middle.centre, 0.5);
  EXPECT_EQ(middle.scale, 0.5);
}

TEST(MonomialForm, OfTheSaddleIsUV) {
  BezierPatch saddle{Grid<Vec3>(2, 2)};
  saddle.points(0, 1) = {0, 1, 0};
  saddle.points(1, 0) = {1, 0, 0};
  saddle.points(1, 1) = {1, 1, 1};

  const MonomialPatch plain = monomial_form(saddle, Origin::Start);

  EXPECT_EQ(plain.coefficients(0, 0), (Vec3{0, 0, 0}));
  EXPECT_EQ(plain.coefficients(1, 0), (Vec3{1, 0, 0}));
  EXPECT_EQ(plain.coefficients(0, 1), (Vec3{0, 1, 0}));
  EXPECT_EQ(plain.coefficients(1, 1), (Vec3{0, 0, 1}));
}

TEST(BezierForm, TakesAnyCentreAndScale) {
  // (t - 2)^2 with centre 2 and scale 4: 16 ((t - 2) / 4)^2.
  const MonomialCurveOf<Vec2> curve{{{0, 0}, {4, 0}, {0, 16}}, 2, 4};

  const BezierCurve2 bezier = bezier_form(curve);

  EXPECT_EQ(bezier.points, (std::vector<Vec2>{{-2, 4}, {-1.5, 2}, {-1, 1}}));
}

class ConversionProperty : public ::testing::TestWithParam<int> {
 protected:
  int degree() const { return GetParam() % 26; }
};

TEST_P(ConversionProperty, CoefficientsAreWithinTheStatedError) {
  auto random = seeded(GetParam());
  const BezierCurve curve = random_curve(random, degree());
  for (const Origin origin : kOrigins) {
    const MonomialCurve computed = monomial_form(curve, origin);
    const auto expected = detail::monomial_line(exact(curve.points), origin);

    Vec3 sum{};
    for (std::size_t i = 0; i < expected.size(); ++i)
      for (int x = 0; x < 3; ++x) sum[x] += exact_gap(computed.coefficients[i][x], expected[i][x]);
    EXPECT_LE(max_norm(sum), monomial_error(degree(), 0, origin));
  }
}

TEST_P(ConversionProperty, RoundTripOfACurveIsWithinTheStatedError) {
  auto random = seeded(GetParam());
  const BezierCurve curve = random_curve(random, degree());
  for (const Origin origin : kOrigins) {
    const BezierCurve back = bezier_form(monomial_form(curve, origin));
    for (std::size_t k = 0; k < curve.points.size(); ++k)
      EXPECT_LE(coordinate_gap(back.points[k], curve.points[k]),
                round_trip_error(degree(), 0, origin));
  }
}

TEST_P(ConversionProperty, RoundTripOfAPatchIsWithinTheStatedError) {
  auto random = seeded(GetParam());
  const int n = GetParam() % 10, m = GetParam() % 7;
  const RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
  for (const Origin origin : kOrigins) {
    const RationalBezierPatch back = bezier_form(monomial_form(patch, origin));
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= m; ++j)
        EXPECT_LE(coordinate_gap(back.points(i, j), patch.points(i, j)),
                  round_trip_error(n, m, origin));
  }
}

TEST_P(ConversionProperty, RoundTripIsExactInRationals) {
  auto random = seeded(GetParam());
  const std::vector<ExactPoint> points = exact(random_curve(random, degree()).points);
  const IntervalOf<Rational> unit{Rational(0), Rational(1)};

  const MonomialCurveOf<ExactPoint> start{detail::monomial_line(points, Origin::Start)};
  const MonomialCurveOf<ExactPoint> middle{detail::monomial_line(points, Origin::Middle), 0.5, 0.5};

  EXPECT_EQ(detail::bezier_line(start, unit), points);
  EXPECT_EQ(detail::bezier_line(middle, unit), points);
}

TEST_P(ConversionProperty, BothFormsAreTheSameCurve) {
  auto random = seeded(GetParam());
  const BezierCurve curve = random_curve(random, degree());
  const double t = uniform(random, 0, 1);
  for (const Origin origin : kOrigins)
    EXPECT_LE(coordinate_gap(testing::reference_point(monomial_form(curve, origin), t),
                             testing::reference_point(curve, t)),
              round_trip_error(degree(), 0, origin));
}

INSTANTIATE_TEST_SUITE_P(Seeds, ConversionProperty, ::testing::Range(0, 26));

TEST(MonomialForm, OfATriangleIsUndoneByTheoremThree) {
  for (int degree = 0; degree <= 8; ++degree) {
    auto random = seeded(degree);
    BezierTriangleOf<ExactPoint> triangle{degree, exact(random_triangle(random, degree).points)};
    const std::array<Vec<Rational, 2>, 3> unit{Vec<Rational, 2>{Rational(1), Rational(0)},
                                               Vec<Rational, 2>{Rational(0), Rational(1)},
                                               Vec<Rational, 2>{Rational(0), Rational(0)}};
    EXPECT_EQ(detail::triangle_points(detail::monomial_triangle(triangle), unit, degree),
              triangle.points);
  }
}

TEST(MonomialForm, OfATriangleIsTheSameSurface) {
  auto random = seeded(5);
  const BezierTriangle triangle = random_triangle(random, 4);
  const MonomialPatch patch = monomial_form(triangle);

  const Vec3 on_patch = testing::reference_point(patch, 0.25, 0.5);
  const Vec3 on_triangle = point_at(triangle, 0.25, 0.5);

  // The coefficients of a cubic or quartic over a triangle sum to at most 5^4, each exact to 5 u.
  EXPECT_LE(coordinate_gap(on_patch, on_triangle), 5 * 625 * 0x1p-53);
}

TEST(MonomialForm, RefusesFormsWithoutPointsOrAboveTheHighestDegree) {
  EXPECT_THROW(monomial_form(BezierCurve{}), InvalidInput);
  EXPECT_THROW(monomial_form(BezierPatch{}), InvalidInput);
  EXPECT_THROW(monomial_form(BezierCurve{std::vector<Vec3>(27)}), InvalidInput);
  EXPECT_THROW(monomial_form(BezierTriangle{2, std::vector<Vec3>(5)}), InvalidInput);
}

TEST(BezierForm, RefusesAScaleOfZeroAndACentreThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(bezier_form(MonomialCurve{{{1, 2, 3}}, 0, 0}), InvalidInput);
  EXPECT_THROW(bezier_form(MonomialCurve{{{1, 2, 3}}, nan, 1}), InvalidInput);
  EXPECT_THROW(bezier_form(MonomialCurve{}), InvalidInput);
}

}  // namespace
}  // namespace blossom
