// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/radius_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"

namespace blossom {
namespace {

// Derivatives agree with differences of the values.
void expect_derivatives(const RadiusLaw& law, double x) {
  const double h = 1e-5;
  const RadiusJet here = law.at(x), after = law.at(x + h), before = law.at(x - h);
  EXPECT_NEAR(here.first, (after.value - before.value) / (2 * h), 1e-9);
  EXPECT_NEAR(here.second, (after.first - before.first) / (2 * h), 1e-8);
}

TEST(RadiusLaw, OfEachKindGoesFromTheFirstToTheLast) {
  const Interval range{1, 3};
  for (const RadiusLaw& law :
       {RadiusLaw::linear(range, 0.2, 0.5), RadiusLaw::smooth(range, 0.2, 0.5),
        RadiusLaw::table({1, 1.5, 3}, {0.2, 0.7, 0.5})}) {
    EXPECT_DOUBLE_EQ(law.at(1).value, 0.2);
    EXPECT_DOUBLE_EQ(law.at(3).value, 0.5);
    EXPECT_FALSE(law.is_constant());
    for (const double x : {1.2, 1.9, 2.7}) expect_derivatives(law, x);
  }
  EXPECT_EQ(RadiusLaw::constant(0.3).at(17).value, 0.3);
  EXPECT_EQ(RadiusLaw::constant(0.3).at(17).first, 0);
}

TEST(RadiusLaw, SmoothHasNoSlopeAtItsEnds) {
  const RadiusLaw law = RadiusLaw::smooth({1, 3}, 0.2, 0.5);
  EXPECT_EQ(law.at(1).first, 0);
  EXPECT_NEAR(law.at(3).first, 0, 1e-15);
  EXPECT_DOUBLE_EQ(law.at(2).value, 0.35);
}

TEST(RadiusLaw, OfATableIsSmoothAtItsKnotsAndStraightAtItsEnds) {
  const std::vector<double> x{0, 1, 2.5, 3, 5}, r{1, 2, 1.5, 3, 2};
  const RadiusLaw law = RadiusLaw::table(x, r);
  EXPECT_EQ(law.knots(), (std::vector<double>{1, 2.5, 3}));
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(law.at(x[i]).value, r[i], 1e-14);
  for (const double knot : law.knots()) {
    const RadiusJet before = law.at(knot - 1e-9), after = law.at(knot + 1e-9);
    EXPECT_NEAR(before.first, after.first, 1e-7);
    EXPECT_NEAR(before.second, after.second, 1e-7);
  }
  EXPECT_NEAR(law.at(0).second, 0, 1e-14);
  EXPECT_NEAR(law.at(5).second, 0, 1e-12);
}

TEST(RadiusLaw, RefusesWhatIsNoLaw) {
  EXPECT_THROW(RadiusLaw::constant(0), InvalidInput);
  EXPECT_THROW(RadiusLaw::linear({0, 1}, 1, -1), InvalidInput);
  EXPECT_THROW(RadiusLaw::linear({1, 1}, 1, 2), InvalidInput);
  EXPECT_THROW(RadiusLaw::smooth({0, 1}, 0.0 / 0.0, 2), InvalidInput);
  EXPECT_THROW(RadiusLaw::table({0}, {1}), InvalidInput);
  EXPECT_THROW(RadiusLaw::table({0, 1}, {1}), InvalidInput);
  EXPECT_THROW(RadiusLaw::table({1, 0}, {1, 1}), InvalidInput);
}

TEST(RadiusLaw, GoesOverAPartOfItself) {
  const Interval range{1, 3};
  for (const RadiusLaw& law : {RadiusLaw::constant(0.3), RadiusLaw::linear(range, 0.2, 0.5),
                               RadiusLaw::smooth(range, 0.2, 0.5),
                               RadiusLaw::table({1, 1.5, 2.5, 3}, {0.2, 0.7, 0.5, 0.6})})
    for (const Interval& part : {Interval{1.2, 2.8}, Interval{2.6, 1.1}, Interval{2, 2}}) {
      const RadiusLaw own = law.over(part, {10, 14});
      for (int i = 0; i <= 20; ++i) {
        const double x = i / 20.0, scale = (part.to - part.from) / 4;
        const RadiusJet here = own.at(10 + 4 * x),
                        there = law.at(part.from + x * (part.to - part.from));
        EXPECT_NEAR(here.value, there.value, 1e-14);
        EXPECT_NEAR(here.first, scale * there.first, 1e-13);
      }
    }
}

TEST(RadiusLaw, KnowsItsExtremes) {
  const RadiusLaw law = RadiusLaw::table({0, 0.2, 0.5, 0.9, 1}, {1, 3, 0.4, 2, 1});
  for (const Interval& range : {Interval{0, 1}, Interval{0.3, 0.95}, Interval{-0.1, 0.1}}) {
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (int i = 0; i <= 100000; ++i) {
      const double value = law.at(range.from + i / 100000.0 * (range.to - range.from)).value;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    EXPECT_NEAR(law.extremes(range).from, least, 1e-8);
    EXPECT_NEAR(law.extremes(range).to, most, 1e-8);
    EXPECT_LE(law.extremes(range).from, least);
    EXPECT_GE(law.extremes(range).to, most);
  }
}

TEST(RadiusLaw, WithRatesKeepsItsEndsAndHasTheRates) {
  const Interval range{0.5, 2};
  for (const RadiusLaw& law : {RadiusLaw::linear(range, 1, 3), RadiusLaw::constant(2),
                               RadiusLaw::table({0.5, 1, 1.2, 2}, {1, 1.5, 1.4, 2})}) {
    const RadiusLaw made = law.with_rates(range, 0.25, -0.5);
    for (const double end : {range.from, range.to})
      EXPECT_NEAR(made.at(end).value, law.at(end).value, 1e-14);
    EXPECT_NEAR(made.at(range.from).first, 0.25, 1e-14);
    EXPECT_NEAR(made.at(range.to).first, -0.5, 1e-13);
    EXPECT_FALSE(made.is_constant());
    for (const double knot : law.knots())  // what is added is one cubic
      EXPECT_NEAR(made.at(knot - 1e-7).second, made.at(knot + 1e-7).second, 1e-4);
  }
  const RadiusLaw same = RadiusLaw::linear(range, 1, 4).with_rates(range, 2, 2);
  EXPECT_NEAR(same.at(1.1).value, 2.2, 1e-14);
  EXPECT_THROW(same.with_rates({2, 2}, 0, 0), InvalidInput);
}

}  // namespace
}  // namespace blossom
