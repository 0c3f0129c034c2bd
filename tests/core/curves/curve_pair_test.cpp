// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/curve_pair.h"

#include <gtest/gtest.h>

#include "core/curves/curve_clipping.h"
#include "tests/support/curves.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::bezier;
using testing::seeded;
using testing::uniform;

// Whole curves as cells, with their cones.
struct PlaneTrees {
  CurveSpans a, b;
  CurveTree tree_a{a, Vec3{}, 2}, tree_b{b, Vec3{}, 2};

  PlaneTrees(CurveSpans first, CurveSpans second) : a(std::move(first)), b(std::move(second)) {
    tree_a.direct(0);
    tree_b.direct(0);
  }
  CurvePair pair() const { return {tree_a, tree_a[0], tree_b, tree_b[0]}; }
  CurveFoot foot(double s, double t) const { return foot_at(pair(), {0, s}, {0, t}); }
};

TEST(CurvePair, ConesNeverExcludeACommonPoint) {
  auto random = seeded(1);
  for (int trial = 0; trial < 2000; ++trial) {
    // A flat arc to the right and one upwards, through a common point at s, t.
    const double s = uniform(random, 0, 1), t = uniform(random, 0, 1);
    const double bow_a = uniform(random, -0.3, 0.3), bow_b = uniform(random, -0.3, 0.3);
    CurveSpans a = bezier({{0, 0, 0}, {0.5, bow_a, 0}, {1, 0, 0}});
    CurveSpans b = bezier({{0, 0, 0}, {bow_b, 0.5, 0}, {0, 1, 0}});
    const Vec3 shift = point_at(a, s) - point_at(b, t);
    for (Vec4& p : b.spans[0].curve.points) p += Vec4{shift[0], shift[1], 0, 0};
    const PlaneTrees trees(a, b);
    ASSERT_TRUE(least_sine(trees.pair()));
    EXPECT_FALSE(FatLines(trees.pair(), 1e-12).separated());
    for (const double at_a : {0.0, uniform(random, 0, 1), 1.0})
      for (const double at_b : {0.0, uniform(random, 0, 1), 1.0})
        EXPECT_FALSE(cones_exclude(trees.pair(), trees.foot(at_a, at_b)));
  }
}

TEST(CurvePair, ConesExcludeWhatLiesBeyondTheEnd) {
  const PlaneTrees trees(bezier({{0, 0, 0}, {0.5, 0.05, 0}, {1, 0, 0}}),
                         bezier({{1.001, -0.5, 0}, {1.02, 0, 0}, {1.001, 0.5, 0}}));
  EXPECT_TRUE(cones_exclude(trees.pair(), trees.foot(1, 0.5)));
  EXPECT_FALSE(cones_exclude(trees.pair(), trees.foot(0, 0)));
}

TEST(CurvePair, SineIsBelowAllAnglesBetweenTheCurves) {
  auto random = seeded(2);
  for (int trial = 0; trial < 500; ++trial) {
    const PlaneTrees trees(bezier({{0, 0, 0}, {0.5, uniform(random, -0.4, 0.4), 0}, {1, 0, 0}}),
                           bezier({{0, 0, 0}, {0.3, uniform(random, 0, 1), 0}, {0.5, 1, 0}}));
    const auto sine = least_sine(trees.pair());
    if (!sine) continue;
    for (int i = 0; i <= 10; ++i)
      for (int k = 0; k <= 10; ++k) {
        const CurveFoot foot = trees.foot(0.1 * i, 0.1 * k);
        EXPECT_LE(*sine, norm(cross(unit(foot.jet_a.first), unit(foot.jet_b.first))) + 1e-12);
      }
  }
}

TEST(CurvePair, NewtonSettlesOnTheCrossing) {
  const PlaneTrees trees(bezier({{0, 0, 0}, {0.5, 0.3, 0}, {1, 0, 0}}),
                         bezier({{0.4, -0.5, 0}, {0.6, 0, 0}, {0.4, 0.7, 0}}));
  const auto foot = nearest_feet(trees.pair(), chord_feet(trees.pair()));
  ASSERT_TRUE(foot);
  EXPECT_LE(norm(foot->gap()), 1e-15);
}

}  // namespace
}  // namespace blossom
