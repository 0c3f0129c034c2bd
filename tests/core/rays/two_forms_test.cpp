// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/rays/two_forms.h"

#include <gtest/gtest.h>

#include <array>

#include "core/distance/nearest_pair.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

// f = 2 u + u v - 1, g = 4 v - 1: bilinear, the first plane then the second.
constexpr NetShape kBilinear{2, 2, 2};
constexpr std::array<double, 8> kNet{-1, -1, 1, 2, -1, 3, -1, 3};

TEST(TwoForms, HaveHandComputedBounds) {
  const TwoForms forms = two_forms(kBilinear, kNet.data(), 0);
  EXPECT_EQ(forms.f.low, -1);
  EXPECT_EQ(forms.f.high, 2);
  EXPECT_EQ(forms.slopes[0][0].low, 2);  // f_u = 2 + v
  EXPECT_EQ(forms.slopes[0][0].high, 3);
  EXPECT_EQ(forms.slopes[0][1].high, 1);  // f_v = u
  EXPECT_EQ(forms.slopes[1][1].low, 4);   // g_v
  ASSERT_TRUE(forms.regular);
  // The mean Jacobian is [[2.5, 0.5], [0, 4]].
  EXPECT_DOUBLE_EQ(forms.inverse[0][0], 0.4);
  EXPECT_DOUBLE_EQ(forms.inverse[0][1], -0.05);
  EXPECT_DOUBLE_EQ(forms.inverse[1][1], 0.25);
  EXPECT_NEAR(forms.spread[0][0], 0.4 * 0.5, 1e-14);
  EXPECT_NEAR(forms.spread[0][1], 0.4 * 0.5, 1e-14);
  EXPECT_NEAR(forms.spread[1][1], 0, 1e-14);
  EXPECT_GE(two_forms(kBilinear, kNet.data(), 0.01).spread[0][0], 0.4 * 0.52);
}

TEST(TwoForms, HaveValuesInsideAndBeyondTheSquare) {
  EXPECT_EQ(values_at(kBilinear, kNet.data(), 0.5, 0.5), (Vec2{0.25, 1}));
  EXPECT_EQ(values_at(kBilinear, kNet.data(), 2, -1), (Vec2{1, -5}));
}

TEST(TwoForms, ContractBelowSpectralRadiusOne) {
  EXPECT_TRUE(is_contraction({{{0.5, 0.4}, {0.4, 0.5}}}));
  EXPECT_FALSE(is_contraction({{{0.5, 0.5}, {0.5, 0.5}}}));
  EXPECT_FALSE(is_contraction({{{1, 0}, {0, 0.5}}}));
  EXPECT_FALSE(is_contraction({{{0, 2}, {2, 0}}}));
}

TEST(TwoForms, LeadOutsideOnlyAcrossTheBorderAndBeyondTheDrift) {
  const Matrix2 none{}, some{{{0.2, 0.2}, {0.2, 0.2}}};
  // The root is at p - offset: above the upper border.
  EXPECT_TRUE(leads_outside(none, {-0.1, 0}, {}, {1, 0}));
  EXPECT_FALSE(leads_outside(none, {0.1, 0}, {}, {1, 0}));
  EXPECT_TRUE(leads_outside(none, {0.1, 0}, {}, {-1, 0}));
  EXPECT_FALSE(leads_outside(none, {-0.1, 0}, {}, {0, 0}));
  EXPECT_FALSE(leads_outside(none, {-0.1, 0}, {0.1, 0}, {1, 0}));
  // (I - E)^-1 (0.1, 0) = (0.4, 0.1) / 3, which drifts by 0.1 / 3.
  EXPECT_TRUE(leads_outside(some, {-0.1, 0}, {}, {1, 0}));
  // With (0.1, 0.3): (0.14, 0.26) / 0.6, which drifts by 0.4 / 3 > 0.1.
  EXPECT_FALSE(leads_outside(some, {-0.1, -0.3}, {}, {1, 0}));
}

CellTree tree_of(const BezierSurface& surface) {
  return CellTree(surface.patches(0, 0), false, {}, CellForm::Bezier, 0.5);
}

TEST(NearestPair, MayBeNormalExactlyAboveTheSquare) {
  const CellTree square =
      tree_of(testing::quadrilateral({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}));
  const auto may_be = [&](const Vec3& p, bool in_u) {
    const CellTree point = tree_of(testing::quadrilateral(p, p, p, p));
    return may_be_normal(square[0], {in_u, true}, point[0], {false, false});
  };
  EXPECT_TRUE(may_be({0.999, 0.5, 1}, true));
  EXPECT_FALSE(may_be({1.001, 0.5, 1}, true));
  EXPECT_TRUE(may_be({1.001, 0.5, 1}, false));
  EXPECT_TRUE(may_be({0.001, 0.001, 1}, true));
  EXPECT_FALSE(may_be({0.5, -0.001, 1}, true));
}

TEST(NearestPair, BoundsDistancesBySlabs) {
  const CellTree square =
      tree_of(testing::quadrilateral({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}));
  const CellTree roof = tree_of(testing::quadrilateral({0, 0, 2}, {0, 1, 1}, {1, 0, 3}, {1, 1, 2}));
  const double bound = distance_bound({&square[0], 4}, {&roof[0], 4}, {0, 0, 1});
  EXPECT_LE(bound, 1);
  EXPECT_NEAR(bound, 1, 1e-12);
}

}  // namespace
}  // namespace blossom
