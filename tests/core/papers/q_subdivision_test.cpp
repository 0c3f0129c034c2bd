// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/errors.h"
#include "core/math/index.h"
#include "core/papers/q_bernstein.h"
#include "core/papers/q_curve.h"
#include "tests/core/papers/q_cases.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::exact;
using testing::exact_curve;
using testing::exact_gap;
using testing::ExactCurve;
using testing::ExactPoint3;
using testing::ExactQ;
using testing::fraction;
using testing::Random;
using testing::Rational;
using testing::seeded;
using testing::uniform;

TEST(QSubdivision, OfTheBumpHasHandComputedPoints) {
  // b_1 B_1 = 3/2 x (1 - x) for q = (1/2, 1). On [0, 1/2]: 0, 1/2 B_1^1(1/2) = 1/2, 3/8.
  // On [1/2, 1]: 3/8, B_0^1(1/2) = 1/2, 0.
  const QBezierCurveOf<Vec2> bump{{{0, 0}, {1, 2}, {0, 0}}, {0, 1}, {0.5, 1}};

  const auto halves = subdivide(bump, 0.5);

  EXPECT_EQ(halves.left.points, (std::vector<Vec2>{{0, 0}, {0.5, 1}, {0.375, 0.75}}));
  EXPECT_EQ(halves.right.points, (std::vector<Vec2>{{0.375, 0.75}, {0.5, 1}, {0, 0}}));
  EXPECT_EQ(halves.left.interval, (Interval{0, 0.5}));
  EXPECT_EQ(halves.right.interval, (Interval{0.5, 1}));
}

// Random admissible curves of degree 1..6, cut at random places.
class QSubdivisionProperty : public ::testing::TestWithParam<int> {
 protected:
  int degree() const { return 1 + GetParam() % 6; }
  Random random_ = seeded(GetParam() + 300);
  ExactCurve curve_ = exact_curve(random_, degree());
  Rational t_ = fraction(random_);
};

TEST_P(QSubdivisionProperty, PointsAreTheStatedBlossomValues) {  // (5.1), (5.2)
  const auto polynomial = monomial_form(curve_);
  const auto& [a, b] = curve_.interval;
  const auto cut = q_cut_points(curve_, t_);
  for (int i = 0; i <= degree(); ++i) {
    const auto left = q_control_arguments(degree(), i, {a, t_}, curve_.q);
    const auto right = q_control_arguments(degree(), i, {t_, b}, curve_.q);
    EXPECT_EQ(cut.left[index(i)], q_blossom_at(polynomial, curve_.q, left));
    EXPECT_EQ(cut.right[index(i)], q_blossom_at(polynomial, curve_.q, right));
  }
}

TEST_P(QSubdivisionProperty, PointsAreTheStatedSums) {  // Theorem 5.1, explicit form
  const int n = degree();
  const auto cut = q_cut_points(curve_, t_);
  const bool every_degree = curve_.q.q1 + curve_.q.q2 != 0;
  if (!every_degree) return;  // bases of even degree do not exist
  for (int i = 0; i <= n; ++i) {
    const auto below = q_bernstein(i, t_, curve_.interval, curve_.q);
    const auto above = q_bernstein(n - i, t_, curve_.interval, curve_.q);
    ExactPoint3 left{}, right{};
    for (int j = 0; j <= i; ++j) left += curve_.points[index(j)] * below[index(j)];
    for (int j = 0; j <= n - i; ++j) right += curve_.points[index(i + j)] * above[index(j)];
    EXPECT_EQ(cut.left[index(i)], left);
    EXPECT_EQ(cut.right[index(i)], right);
  }
}

TEST_P(QSubdivisionProperty, HalvesAreTheCurve) {
  const ExactCurve safe = testing::safe_curve(random_, degree());
  const auto& [a, b] = safe.interval;
  const Rational t = a + (b - a) * 3 / 7, x = fraction(random_);

  const auto halves = subdivide(safe, t);

  EXPECT_EQ(point_at(halves.left, x), point_at(safe, x));
  EXPECT_EQ(point_at(halves.right, x), point_at(safe, x));
  EXPECT_EQ(halves.left.points.back(), halves.right.points.front());
}

TEST_P(QSubdivisionProperty, MidpointPiecesAreTheCurveInOrder) {
  const ExactCurve safe = testing::safe_curve(random_, degree());
  const auto pieces = midpoint_pieces(safe, 3);
  const Rational x = fraction(random_), step = (safe.interval.to - safe.interval.from) / 8;
  ASSERT_EQ(pieces.size(), 8u);
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(pieces[index(i)].interval.from, safe.interval.from + step * i);
    EXPECT_EQ(pieces[index(i)].interval.to, safe.interval.from + step * (i + 1));
    EXPECT_EQ(point_at(pieces[index(i)], x), point_at(safe, x));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, QSubdivisionProperty, ::testing::Range(0, 24));

// Degrees 1..20 in double against exact arithmetic on the same numbers.
class QSubdivisionAccuracy : public ::testing::TestWithParam<int> {};

TEST_P(QSubdivisionAccuracy, CutPointsAreWithinTheRunningBound) {
  auto random = seeded(GetParam());
  const auto short_number = [&](double low, double high) {
    return std::floor(uniform(random, low, high) * 64) / 64;
  };
  const int n = 1 + GetParam() % 20;
  const QBezierCurve curve{testing::random_curve(random, n).points,
                           {short_number(0, 0.5), short_number(1, 2)},
                           {short_number(0.5, 0.9) * (GetParam() % 2 == 0 ? 1 : -1), 1}};
  const double t = short_number(0.5, 1);
  const ExactCurve same{exact(curve.points),
                        {Rational(curve.interval.from), Rational(curve.interval.to)},
                        {Rational(curve.q.q1), Rational(1)}};

  const auto cut = q_cut_points(curve, t);

  const double bound = q_cut_error(curve, t);
  for (const int i : {1, n / 2, n}) {
    ExactPoint3 left{}, right{};
    const auto below = q_bernstein(i, Rational(t), same.interval, same.q);
    const auto above = q_bernstein(n - i, Rational(t), same.interval, same.q);
    for (int j = 0; j <= i; ++j) left += same.points[index(j)] * below[index(j)];
    for (int j = 0; j <= n - i; ++j) right += same.points[index(i + j)] * above[index(j)];
    EXPECT_LE(exact_gap(cut.left[index(i)], left), bound);
    EXPECT_LE(exact_gap(cut.right[index(i)], right), bound);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, QSubdivisionAccuracy, ::testing::Range(0, 40));

// Theorem 5.1 has no condition, yet needs one: q1 t = q2 b at t = 1/2.
TEST(QSubdivision, RefusesAPieceWithoutABasisThoughThePointsExist) {
  const QBezierCurveOf<Vec2> curve{{{0, 1}, {1, 0}, {2, 2}}, {0, 1}, {2, 1}};
  EXPECT_THROW(midpoint_pieces(curve, 1), InvalidInput);
  try {
    subdivide(curve, 0.5);
    FAIL() << "[1/2, 1] was accepted with q1 / q2 = 2";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "subdivide: q1 a = q2 b on [0.5, 1] with q1 = 2, q2 = 1: the basis of degree 2 "
                 "divides by their difference");
  }
  EXPECT_EQ(q_cut_points(curve, 0.5).right.front(), point_at(curve, 0.5));
}

TEST(QSubdivision, RefusesCutsAndLevelsOutOfRange) {
  const QBezierCurve curve{std::vector<Vec3>(4), {0, 1}, {0.5, 1}};
  EXPECT_THROW(subdivide(curve, 0.0), InvalidInput);
  EXPECT_THROW(subdivide(curve, 1.0), InvalidInput);
  EXPECT_THROW(q_cut_points(curve, std::numeric_limits<double>::infinity()), InvalidInput);
  EXPECT_THROW(q_cut_error(curve, std::numeric_limits<double>::quiet_NaN()), InvalidInput);
  EXPECT_THROW(midpoint_pieces(curve, -1), InvalidInput);
  EXPECT_THROW(midpoint_pieces(curve, kMaxQLevels + 1), InvalidInput);
}

// The largest distance between a curve and the control polygons of its pieces at equal parameters.
double polygon_distance(const QBezierCurveOf<Vec2>& curve, int levels) {
  double largest = 0;
  for (const auto& piece : midpoint_pieces(curve, levels))
    for (int k = 0; k < piece.degree(); ++k)
      for (int i = 0; i < 4; ++i) {
        const double part = (k + i / 4.0) / piece.degree();
        const Vec2 on_polygon =
            piece.points[index(k)] * (1 - i / 4.0) + piece.points[index(k + 1)] * (i / 4.0);
        largest = std::max(
            largest, distance(on_polygon, point_at(curve, blossom::at(piece.interval, part))));
      }
  return largest;
}

// Theorem 5.2 on the cubics of the paper's figures, with the rates it does not state.
class QConvergence : public ::testing::TestWithParam<QParameters> {
 protected:
  double rate(int level) const {
    const QBezierCurveOf<Vec2> curve{{{0, 0}, {1, 2}, {3, 3}, {4, 0}}, {0, 1}, GetParam()};
    return polygon_distance(curve, level - 1) / polygon_distance(curve, level);
  }
};

class QConvergenceOfEqual : public QConvergence {};
class QConvergenceOfDifferent : public QConvergence {};

TEST_P(QConvergenceOfEqual, IsByFourALevel) {
  EXPECT_NEAR(rate(6), 4, 0.1);
  EXPECT_NEAR(rate(8), 4, 0.03);
}

TEST_P(QConvergenceOfDifferent, IsByTwoALevel) {
  EXPECT_NEAR(rate(6), 2, 0.2);
  EXPECT_NEAR(rate(9), 2, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Parameters, QConvergenceOfEqual,
                         ::testing::Values(QParameters{1, 1}, QParameters{-3, -3}));
INSTANTIATE_TEST_SUITE_P(Parameters, QConvergenceOfDifferent,
                         ::testing::Values(QParameters{0.5, 0.6}, QParameters{-0.5, -2},
                                           QParameters{0.9, 1}));

}  // namespace
}  // namespace blossom
