// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/sign.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/errors.h"
#include "tests/core/forms/exact_forms.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::exact;
using testing::exact_point;
using testing::pick;
using testing::Rational;
using testing::seeded;
using testing::uniform;

constexpr double kMin = std::numeric_limits<double>::denorm_min();
constexpr double kLargest = std::numeric_limits<double>::max();

int sign_of(const Rational& value) { return value.sign(); }

TEST(Sign, OfAParabolaIsKnownByHand) {
  const BezierFunction parabola{{1, -1, 1}};  // (2t - 1)^2

  EXPECT_EQ(sign_at(parabola, 0.5), 0);
  EXPECT_EQ(sign_at(parabola, std::nextafter(0.5, 1)), 1);
  EXPECT_EQ(sign_at(BezierFunction{{1, -2, 1}}, 0.5), -1);
  EXPECT_EQ(sign_at(BezierFunction{{-3}}, 7), -1);
  EXPECT_EQ(sign_at(BezierFunction{{-1, 2}}, Ratio{1, 3}), 0);
  EXPECT_EQ(sign_at(BezierFunction{{-1, 2}}, Ratio{-1, -3}), 0);
  EXPECT_EQ(sign_at(BezierFunction{{-1, 2}}, 1.0 / 3), -1);  // the double is below a third
}

TEST(Sign, SeesAChangeInTheLastPlace) {
  const double next = std::nextafter(2.0, 3);
  EXPECT_EQ(sign_at(BezierFunction{{-1, next}}, Ratio{1, 3}), 1);
  EXPECT_EQ(sign_at(BezierFunction{{-next, 4}}, Ratio{1, 3}), -1);
}

TEST(Sign, IsRightWhereNumbersUnderflowOrOverflow) {
  EXPECT_EQ(sign_at(BezierFunction{{-kMin, kMin}}, 0.5), 0);
  EXPECT_EQ(sign_at(BezierFunction{{kMin, 0, 0, 0}}, 0.75), 1);
  EXPECT_EQ(sign_at(BezierFunction{{kLargest, -kLargest, kLargest}}, 1e300), 1);
  EXPECT_EQ(sign_at(BezierFunction{{0, 0, kMin}}, Ratio{kMin, kLargest}), 1);
  EXPECT_EQ(sign_at(BezierFunction{{0, kMin}}, Ratio{-kMin, kLargest}), -1);
}

class SignProperty : public ::testing::TestWithParam<int> {};

TEST_P(SignProperty, IsThatOfTheExactValueCloseToARoot) {
  auto random = seeded(GetParam());
  const int n = pick(random, 1, 12);
  BezierFunction f;
  for (int k = 0; k <= n; ++k) f.points.push_back(uniform(random, -1, 1));
  // A bisection in double ends where doubles cannot tell.
  f.points.front() = -1;
  f.points.back() = 1;
  double low = 0, high = 1;
  while (std::nextafter(low, 1) < high) {
    const double middle = 0.5 * (low + high);
    (sign_at(f, middle) < 0 ? low : high) = middle;
  }

  const auto exact_f = exact(f.points);
  for (const double t : {low, high, uniform(random, -2, 3)})
    EXPECT_EQ(sign_at(f, t), sign_of(exact_point(exact_f, Rational(t)))) << t;
  EXPECT_LT(sign_at(f, low), 0);
  EXPECT_GE(sign_at(f, high), 0);
}

TEST_P(SignProperty, IsThatOfTheExactValueWhereProductsUnderflow) {
  auto random = seeded(GetParam());
  for (int k = 0; k < 20; ++k) {
    BezierFunction f;
    for (int i = 0; i <= 3; ++i) f.points.push_back(pick(random, -9, 9) * kMin);
    const double t = uniform(random, 0, 1);
    EXPECT_EQ(sign_at(f, t), sign_of(exact_point(exact(f.points), Rational(t))));
  }
}

TEST_P(SignProperty, OfATensorProductIsThatOfTheExactValue) {
  auto random = seeded(GetParam());
  const int n = pick(random, 0, 4), m = pick(random, 0, 4);
  BezierFunction2 f{Grid<double>(n + 1, m + 1)};
  for (double& c : f.points.values()) c = pick(random, -2, 2);
  const Ratio u{static_cast<double>(pick(random, -3, 3)), static_cast<double>(pick(random, 1, 3))};
  const Ratio v{static_cast<double>(pick(random, -3, 3)), -2};

  const Rational value = exact_point(exact(f.points), Rational(u.numerator) / u.denominator,
                                     Rational(v.numerator) / v.denominator);

  EXPECT_EQ(sign_at(f, u, v), sign_of(value));
}

INSTANTIATE_TEST_SUITE_P(Seeds, SignProperty, ::testing::Range(0, 60));

TEST(Sign, OnTheDomainNeedsCoefficientsThatAgree) {
  EXPECT_EQ(sign_on_domain(BezierFunction{{1, 0, 2}}), 1);
  EXPECT_EQ(sign_on_domain(BezierFunction{{-1, 0, -2}}), -1);
  EXPECT_EQ(sign_on_domain(BezierFunction{{0, 1, 2}}), std::nullopt);  // 0 at the end
  EXPECT_EQ(sign_on_domain(BezierFunction{{1, -1, 1}}), std::nullopt);
  EXPECT_EQ(sign_on_domain(BezierFunction{{0, 0}}), 0);
  EXPECT_EQ(sign_on_domain(BezierFunction{{1, 0, 2}}, 0.5), std::nullopt);
  EXPECT_EQ(sign_on_domain(BezierFunction{{1, 0.5, 2}}, 0.5), 1);
  EXPECT_EQ(sign_on_domain(BezierFunction{{0, 0}}, 0.5), std::nullopt);

  BezierFunction2 f{Grid<double>(2, 3, 1.0)};
  EXPECT_EQ(sign_on_domain(f), 1);
  f.points(0, 1) = 0;
  EXPECT_EQ(sign_on_domain(f), 1);
  f.points(1, 2) = 0;
  EXPECT_EQ(sign_on_domain(f), std::nullopt);
}

TEST(Sign, RefusesWhatIsNoFormOrNoParameter) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(sign_at(BezierFunction{}, 0.5), InvalidInput);
  EXPECT_THROW(sign_at(BezierFunction{{1, nan}}, 0.5), InvalidInput);
  EXPECT_THROW(sign_at(BezierFunction{{1, 2}}, nan), InvalidInput);
  EXPECT_THROW(sign_at(BezierFunction{{1, 2}}, Ratio{1, 0}), InvalidInput);
  EXPECT_THROW(sign_on_domain(BezierFunction{{1, 2}}, -1), InvalidInput);
  EXPECT_THROW(sign_on_domain(BezierFunction{{1, 2}}, nan), InvalidInput);
}

}  // namespace
}  // namespace blossom
