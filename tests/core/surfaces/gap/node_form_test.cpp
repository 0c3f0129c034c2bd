// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/node_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace blossom {
namespace {

constexpr double kNodeTolerance = 1e-7;
constexpr double kKnownReach = 0.5;
constexpr double kWidestDisc = 0.3;

// The product of lines through `at`, by their angles.
TaylorPolynomial lines_through(const Vec2& at, std::initializer_list<double> angles) {
  TaylorPolynomial form{1};
  for (const double angle : angles) {
    TaylorPolynomial next{};
    for (int i = 0; i < kTaylorDegree; ++i)
      for (int j = 0; i + j < kTaylorDegree; ++j) {
        next[taylor_index(i + 1, j)] += std::sin(angle) * form[taylor_index(i, j)];
        next[taylor_index(i, j + 1)] -= std::cos(angle) * form[taylor_index(i, j)];
      }
    form = next;
  }
  return moved(form, -at);
}

TaylorPolynomial tilted(TaylorPolynomial p, double slope) {
  p[taylor_index(1, 0)] += slope;
  return p;
}

TEST(NodeForm, HasTheOrderAndThePlaceOfItsLines) {
  const Vec2 at{0.11, -0.07};
  const std::initializer_list<double> angles[]{{0, 1, 2},
                                               {0, 0, 1},
                                               {0.1, 0.9, 1.7, 2.5},
                                               {0, 0, 1, 1},
                                               {0, 0.6, 1.2, 1.8, 2.4},
                                               {0, 0.5, 1, 1.5, 2, 2.5}};
  for (const auto& each : angles) {
    const auto node =
        node_form(lines_through(at, each), 0, kKnownReach, kNodeTolerance, kWidestDisc);
    ASSERT_TRUE(node);
    EXPECT_EQ(node->order, static_cast<int>(each.size()));
    EXPECT_LE(norm(node->at - at), 1e-9);
  }
}

// z = (x + iy)^3: between the lines it is r^3, which is kDiscGap tolerances at the border.
TEST(NodeForm, EndsWhereTheValleysLeaveTheTolerance) {
  constexpr double third = std::numbers::pi / 3;
  const auto node =
      node_form(lines_through({}, {0, third, 2 * third}), 0, kKnownReach, kNodeTolerance, 1);
  ASSERT_TRUE(node);
  EXPECT_NEAR(node->radius, std::cbrt(4 * kDiscGap * kNodeTolerance), 1e-9);  // sin 3t / 4
}

TEST(NodeForm, IsNoneWhereLowerTermsMatter) {
  const TaylorPolynomial saddle = lines_through({}, {0, 1, 2});
  EXPECT_TRUE(node_form(tilted(saddle, 1e-6), 0, kKnownReach, kNodeTolerance, kWidestDisc));
  EXPECT_FALSE(node_form(tilted(saddle, 1e-4), 0, kKnownReach, kNodeTolerance, kWidestDisc));
}

TEST(NodeForm, IsNoneAlongOneLineOrWithoutAForm) {
  EXPECT_FALSE(
      node_form(lines_through({}, {1, 1, 1}), 0, kKnownReach, kNodeTolerance, kWidestDisc));
  EXPECT_FALSE(node_form({}, 0, kKnownReach, kNodeTolerance, kWidestDisc));
}

TEST(NodeForm, IsNoWiderThanTheGapIsKnown) {
  const auto node = node_form(lines_through({}, {0, 1, 2}), 0, 1e-3, kNodeTolerance, kWidestDisc);
  ASSERT_TRUE(node);
  EXPECT_LE(node->radius, 1e-3);
}

}  // namespace
}  // namespace blossom
