// SPDX-License-Identifier: LGPL-2.1-or-later
// The identities of the article on blossoms in the nanospline library, with its misprints
// corrected. Points and parameters have few bits, so that everything below is exact in double and
// compared for equality.

#include <gtest/gtest.h>

#include "core/blossom/curve_blossom.h"
#include "core/forms/algebra/conversion.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/math/binomial.h"
#include "core/subdivision/curve_subdivision.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::pick;
using testing::Random;
using testing::seeded;

std::vector<double> repeated(double first, int first_count, double second, int second_count) {
  std::vector<double> list(static_cast<std::size_t>(first_count), first);
  list.insert(list.end(), static_cast<std::size_t>(second_count), second);
  return list;
}

// The article's second program with its range and its index corrected: level r uses t_r and has
// n - r + 1 entries.
Vec3 article_blossom(std::vector<Vec3> a, const std::vector<double>& t) {
  for (const double t_r : t) {
    for (std::size_t i = 0; i + 1 < a.size(); ++i) a[i] = (1 - t_r) * a[i] + t_r * a[i + 1];
    a.pop_back();
  }
  return a.front();
}

// Degree 1..5, integer points, parameters in quarters.
class ArticleIdentities : public ::testing::TestWithParam<int> {
 protected:
  int n() const { return 1 + GetParam() % 5; }
  double quarter() { return pick(random_, -4, 8) / 4.0; }
  Random random_ = seeded(GetParam());
  BezierCurve curve_ = random_integer_curve();

  BezierCurve random_integer_curve() {
    BezierCurve curve;
    for (int i = 0; i <= n(); ++i)
      curve.points.push_back(
          {1.0 * pick(random_, -9, 9), 1.0 * pick(random_, -9, 9), 1.0 * pick(random_, -9, 9)});
    return curve;
  }
  std::vector<double> parameters(int count) {
    std::vector<double> list;
    for (int i = 0; i < count; ++i) list.push_back(quarter());
    return list;
  }
};

TEST_P(ArticleIdentities, CurveIsTheSumOfItsPointsByTheBernsteinBasis) {
  const double t = quarter();
  Vec3 sum{};
  for (int i = 0; i <= n(); ++i) {
    double weight = binomial(n(), i);
    for (int k = 0; k < n(); ++k) weight *= k < i ? t : 1 - t;
    sum += curve_.points[static_cast<std::size_t>(i)] * weight;
  }
  EXPECT_EQ(point_at(curve_, t), sum);
}

TEST_P(ArticleIdentities, BlossomVariesTheParameterFromLevelToLevel) {
  const std::vector<double> t = parameters(n());
  EXPECT_EQ(blossom_at(curve_, t), article_blossom(curve_.points, t));
}

TEST_P(ArticleIdentities, BlossomOfEqualParametersIsDeCasteljau) {
  const double t = quarter();
  EXPECT_EQ(blossom_at(curve_, repeated(t, n(), 0, 0)), point_at(curve_, t));
}

TEST_P(ArticleIdentities, BlossomIsSymmetric) {
  std::vector<double> t = parameters(n());
  const Vec3 value = blossom_at(curve_, t);
  std::shuffle(t.begin(), t.end(), random_);
  EXPECT_EQ(blossom_at(curve_, t), value);
}

TEST_P(ArticleIdentities, BlossomIsAffineForWeightsThatSumToOne) {
  std::vector<double> t = parameters(n());
  const double t_1 = quarter(), t_2 = quarter(), b = quarter(), c = 1 - b;
  t[0] = t_1;
  const Vec3 first = blossom_at(curve_, t);
  t[0] = t_2;
  const Vec3 second = blossom_at(curve_, t);
  t[0] = b * t_1 + c * t_2;
  EXPECT_EQ(blossom_at(curve_, t), b * first + c * second);
}

TEST_P(ArticleIdentities, ControlPointsAreBlossomsOfZerosAndOnes) {
  for (int i = 0; i <= n(); ++i)
    EXPECT_EQ(blossom_at(curve_, repeated(0, n() - i, 1, i)),
              curve_.points[static_cast<std::size_t>(i)]);
}

TEST_P(ArticleIdentities, PointsOfASubCurveAreBlossomsOfItsEnds) {
  // Reversed and outside of [0, 1], too.
  const double c = quarter(), d = quarter(), t = quarter();
  BezierCurve piece;
  for (int i = 0; i <= n(); ++i)
    piece.points.push_back(blossom_at(curve_, repeated(c, n() - i, d, i)));
  EXPECT_EQ(point_at(piece, t), point_at(curve_, (1 - t) * c + t * d));
  EXPECT_EQ(sub_curve(curve_, {c, d}).points, piece.points);
}

TEST_P(ArticleIdentities, DerivativeIsTheBlossomOfTheDirectionOne) {
  // The printed n a[t..t, 1] takes 1 for a parameter. The direction 1 is the difference of the
  // parameters 1 and 0.
  const double t = quarter();
  std::vector<double> arguments(static_cast<std::size_t>(n()), t);
  arguments.back() = 1;
  const Vec3 at_one = blossom_at(curve_, arguments);
  arguments.back() = 0;
  const Vec3 at_zero = blossom_at(curve_, arguments);
  EXPECT_EQ((at_one - at_zero) * n(), derivatives_at(curve_, t).first);
}

TEST_P(ArticleIdentities, DerivativeMayTakeAnyTwoParameters) {
  const double t = quarter(), x = -1, y = 1;
  std::vector<double> arguments(static_cast<std::size_t>(n()), t);
  arguments.back() = x;
  const Vec3 at_x = blossom_at(curve_, arguments);
  arguments.back() = y;
  const Vec3 at_y = blossom_at(curve_, arguments);
  EXPECT_EQ((at_y - at_x) * (n() / (y - x)), derivatives_at(curve_, t).first);
}

TEST_P(ArticleIdentities, SecondDerivativeTakesTheDirectionTwice) {
  if (n() < 2) return;
  const double t = quarter();
  const auto at_last = [&](double first, double second) {
    std::vector<double> arguments(static_cast<std::size_t>(n()), t);
    arguments[0] = first;
    arguments[1] = second;
    return blossom_at(curve_, arguments);
  };
  EXPECT_EQ((at_last(1, 1) - 2 * at_last(1, 0) + at_last(0, 0)) * (n() * (n() - 1)),
            derivatives_at(curve_, t).second);
}

// The mean over the n + 1 arguments that may be left out; there is no t_0. Both sides times n + 1.
TEST_P(ArticleIdentities, ElevatedBlossomIsTheMeanOverTheArgumentLeftOut) {
  const auto sum_without_each = [&](const std::vector<double>& t) {
    Vec3 sum{};
    for (std::size_t i = 0; i < t.size(); ++i) {
      std::vector<double> others = t;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      sum += blossom_at(curve_, others);
    }
    return sum;
  };
  // The points of the elevated curve, times n + 1: i p_(i-1) + (n + 1 - i) p_i.
  BezierCurve elevated;
  for (int i = 0; i <= n() + 1; ++i) {
    elevated.points.push_back(sum_without_each(repeated(0, n() + 1 - i, 1, i)));
    Vec3 by_hand{};
    if (i > 0) by_hand += curve_.points[static_cast<std::size_t>(i - 1)] * i;
    if (i <= n()) by_hand += curve_.points[static_cast<std::size_t>(i)] * (n() + 1 - i);
    EXPECT_EQ(elevated.points.back(), by_hand);
  }
  const double t = quarter();
  EXPECT_EQ(point_at(elevated, t), point_at(curve_, t) * (n() + 1));
  const std::vector<double> arguments = parameters(n() + 1);
  EXPECT_EQ(blossom_at(elevated, arguments), sum_without_each(arguments));
}

INSTANTIATE_TEST_SUITE_P(Seeds, ArticleIdentities, ::testing::Range(0, 20));

TEST(ArticleIdentities, PrintedLinearityFailsForOtherWeights) {
  const BezierCurveOf<Vec2> line{{{1, 0}, {2, 4}}};
  const Vec2 at_one = blossom_at(line, std::array{1.0});
  EXPECT_NE(blossom_at(line, std::array{2.0}), 1.0 * at_one + 1.0 * at_one);
}

TEST(ArticleIdentities, PrintedDerivativeIsNotTheDerivative) {
  const BezierCurveOf<Vec2> line{{{1, 0}, {2, 4}}};
  EXPECT_EQ(derivatives_at(line, 0.5).first, (Vec2{1, 4}));
  EXPECT_EQ(blossom_at(line, std::array{1.0}), (Vec2{2, 4}));
}

TEST(ArticleIdentities, QuadraticExampleHasHalfTheLinearCoefficientTwice) {
  // a[t1, t2] = c_0 + c_1 / 2 (t1 + t2) + c_2 t1 t2 for C(t) = c_0 + c_1 t + c_2 t^2.
  const MonomialCurveOf<Vec2> quadratic{{{1, 2}, {3, -5}, {7, 4}}};
  for (const double t_1 : {-1.0, 0.0, 0.5, 2.0})
    for (const double t_2 : {0.0, 1.0, 3.0}) {
      const Vec2 by_hand = Vec2{1, 2} + Vec2{1.5, -2.5} * (t_1 + t_2) + Vec2{7, 4} * (t_1 * t_2);
      EXPECT_EQ(blossom_at(quadratic, std::array{t_1, t_2}), by_hand);
      EXPECT_EQ(blossom_at(bezier_form(quadratic), std::array{t_1, t_2}), by_hand);
    }
}

}  // namespace
}  // namespace blossom
