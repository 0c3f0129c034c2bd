// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/shared_chart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/forms/algebra/degree.h"
#include "core/forms/evaluation.h"
#include "core/subdivision/patch_subdivision.h"
#include "tests/support/cubic_family.h"

namespace blossom {
namespace {

RationalBezierPatch base_patch(double lift = 0) {
  return testing::graph(testing::base_cubic() + testing::constant(lift), {0, 0}, {1, 0}, {0, 1})
      .patches(0, 0);
}

// u / (u + r (1 - u)) put for u, and u and v exchanged.
RationalBezierPatch disguised(const RationalBezierPatch& patch, double r) {
  const Grid<Vec4>& net = patch.points;
  Grid<Vec4> turned(net.columns(), net.rows());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j)
      turned(j, i) = net(i, j) * std::pow(r, net.rows() - 1 - i);
  return {turned};
}

TEST(LinearRational, InverseUndoesIt) {
  const LinearRational f{{0.2, 0.9}, {1.5, -0.25}, 3};
  EXPECT_DOUBLE_EQ(f(0.2), 1.5);
  EXPECT_DOUBLE_EQ(f(0.9), -0.25);
  EXPECT_NEAR(f.inverse()(f(0.37)), 0.37, 1e-14);
  EXPECT_GT(std::abs(f(0.55) - 0.625), 0.1);  // not linear
}

TEST(SharedChart, FindsTheMapOfADisguisedPiece) {
  const RationalBezierPatch a = sub_patch(base_patch(), {0, 0.6}, {0, 0.7});
  const RationalBezierPatch b =
      elevated(disguised(sub_patch(base_patch(), {1, 0.4}, {0.5, 1}), 2), 4, 5);

  const auto chart = shared_chart(a, b, {0.9, 0.9, 0.3, 0.8}, 1e-9);

  ASSERT_TRUE(chart);
  EXPECT_TRUE(chart->transposed);
  for (const double u : {0.7, 0.8, 1.0})
    for (const double v : {0.75, 1.0}) {
      const auto place = chart->image({u, u}, {v, v});
      const Vec3 p = jet_at(a, u, v, 1).point, q = jet_at(b, place[0].from, place[1].from, 1).point;
      EXPECT_LE(distance(p, q), 1e-12);
      const auto back = chart->inverse_image(place[0], place[1]);
      EXPECT_NEAR(back[0].from, u, 1e-12);
      EXPECT_NEAR(back[1].from, v, 1e-12);
    }
}

TEST(SharedChart, RefusesSurfacesThatOnlyTouch) {
  const RationalBezierPatch a = base_patch();
  EXPECT_FALSE(shared_chart(a, base_patch(1e-6), {0.5, 0.5, 0.5, 0.5}, 1e-7));
  RationalBezierPatch bent = a;
  bent.points(3, 3)[2] += 1e-5;  // agrees near the opposite corner only
  EXPECT_FALSE(shared_chart(a, bent, {0.05, 0.05, 0.05, 0.05}, 1e-7));
  EXPECT_TRUE(shared_chart(a, bent, {0.05, 0.05, 0.05, 0.05}, 1e-4));
}

// A small piece near the origin of a patch that reaches far has the digits of the far points.
TEST(SharedChart, GivesNoFinerProofThanThePatchIsRounded) {
  RationalBezierPatch whole = base_patch();
  for (Vec4& p : whole.points.values())
    for (int k = 0; k < 3; ++k) p[k] = 1e8 * (p[k] - (k < 2 ? 0.5 : 0.0));
  const Interval middle{0.5, 0.5 + 1e-8};
  const RationalBezierPatch piece = sub_patch(whole, middle, middle);
  const Point4 near{0.5, 0.5, middle.from, middle.from};
  EXPECT_FALSE(shared_chart(piece, whole, near, 2e-7));
  EXPECT_TRUE(shared_chart(piece, whole, near, 1e-5));
}

TEST(SharedChart, RefusesAPieceThatIsTurnedInTheChart) {
  const auto pair = testing::cubic_pair(testing::constant(0));
  EXPECT_FALSE(
      shared_chart(pair.a.patches(0, 0), pair.b.patches(0, 0), {0.5, 0.5, 0.5, 0.5}, 1e-7));
}

}  // namespace
}  // namespace blossom
