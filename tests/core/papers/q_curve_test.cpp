// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/papers/q_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/errors.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/math/detail/bernstein.h"
#include "core/math/matrix.h"
#include "core/papers/q_bernstein.h"
#include "tests/core/papers/q_cases.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::exact;
using testing::exact_curve;
using testing::exact_gap;
using testing::exact_points;
using testing::ExactCurve;
using testing::ExactInterval;
using testing::ExactPoint3;
using testing::ExactQ;
using testing::fraction;
using testing::nonzero_fraction;
using testing::Random;
using testing::Rational;
using testing::seeded;
using testing::uniform;

ExactPoint3 classical_point(const std::vector<ExactPoint3>& points, const Rational& s) {
  ExactPoint3 sum{};
  const auto weights = detail::bernstein(static_cast<int>(points.size()) - 1, s);
  for (std::size_t k = 0; k < weights.size(); ++k) sum += points[k] * weights[k];
  return sum;
}

TEST(QCurve, OfDegreeTwoHasHandComputedForms) {
  // b_1 B_1 = 3/2 x (1 - x) for q = (1/2, 1) on [0, 1]: Bernstein coefficients 0, 3/4, 0.
  const QBezierCurveOf<Vec2> bump{{{0, 0}, {1, 2}, {0, 0}}, {0, 1}, {0.5, 1}};

  EXPECT_EQ(point_at(bump, 0.5), (Vec2{0.375, 0.75}));
  EXPECT_EQ(monomial_form(bump).coefficients, (std::vector<Vec2>{{0, 0}, {1.5, 3}, {-1.5, -3}}));
  EXPECT_EQ(bezier_form(bump).points, (std::vector<Vec2>{{0, 0}, {0.75, 1.5}, {0, 0}}));
}

// Random admissible curves, degree 1..6.
class QCurveProperty : public ::testing::TestWithParam<int> {
 protected:
  int degree() const { return 1 + GetParam() % 6; }
  Random random_ = seeded(GetParam() + 200);
  ExactCurve curve_ = exact_curve(random_, degree());
  Rational x_ = fraction(random_);
};

TEST_P(QCurveProperty, IsTheCombinationOfItsPointsByTheBasis) {  // (3.8)
  const auto basis = q_bernstein(degree(), x_, curve_.interval, curve_.q);
  ExactPoint3 sum{};
  for (std::size_t k = 0; k < basis.size(); ++k) sum += curve_.points[k] * basis[k];
  EXPECT_EQ(point_at(curve_, x_), sum);
}

TEST_P(QCurveProperty, IsEveryPolynomial) {  // Corollary 3.2
  const MonomialCurveOf<ExactPoint3> polynomial{exact_points(random_, degree())};
  const ExactCurve curve = q_bezier_form(polynomial, curve_.interval, curve_.q);
  EXPECT_EQ(point_at(curve, x_),
            testing::homogeneous_value(polynomial.coefficients, x_, Rational(1)));
  EXPECT_EQ(monomial_form(curve).coefficients, polynomial.coefficients);
}

TEST_P(QCurveProperty, HasUniqueControlPointsWhichTheDualFunctionalsFind) {  // Corollaries 3.5-3.7
  EXPECT_EQ(q_bezier_form(monomial_form(curve_), curve_.interval, curve_.q), curve_);
}

TEST_P(QCurveProperty, StartsAndEndsAtItsFirstAndLastPoint) {  // Proposition 4.4
  EXPECT_EQ(point_at(curve_, curve_.interval.from), curve_.points.front());
  EXPECT_EQ(point_at(curve_, curve_.interval.to), curve_.points.back());
}

TEST_P(QCurveProperty, IsAffinelyInvariant) {  // Proposition 4.2
  const Rational factor = fraction(random_), shear = fraction(random_), shift = fraction(random_);
  const auto moved = [&](const ExactPoint3& p) {
    return ExactPoint3{factor * p[0] + shear * p[1] + shift, p[1] - p[2], p[2] + shift};
  };
  ExactCurve image = curve_;
  for (ExactPoint3& point : image.points) point = moved(point);
  EXPECT_EQ(point_at(image, x_), moved(point_at(curve_, x_)));
}

TEST_P(QCurveProperty, DependsOnTheRatioAndTheScaleFreePlaceAlone) {
  const Rational w = nonzero_fraction(random_), z = nonzero_fraction(random_);
  const ExactCurve same{curve_.points,
                        {w * curve_.interval.from, w * curve_.interval.to},
                        {z * curve_.q.q1, z * curve_.q.q2}};
  EXPECT_EQ(point_at(same, Rational(w * x_)), point_at(curve_, x_));
}

TEST_P(QCurveProperty, HasAClassicalFormAndComesBackFromIt) {
  const BezierCurveOf<ExactPoint3> classical = bezier_form(curve_);
  const auto& [a, b] = curve_.interval;

  EXPECT_EQ(classical_point(classical.points, Rational((x_ - a) / (b - a))), point_at(curve_, x_));
  EXPECT_EQ(classical.points.front(), curve_.points.front());
  EXPECT_EQ(classical.points.back(), curve_.points.back());
  EXPECT_EQ(q_bezier_form(classical, curve_.interval, curve_.q), curve_);
}

TEST_P(QCurveProperty, ConversionMatrixHasRowsThatSumToOne) {
  const Grid<Rational> matrix = q_conversion_matrix(degree(), curve_.interval, curve_.q);
  for (int j = 0; j <= degree(); ++j) {
    Rational sum(0);
    for (int k = 0; k <= degree(); ++k) sum += matrix(j, k);
    EXPECT_EQ(sum, 1);
  }
}

TEST_P(QCurveProperty, LiesInTheHullForSafeParametersSinceTheMatrixIsNotNegative) {
  const ExactCurve safe = testing::safe_curve(random_, degree());
  const Grid<Rational> matrix = q_conversion_matrix(degree(), safe.interval, safe.q);
  for (const Rational& entry : matrix.values()) EXPECT_GE(entry, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, QCurveProperty, ::testing::Range(0, 24));

TEST(QCurve, MayLeaveTheHullElsewhere) {
  // Ratio 2 on [0, 1]: B_0 is negative at 3/4.
  const QBezierCurveOf<Vec2> curve{{{1, 0}, {0, 0}, {0, 0}}, {0, 1}, {2, 1}};
  EXPECT_LT(point_at(curve, 0.75)[0], 0);
}

// Degrees 1..25 in double against exact arithmetic on the same numbers.
class QCurveAccuracy : public ::testing::TestWithParam<int> {};

TEST_P(QCurveAccuracy, ClassicalFormIsWithinTheStatedBound) {
  auto random = seeded(GetParam());
  const auto short_number = [&](double low, double high) {
    return std::floor(uniform(random, low, high) * 32) / 32;
  };
  const int n = 1 + GetParam() % 25;
  const double q1 = short_number(0.6, 0.9) * (GetParam() % 3 == 0 ? -1 : 1);
  const QBezierCurve curve{testing::random_curve(random, n).points,
                           {short_number(0, 1), short_number(1.25, 2)},
                           {q1, 1}};

  const BezierCurve classical = bezier_form(curve);

  const double bound = bezier_form_error(curve);
  const auto wanted =
      product(q_conversion_matrix(
                  n, ExactInterval{Rational(curve.interval.from), Rational(curve.interval.to)},
                  ExactQ{Rational(q1), Rational(1)}),
              exact(curve.points));
  for (std::size_t k = 0; k < wanted.size(); ++k)
    EXPECT_LE(exact_gap(classical.points[k], wanted[k]), bound);
  if (q1 > 0) {
    EXPECT_LE(bound, 1.01 * q_conversion_error(n));  // points in the unit cube
  }
}

TEST_P(QCurveAccuracy, WayBackUndoesTheClassicalForm) {
  auto random = seeded(GetParam());
  const int n = 1 + GetParam() % 8;
  const QBezierCurve curve{testing::random_curve(random, n).points, {0, 1}, {0.75, 1}};
  const QBezierCurve back = q_bezier_form(bezier_form(curve), curve.interval, curve.q);
  for (std::size_t k = 0; k < curve.points.size(); ++k)
    EXPECT_LE(testing::coordinate_gap(back.points[k], curve.points[k]), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Seeds, QCurveAccuracy, ::testing::Range(0, 25));

TEST(QCurve, OfDegreeOneMayHaveAParameterZero) {
  const QBezierCurveOf<Vec2> line{{{0, 0}, {2, 4}}, {1, 2}, {0, 5}};
  EXPECT_EQ(point_at(line, 1.5), (Vec2{1, 2}));
  EXPECT_EQ(bezier_form(line).points, line.points);
  EXPECT_EQ(monomial_form(line).coefficients, (std::vector<Vec2>{{-2, -4}, {2, 4}}));
}

TEST(QCurve, RefusesInadmissibleParametersWithTheReason) {
  const QBezierCurve curve{std::vector<Vec3>(3), {0.5, 1}, {2, 1}};
  try {
    point_at(curve, 0.75);
    FAIL() << "q1 a = q2 b was accepted";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "point_at: q1 a = q2 b on [0.5, 1] with q1 = 2, q2 = 1: the basis of degree 2 "
                 "divides by their difference");
  }
  EXPECT_THROW(bezier_form(curve), InvalidInput);
  EXPECT_THROW(monomial_form(curve), InvalidInput);
  EXPECT_THROW(bezier_form_error(curve), InvalidInput);
  EXPECT_THROW(q_bezier_form(BezierCurve{std::vector<Vec3>(3)}, {0.5, 1}, {2, 1}), InvalidInput);
  EXPECT_THROW(q_bezier_form(MonomialCurve{std::vector<Vec3>(3)}, {0.5, 1}, {2, 1}), InvalidInput);
  EXPECT_THROW(q_conversion_matrix(3, Interval{1, 1}, QParameters{}), InvalidInput);
  EXPECT_THROW(point_at(QBezierCurve{}, 0.0), InvalidInput);
}

TEST(QCurve, RefusesPointsThatAreNotFinite) {
  QBezierCurve curve{std::vector<Vec3>(3), {0, 1}, {0.5, 1}};
  curve.points[1][2] = std::numeric_limits<double>::quiet_NaN();
  try {
    point_at(curve, 0.5);
    FAIL() << "NaN was accepted";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "point_at: point 2 of 3 is not finite");
  }
  EXPECT_THROW(bezier_form(curve), InvalidInput);
  EXPECT_THROW(subdivide(curve, 0.5), InvalidInput);
  EXPECT_THROW(q_bezier_form(BezierCurve{curve.points}, {0, 1}, {}), InvalidInput);
  EXPECT_THROW(q_control_points(MonomialCurve{curve.points}, {0, 1}, {}), InvalidInput);
  EXPECT_THROW(q_evaluation_levels(curve.points, {0, 1}, {}, 0.5, identity_permutation(2)),
               InvalidInput);
}

}  // namespace
}  // namespace blossom
