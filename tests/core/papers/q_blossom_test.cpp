// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/papers/q_blossom.h"
#include "core/math/index.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/blossom/detail/closed_form.h"
#include "core/forms/algebra/detail/conversion.h"
#include "core/papers/q_bernstein.h"
#include "tests/core/papers/q_cases.h"
#include "tests/support/golden.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::all_permutations;
using testing::exact_curve;
using testing::exact_gap;
using testing::exact_pairs;
using testing::exact_points;
using testing::ExactCurve;
using testing::ExactInterval;
using testing::ExactPoint2;
using testing::ExactPoint3;
using testing::ExactQ;
using testing::fraction;
using testing::nonzero_fraction;
using testing::power;
using testing::Random;
using testing::Rational;
using testing::seeded;
using testing::uniform;

using ExactMonomial = MonomialCurveOf<ExactPoint3>;
TEST(QBlossom, OfTheSquareIsTheProductOverTheDiagonalFactors) {
  // P = (x, x^2), q = (2, 3): p of x y is (x1 y2 + x2 y1) / (2 + 3), that of x^2 is x1 x2 / 2.
  const MonomialCurveOf<Vec2> square{{{0, 0}, {1, 0}, {0, 1}}};

  EXPECT_EQ(q_blossom_at(square, {2, 3}, std::vector<Vec2>{{1, 2}, {3, 1}}), (Vec2{7.0 / 5, 1.5}));
}

// Random curves of degree 1..6 over random admissible intervals.
class QBlossomProperty : public ::testing::TestWithParam<int> {
 protected:
  int degree() const { return 1 + GetParam() % 6; }
  Random random_ = seeded(GetParam());
  ExactCurve curve_ = exact_curve(random_, degree());
  ExactMonomial polynomial_{exact_points(random_, degree())};

  ExactPoint3 blossom(const std::vector<ExactPoint2>& arguments) const {
    return q_blossom_at(polynomial_, curve_.q, arguments);
  }
  std::vector<ExactPoint2> diagonal(const Rational& x, const Rational& y) const {
    std::vector<ExactPoint2> arguments;
    for (int i = degree() - 1; i >= 0; --i)
      arguments.push_back({power(curve_.q.q1, i) * x, power(curve_.q.q2, i) * y});
    return arguments;
  }
};

TEST_P(QBlossomProperty, IsSymmetric) {
  std::vector<ExactPoint2> arguments = exact_pairs(random_, degree());
  const ExactPoint3 value = blossom(arguments);
  std::shuffle(arguments.begin(), arguments.end(), random_);
  EXPECT_EQ(blossom(arguments), value);
}

TEST_P(QBlossomProperty, IsLinearInEachPair) {
  std::vector<ExactPoint2> arguments = exact_pairs(random_, degree());
  ExactPoint2& moved = arguments[index(testing::pick(random_, 0, degree() - 1))];
  const ExactPoint2 first = moved, second = exact_pairs(random_, 1)[0];
  const Rational s = fraction(random_), t = fraction(random_);

  const ExactPoint3 at_first = blossom(arguments);
  moved = second;
  const ExactPoint3 at_second = blossom(arguments);
  moved = first * s + second * t;

  EXPECT_EQ(blossom(arguments), at_first * s + at_second * t);
}

TEST_P(QBlossomProperty, IsTheHomogeneousPolynomialOnTheDiagonal) {
  const Rational x = fraction(random_), y = fraction(random_);
  EXPECT_EQ(blossom(diagonal(x, y)), testing::homogeneous_value(polynomial_.coefficients, x, y));
}

TEST_P(QBlossomProperty, IsTheQBlossomOfTheRatioTimesAPower) {
  const std::vector<ExactPoint2> arguments = exact_pairs(random_, degree());
  const ExactQ ratio{curve_.q.q1 / curve_.q.q2, Rational(1)};
  EXPECT_EQ(blossom(arguments), q_blossom_at(polynomial_, ratio, arguments) *
                                    power(curve_.q.q2, -degree() * (degree() - 1) / 2));
}

TEST_P(QBlossomProperty, IsTheClassicalBlossomForParametersOne) {
  const std::vector<ExactPoint2> arguments = exact_pairs(random_, degree());
  std::vector<ExactPoint2> affine = arguments;
  std::vector<Rational> parameters;
  for (ExactPoint2& pair : affine) {
    pair[1] = Rational(1);
    parameters.push_back(pair[0]);
  }
  const auto weights = detail::monomial_blossoms(std::span<const Rational>(parameters));
  ExactPoint3 classical{};
  for (std::size_t k = 0; k < weights.size(); ++k)
    classical += polynomial_.coefficients[k] * weights[k];
  EXPECT_EQ(q_blossom_at(polynomial_, {}, affine), classical);
}

TEST_P(QBlossomProperty, ExpandsCentreAndScale) {
  const ExactMonomial placed{polynomial_.coefficients, 0.5, 2};
  const Rational x = fraction(random_);
  const Rational local = (x - Rational(1) / 2) / 2;
  EXPECT_EQ(q_blossom_at(placed, curve_.q, diagonal(x, Rational(1))),
            testing::homogeneous_value(polynomial_.coefficients, local, Rational(1)));
}

// Theorem 2.5, with every intermediate value, for three values of c.
TEST_P(QBlossomProperty, RecursionHoldsBlossomValuesWhateverC) {
  const std::vector<ExactPoint2> arguments = exact_pairs(random_, degree());
  const int n = degree();
  for (const Rational& c : {Rational(1), Rational(-2), Rational(3, 5)}) {
    const auto points = q_control_points(polynomial_, curve_.interval, curve_.q, c);
    const auto levels = q_blossom_levels(points, curve_.interval, curve_.q, arguments, c);
    for (int r = 0; r <= n; ++r)
      for (int k = 0; k <= n - r; ++k) {
        // The first n - r - k ends a, the first r arguments, the last k ends b.
        const auto starts = q_control_arguments(n, k, curve_.interval, curve_.q, c);
        std::vector<ExactPoint2> mixed(starts.begin(), starts.begin() + (n - r - k));
        mixed.insert(mixed.end(), arguments.begin(), arguments.begin() + r);
        mixed.insert(mixed.end(), starts.end() - k, starts.end());
        EXPECT_EQ(levels[index(r)][index(k)], blossom(mixed));
      }
    EXPECT_EQ(levels.back()[0], blossom(arguments));
  }
}

// Corollary 2.6 and, for c = 1, Theorem 3.3.
TEST_P(QBlossomProperty, EveryPermutationEvaluatesThePolynomial) {
  const Rational x = fraction(random_);
  for (const Rational& c : {Rational(1), Rational(-3, 2)}) {
    const auto points = q_control_points(polynomial_, curve_.interval, curve_.q, c);
    const ExactPoint3 value = testing::homogeneous_value(polynomial_.coefficients, x, c);
    auto permutations =
        degree() <= 4 ? all_permutations(degree()) : std::vector(3, identity_permutation(degree()));
    if (degree() > 4)
      for (auto& sigma : permutations) std::shuffle(sigma.begin(), sigma.end(), random_);
    for (const auto& sigma : permutations)
      EXPECT_EQ(q_evaluation_levels(points, curve_.interval, curve_.q, x, sigma).back()[0], value);
  }
}

TEST_P(QBlossomProperty, EvaluationIsTheRecursionAtStretchedArguments) {
  const Rational x = fraction(random_), c(-7, 3);
  std::vector<int> permutation = identity_permutation(degree());
  std::shuffle(permutation.begin(), permutation.end(), random_);
  std::vector<ExactPoint2> arguments;
  for (const int sigma : permutation)
    arguments.push_back({power(curve_.q.q1, sigma - 1) * x, power(curve_.q.q2, sigma - 1) * c});
  const auto points = q_control_points(polynomial_, curve_.interval, curve_.q, c);

  EXPECT_EQ(q_evaluation_levels(points, curve_.interval, curve_.q, x, permutation),
            q_blossom_levels(points, curve_.interval, curve_.q, arguments, c));
}

TEST_P(QBlossomProperty, IntermediatePointsDependOnTheRatioUpToAPower) {
  const Rational x = fraction(random_);
  std::vector<int> sigma = identity_permutation(degree());
  std::shuffle(sigma.begin(), sigma.end(), random_);
  const ExactQ ratio{curve_.q.q1 / curve_.q.q2, Rational(1)};

  const auto levels = q_evaluation_levels(curve_.points, curve_.interval, curve_.q, x, sigma);
  const auto of_ratio = q_evaluation_levels(curve_.points, curve_.interval, ratio, x, sigma);

  for (int r = 0, sum = 0; r <= degree(); ++r) {
    for (int k = 0; k <= degree() - r; ++k)
      EXPECT_EQ(levels[index(r)][index(k)],
                of_ratio[index(r)][index(k)] * power(curve_.q.q2, sum - (r * k + r * (r - 1) / 2)));
    if (r < degree()) sum += sigma[index(r)] - 1;
  }
}

TEST_P(QBlossomProperty, StepsAreAffineForSecondParameterOne) {
  const ExactQ ratio{curve_.q.q1 / curve_.q.q2, Rational(1)};
  const std::vector<ExactPoint3> ones(index(degree() + 1), {Rational(1), Rational(1), Rational(1)});
  const auto levels = q_evaluation_levels(ones, curve_.interval, ratio, fraction(random_),
                                          reversed_permutation(degree()));
  for (const auto& level : levels)
    for (const ExactPoint3& point : level) EXPECT_EQ(point, ones[0]);
}

// Theorem 3.9.
TEST_P(QBlossomProperty, AnyQAndPermutationGiveAnAlgorithmForTheClassicalCurve) {
  const Rational x = fraction(random_);
  const auto& [a, b] = curve_.interval;
  const auto weights = detail::bernstein(degree(), Rational((x - a) / (b - a)));
  ExactPoint3 value{};
  for (std::size_t k = 0; k < weights.size(); ++k) value += curve_.points[k] * weights[k];
  for (const Rational& q : {Rational(1), Rational(-1), Rational(2, 3), nonzero_fraction(random_)}) {
    std::vector<int> sigma = identity_permutation(degree());
    std::shuffle(sigma.begin(), sigma.end(), random_);
    const auto levels = classical_levels(curve_.points, curve_.interval, q, x, sigma);
    EXPECT_EQ(levels.back()[0], value);
    EXPECT_EQ(levels, q_evaluation_levels(curve_.points, curve_.interval, {q, q}, x, sigma));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, QBlossomProperty, ::testing::Range(0, 24));

TEST(QBlossom, HasADifferentClassicalAlgorithmForEachQ) {
  const std::vector<Vec2> points{{0, 0}, {1, 2}, {3, 1}};
  const std::vector<int> identity = identity_permutation(2);
  const auto plain = classical_levels(points, {0, 1}, 1.0, 0.5, identity);
  const auto stretched = classical_levels(points, {0, 1}, 2.0, 0.5, identity);
  EXPECT_EQ(plain[1][1], (Vec2{2, 1.5}));
  EXPECT_EQ(stretched[1][1], (Vec2{1, 0.75}));
  EXPECT_EQ(stretched[2][0], plain[2][0]);
}

// Degrees 1..25, both signs of the ratio, against exact arithmetic on the same doubles. These have
// ten bits, which keeps the fractions short; their powers are rounded all the same.
class QBlossomAccuracy : public ::testing::TestWithParam<int> {
 protected:
  int degree() const { return 1 + GetParam() % 25; }
  Random random_ = seeded(GetParam());
  QParameters q_ = parameters();
  Interval interval_{short_number(0, 1), short_number(1.5, 2)};

  double short_number(double low, double high) {
    return std::floor(uniform(random_, low, high) * 1024) / 1024;
  }
  QParameters parameters() {
    const double q1 = short_number(0.6, 0.8) * (GetParam() % 3 == 0 ? -1 : 1);
    return {q1, short_number(0.8, 1.25)};
  }
  ExactQ exact_q() const { return {Rational(q_.q1), Rational(q_.q2)}; }
  ExactInterval exact_interval() const {
    return {Rational(interval_.from), Rational(interval_.to)};
  }
};

TEST_P(QBlossomAccuracy, EvaluationIsWithinTheRunningBound) {
  const std::vector<Vec3> points = testing::random_curve(random_, degree()).points;
  const double x = short_number(interval_.from, interval_.to);
  const std::vector<Rational> basis =
      q_bernstein(degree(), Rational(x), exact_interval(), exact_q());
  ExactPoint3 wanted{};
  for (std::size_t k = 0; k < points.size(); ++k) wanted += testing::exact(points[k]) * basis[k];
  std::vector<int> random_order = identity_permutation(degree());
  std::shuffle(random_order.begin(), random_order.end(), random_);
  for (const auto& sigma :
       {identity_permutation(degree()), reversed_permutation(degree()), random_order}) {
    const Vec3 value = q_evaluation_levels(points, interval_, q_, x, sigma).back()[0];
    EXPECT_LE(exact_gap(value, wanted), q_evaluation_error(points, interval_, q_, x, sigma));
  }
}

TEST_P(QBlossomAccuracy, ControlPointsAreWithinTheStatedBound) {
  const MonomialCurve curve = testing::random_monomial_curve(random_, degree());
  const ExactMonomial same{testing::exact(curve.coefficients)};

  const std::vector<Vec3> points = q_control_points(curve, interval_, q_);

  for (const int k : {0, degree() / 2, degree()}) {
    const auto arguments = q_control_arguments(degree(), k, interval_, q_);
    const ExactPoint3 wanted = q_blossom_at(
        same, exact_q(), q_control_arguments(degree(), k, exact_interval(), exact_q()));
    EXPECT_LE(exact_gap(points[index(k)], wanted),
              q_blossom_error(degree()) * q_blossom_scale(curve, q_, arguments));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, QBlossomAccuracy, ::testing::Range(0, 50));

TEST(QBlossom, RefusesWhatHasNoBlossomWithTheReason) {
  const MonomialCurve square{std::vector<Vec3>(3)};
  try {
    q_blossom_at(square, {1, -1}, std::vector<Vec2>(2));
    FAIL() << "q1 = -q2 was accepted for an even degree";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "q_blossom_at: q1 = -q2 = 1 and the degree is 2: x^k y^(n-k) has no "
                 "(q1,q2)-blossom for odd k, since n is even");
  }
}

TEST(QBlossom, RefusesArgumentsThatDoNotFit) {
  const MonomialCurve square{std::vector<Vec3>(3)};
  const std::vector<Vec3> points(3);
  EXPECT_THROW(q_blossom_at(square, {2, 3}, std::vector<Vec2>(3)), InvalidInput);
  EXPECT_THROW(q_blossom_at(square, {2, 3}, std::vector<Vec2>{{1, 1}, {kInfinity, 1}}),
               InvalidInput);
  EXPECT_THROW(
      q_blossom_at(MonomialCurve{std::vector<Vec3>(4)}, {1e200, 1e200}, std::vector<Vec2>(3)),
      InvalidInput);
  EXPECT_THROW(q_blossom_at(MonomialCurve{}, {2, 3}, std::vector<Vec2>{}), InvalidInput);
  EXPECT_THROW(q_control_points(square, {0, 1}, {2, 3}, 0.0), InvalidInput);
  EXPECT_THROW(q_control_points(square, {1, 1}, {2, 3}), InvalidInput);
  EXPECT_THROW(q_control_arguments(2, 3, Interval{}, QParameters{}), InvalidInput);
  EXPECT_THROW(q_blossom_levels(points, {0, 1}, {2, 3}, std::vector<Vec2>(1)), InvalidInput);
}

TEST(QBlossom, RefusesWhatIsNoPermutation) {
  const std::vector<Vec3> points(4);
  for (const std::vector<int>& wrong :
       {std::vector<int>{1, 2}, {1, 2, 2}, {0, 1, 2}, {2, 3, 4}, {1, 2, 3, 4}}) {
    EXPECT_THROW(q_evaluation_levels(points, {0, 1}, {2, 3}, 0.5, wrong), InvalidInput);
    EXPECT_THROW(classical_levels(points, {0, 1}, 2.0, 0.5, wrong), InvalidInput);
  }
  EXPECT_THROW(classical_levels(points, {0, 1}, 0.0, 0.5, identity_permutation(3)), InvalidInput);
  EXPECT_THROW(classical_levels(points, {1, 1}, 2.0, 0.5, identity_permutation(3)), InvalidInput);
}

}  // namespace
}  // namespace blossom
