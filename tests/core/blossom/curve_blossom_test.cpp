// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blossom/curve_blossom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/forms/algebra/conversion.h"
#include "core/forms/algebra/de_casteljau.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::coordinate_gap;
using testing::lerp;
using testing::random_curve;
using testing::random_monomial_curve;
using testing::reference_point;
using testing::seeded;
using testing::uniform;

TEST(CurveBlossom, OfTheSquareIsTheProduct) {
  const MonomialCurveOf<Vec2> square{{{0, 0}, {1, 0}, {0, 1}}};  // (t, t^2)

  EXPECT_EQ(blossom_at(square, std::array{3.0, 5.0}), (Vec2{4, 15}));
}

TEST(CurveBlossom, OfDegreeZeroNeedsNoParameter) {
  EXPECT_EQ(blossom_at(MonomialCurveOf<Vec2>{{{2, 3}}}, std::array<double, 0>{}), (Vec2{2, 3}));
  EXPECT_EQ(blossom_at(BezierCurve2{{{2, 3}}}, std::array<double, 0>{}), (Vec2{2, 3}));
}

TEST(CurveBlossom, GivesTheBezierPointsOfTheSquareOnAnInterval) {
  const MonomialCurveOf<Vec2> square{{{0, 0}, {1, 0}, {0, 1}}};

  EXPECT_EQ(bezier_points(square, {1, 3}).points, (std::vector<Vec2>{{1, 1}, {2, 3}, {3, 9}}));
}

TEST(CurveBlossom, TakesZeroToTheZeroAsOne) {
  const MonomialCurveOf<Vec2> constant{{{1, 2}, {0, 0}, {0, 0}}};

  EXPECT_EQ(bezier_points(constant, {0, 0}).points, (std::vector<Vec2>(3, Vec2{1, 2})));
}

TEST(CurveBlossom, GivesEqualPointsOnAnIntervalOfOnePoint) {
  auto random = seeded(3);
  const MonomialCurve curve = random_monomial_curve(random, 4);

  const BezierCurve point = bezier_points(curve, {0.75, 0.75});

  for (const Vec3& p : point.points)
    EXPECT_LE(coordinate_gap(p, reference_point(curve, 0.75)),
              blossom_error(4) * blossom_scale(curve, {0.75, 0.75}));
}

// Degrees 0..25; the seed is the parameter. Intervals may reverse and reach outside [0, 1].
class CurveBlossomProperty : public ::testing::TestWithParam<int> {
 protected:
  int degree() const { return GetParam() % 26; }
  std::vector<double> parameters(testing::Random& random) const {
    std::vector<double> result;
    for (int k = 0; k < degree(); ++k) result.push_back(uniform(random, 0, 1));
    return result;
  }
  // All coefficients and parameters are at most 1 in size, so no term is above 1.
  double bound() const { return blossom_error(degree()) * (degree() + 1); }
};

TEST_P(CurveBlossomProperty, IsSymmetric) {
  auto random = seeded(GetParam());
  const MonomialCurve curve = random_monomial_curve(random, degree());
  const BezierCurve bezier = random_curve(random, degree());
  std::vector<double> t = parameters(random);
  const Vec3 value = blossom_at(curve, t), bezier_value = blossom_at(bezier, t);
  std::shuffle(t.begin(), t.end(), random);

  EXPECT_LE(coordinate_gap(blossom_at(curve, t), value), 2 * bound());
  EXPECT_LE(coordinate_gap(blossom_at(bezier, t), bezier_value), 2 * de_casteljau_error(degree()));
}

TEST_P(CurveBlossomProperty, IsAffineInEachParameter) {
  if (degree() == 0) return;
  auto random = seeded(GetParam());
  const MonomialCurve curve = random_monomial_curve(random, degree());
  std::vector<double> t = parameters(random);
  double& moved = t[static_cast<std::size_t>(testing::pick(random, 0, degree() - 1))];
  const double a = uniform(random, 0, 1), b = uniform(random, 0, 1), s = uniform(random, 0, 1);

  moved = a;
  const Vec3 at_a = blossom_at(curve, t);
  moved = b;
  const Vec3 at_b = blossom_at(curve, t);
  moved = lerp(a, b, s);

  EXPECT_LE(coordinate_gap(blossom_at(curve, t), at_a * (1 - s) + at_b * s), 3 * bound());
}

TEST_P(CurveBlossomProperty, IsTheCurveOnTheDiagonal) {
  auto random = seeded(GetParam());
  const MonomialCurve curve = random_monomial_curve(random, degree());
  const BezierCurve bezier = random_curve(random, degree());
  const double t = uniform(random, 0, 1);
  const std::vector<double> diagonal(static_cast<std::size_t>(degree()), t);

  EXPECT_LE(coordinate_gap(blossom_at(curve, diagonal), reference_point(curve, t)), bound());
  EXPECT_LE(coordinate_gap(blossom_at(bezier, diagonal), reference_point(bezier, t)),
            de_casteljau_error(degree()));
}

TEST_P(CurveBlossomProperty, IsTheSameInBothForms) {
  auto random = seeded(GetParam());
  const BezierCurve bezier = random_curve(random, degree());
  const std::vector<double> t = parameters(random);
  for (const Origin origin : {Origin::Start, Origin::Middle})
    EXPECT_LE(coordinate_gap(blossom_at(monomial_form(bezier, origin), t), blossom_at(bezier, t)),
              2 * round_trip_error(degree(), 0, origin));
}

TEST_P(CurveBlossomProperty, BezierPointsAreBlossomsAtRepeatedEnds) {
  auto random = seeded(GetParam());
  const MonomialCurve curve = random_monomial_curve(random, degree());
  const Interval piece{uniform(random, -1, 2), uniform(random, -1, 2)};
  const double size = blossom_error(degree()) * blossom_scale(curve, piece);

  const BezierCurve points = bezier_points(curve, piece);

  std::vector<double> ends(static_cast<std::size_t>(degree()), piece.from);
  for (std::size_t k = 0; k < points.points.size(); ++k) {
    EXPECT_LE(coordinate_gap(points.points[k], blossom_at(curve, ends)), 2 * size);
    if (k < ends.size()) ends[k] = piece.to;
  }
}

TEST_P(CurveBlossomProperty, BezierPointsAreThoseOfTheCurve) {
  auto random = seeded(GetParam());
  MonomialCurve curve = random_monomial_curve(random, degree());
  curve.centre = uniform(random, -1, 1);
  curve.scale = uniform(random, 0.5, 2);
  const Interval piece{uniform(random, -1, 2), uniform(random, -1, 2)};
  const double t = uniform(random, 0, 1);

  const BezierCurve points = bezier_points(curve, piece);

  EXPECT_LE(coordinate_gap(reference_point(points, t),
                           reference_point(curve, lerp(piece.from, piece.to, t))),
            2 * blossom_error(degree()) * blossom_scale(curve, piece));
}

TEST_P(CurveBlossomProperty, ReversedIntervalsGiveReversedPoints) {
  auto random = seeded(GetParam());
  const MonomialCurve curve = random_monomial_curve(random, degree());
  const Interval piece{uniform(random, 0, 1), uniform(random, 0, 1)};

  std::vector<Vec3> forward = bezier_points(curve, piece).points;
  const std::vector<Vec3> backward = bezier_points(curve, {piece.to, piece.from}).points;
  std::reverse(forward.begin(), forward.end());

  for (std::size_t k = 0; k < forward.size(); ++k)
    EXPECT_LE(coordinate_gap(forward[k], backward[k]),
              2 * blossom_error(degree()) * blossom_scale(curve, piece));
}

INSTANTIATE_TEST_SUITE_P(Seeds, CurveBlossomProperty, ::testing::Range(0, 26));

TEST(CurveBlossom, SaysHowManyParametersItTakes) {
  const MonomialCurve cubic{std::vector<Vec3>(4)};
  try {
    blossom_at(cubic, std::array{0.0, 1.0});
    FAIL() << "two parameters were accepted";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "blossom_at: a curve of degree 3 takes 3 parameters, got 2");
  }
}

TEST(CurveBlossom, RefusesWhatIsNotFiniteOrHasNoDegree) {
  const MonomialCurve line{std::vector<Vec3>(2)};
  EXPECT_THROW(blossom_at(line, std::array{kInfinity}), InvalidInput);
  EXPECT_THROW(bezier_points(line, {0, kInfinity}), InvalidInput);
  EXPECT_THROW(bezier_points(MonomialCurve{}, {0, 1}), InvalidInput);
  EXPECT_THROW(bezier_points(MonomialCurve{std::vector<Vec3>(27)}, {0, 1}), InvalidInput);
  EXPECT_THROW(blossom_at(BezierCurve{}, std::array<double, 0>{}), InvalidInput);
}

}  // namespace
}  // namespace blossom
