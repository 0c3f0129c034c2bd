// SPDX-License-Identifier: LGPL-2.1-or-later
// Taylor models: what they promise holds at every x, and roots of nothing are not invented.

#include "core/math/series/taylor_model.h"
#include "core/base/unbounded.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace blossom {
namespace {

long double model_value(const TaylorModel& f, long double x) {
  long double sum = 0;
  for (std::size_t k = f.terms.size(); k-- > 0;) sum = sum * x + f.terms[k];
  return sum;
}

TaylorModel model(std::initializer_list<double> terms) {
  TaylorModel f;
  std::copy(terms.begin(), terms.end(), f.terms.begin());
  return f;
}

void expect_holds(const TaylorModel& f, const std::function<long double(long double)>& exact) {
  for (int i = -50; i <= 50; ++i) {
    const long double x = i / 50.0L;
    EXPECT_LE(std::abs(model_value(f, x) - exact(x)), f.rest) << "at " << static_cast<double>(x);
  }
}

TEST(TaylorModel, ProductOfShortPolynomialsIsTheirProduct) {
  const TaylorModel f = model({1, 2}) * model({3, -1, 4});
  EXPECT_EQ(f.terms[0], 3);
  EXPECT_EQ(f.terms[1], 5);
  EXPECT_EQ(f.terms[2], 2);
  EXPECT_EQ(f.terms[3], 8);
  EXPECT_LT(f.rest, 1e-13);
}

TEST(TaylorModel, ProductBoundsWhatItCuts) {
  TaylorModel f;
  f.terms[15] = 1;
  const TaylorModel square = f * f;
  EXPECT_EQ(square.terms, TaylorModel().terms);
  EXPECT_GE(square.rest, 1);
  EXPECT_LT(square.rest, 1.001);
}

TEST(TaylorModel, SizeOfAQuadraticIsItsLargestValue) {
  EXPECT_NEAR(size_bound(model({1, 2})), 3, 1e-12);
  EXPECT_NEAR(size_bound(model({-1, 0, 1})), 1, 1e-12);
  EXPECT_NEAR(size_bound(model({0, 1, -1})), 2, 1e-12);
  EXPECT_NEAR(size_bound(model({0.5, 1, -1})), 1.5, 1e-12);
  EXPECT_NEAR(size_bound(model({2, 1, -1})), 2.25, 1e-12);
  EXPECT_NEAR(size_bound(model({2, 1, -1, 0.5})), 2.75, 1e-12);
  EXPECT_NEAR(change_bound(model({2, 1, -1})), 2, 1e-12);
}

TEST(TaylorModel, RestsGoOnThroughSumsAndProducts) {
  TaylorModel f = model({2}), g = model({3});
  f.rest = 0.5;
  g.rest = 0.25;
  EXPECT_GE((f + g).rest, 0.75);
  EXPECT_GE((f - g).rest, 0.75);
  EXPECT_GE((f * g).rest, 2 * 0.25 + 3 * 0.5 + 0.5 * 0.25);
  EXPECT_LT((f * g).rest, 2.13);
}

TEST(TaylorModel, InverseOfALineIsTheGeometricSeries) {
  const TaylorModel r = reciprocal(model({2, 1}));
  EXPECT_EQ(r.terms[0], 0.5);
  EXPECT_EQ(r.terms[1], -0.25);
  EXPECT_EQ(r.terms[2], 0.125);
  expect_holds(r, [](long double x) { return 1 / (2 + x); });
  EXPECT_LT(r.rest, 1e-4);
}

TEST(TaylorModel, KnowsNothingOfTheInverseOfARoot) {
  EXPECT_EQ(size_bound(reciprocal(model({1, 2}))), kInfinity);
  EXPECT_EQ(size_bound(reciprocal(model({0, 1}))), kInfinity);
  EXPECT_EQ(size_bound(reciprocal(TaylorModel(0))), kInfinity);
}

TEST(TaylorModel, KnowsNothingOfTheRootOfWhatMayBeNegative) {
  EXPECT_EQ(size_bound(sqrt(model({1, 2}))), kInfinity);
  EXPECT_EQ(size_bound(sqrt(model({-1}))), kInfinity);
  EXPECT_EQ(size_bound(sqrt(TaylorModel(0))), kInfinity);
  TaylorModel wide = model({1});
  wide.rest = 2;
  EXPECT_EQ(size_bound(sqrt(wide)), kInfinity);
}

TEST(TaylorModel, WhatIsUnknownStaysUnknown) {
  const TaylorModel unknown = reciprocal(TaylorModel(0));
  EXPECT_EQ(size_bound(unknown * TaylorModel(0)), kInfinity);
  EXPECT_EQ(size_bound(unknown - unknown), kInfinity);
  EXPECT_EQ(change_bound(unknown), kInfinity);
}

class TaylorModelProperty : public ::testing::TestWithParam<int> {};

TEST_P(TaylorModelProperty, OperationsHoldWithTheirRoundings) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  std::uniform_real_distribution<double> noise(-1, 1);
  TaylorModel f, g;
  double scale = 1;
  for (std::size_t k = 0; k < f.terms.size(); ++k, scale *= 0.4) {
    f.terms[k] = scale * noise(random);
    g.terms[k] = scale * noise(random);
  }
  f.terms[0] = 3;
  g.terms[0] = -4;
  const auto at_f = [&](long double x) { return model_value(f, x); };
  const auto at_g = [&](long double x) { return model_value(g, x); };
  expect_holds(f + g, [&](long double x) { return at_f(x) + at_g(x); });
  expect_holds(f - g, [&](long double x) { return at_f(x) - at_g(x); });
  expect_holds(f * g, [&](long double x) { return at_f(x) * at_g(x); });
  expect_holds(reciprocal(g), [&](long double x) { return 1 / at_g(x); });
  expect_holds(sqrt(f), [&](long double x) { return std::sqrt(at_f(x)); });
  const TaylorModel one = sqrt(f) * sqrt(f) * reciprocal(f) - TaylorModel(1);
  EXPECT_LT(size_bound(one), 1e-4);
  EXPECT_LE(std::abs(model_value(one, 0.7L)), one.rest);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TaylorModelProperty, ::testing::Range(0, 50));

}  // namespace
}  // namespace blossom
