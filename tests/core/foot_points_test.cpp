// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/foot_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/errors.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/evaluation.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"

namespace blossom {
namespace {

using testing::one_patch;
using testing::random_point;
using testing::seeded;
using testing::uniform;

constexpr double kTolerance = 1e-7;

DistanceOperand only(const BezierSurface& surface) { return {{}, {}, {surface}}; }

TEST(FootPoints, ThatThereWasNoTimeForMayBeAnywhereOnTheirSurface) {
  const std::function<bool()> always = [] { return true; };
  const WorkLimit limit(0, always);
  const std::vector<FootPoint> feet =
      foot_points(only(testing::unit_sphere()), {0.1, 0.2, 3}, kTolerance, &limit);
  ASSERT_EQ(feet.size(), 1u);
  EXPECT_EQ(feet[0].status, Status::Stopped);
  EXPECT_GE(feet[0].size, 2);
}

TEST(FootPoints, OnASphereAreTheNearestAndTheFarthest) {
  auto random = seeded(1);
  for (int i = 0; i < 30; ++i) {
    const Vec3 point = 2 * random_point(random);
    const std::vector<FootPoint> feet =
        foot_points(only(testing::unit_sphere()), point, kTolerance);
    ASSERT_EQ(feet.size(), 2u) << i;
    EXPECT_NEAR(feet[0].distance, std::abs(norm(point) - 1), 1e-12);
    EXPECT_NEAR(feet[1].distance, norm(point) + 1, 1e-12);
    EXPECT_EQ(feet[0].extremum, Extremum::Minimum);
    EXPECT_EQ(feet[1].extremum, Extremum::Maximum);
    for (const FootPoint& foot : feet) {
      EXPECT_EQ(foot.status, Status::Complete);
      EXPECT_LE(norm(cross(foot.at.point, unit(point))), 1e-9);
    }
  }
}

TEST(FootPoints, OnATorusAreFour) {
  const std::vector<FootPoint> feet =
      foot_points(only(testing::torus(2, 0.5)), {3, 1, 0.7}, kTolerance);
  ASSERT_EQ(feet.size(), 4u);
  const double ring = std::hypot(3, 1), near = std::hypot(ring - 2, 0.7),
               far = std::hypot(ring + 2, 0.7);
  EXPECT_NEAR(feet[0].distance, near - 0.5, 1e-12);
  EXPECT_NEAR(feet[1].distance, near + 0.5, 1e-12);
  EXPECT_NEAR(feet[2].distance, far - 0.5, 1e-12);
  EXPECT_NEAR(feet[3].distance, far + 0.5, 1e-12);
  EXPECT_EQ(feet[0].extremum, Extremum::Minimum);
  EXPECT_EQ(feet[3].extremum, Extremum::Maximum);
}

TEST(FootPoints, OnACurveAreWhereTheLineIsAcrossIt) {
  // y = x^2 for x in [-1, 1]; from (0, 2) the feet have x = 0 and x = +-sqrt(3/2), outside.
  DistanceOperand parabola;
  parabola.curves = {{{{-1, 1, 0, 1}, {0, -1, 0, 1}, {1, 1, 0, 1}}}};
  ASSERT_EQ(foot_points(parabola, {0, 2, 0}, kTolerance).size(), 1u);
  const std::vector<FootPoint> feet = foot_points(parabola, {0, 1, 0}, kTolerance);
  ASSERT_EQ(feet.size(), 3u);
  EXPECT_NEAR(feet[0].distance, std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(feet[1].distance, std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(feet[2].distance, 1, 1e-12);
  EXPECT_EQ(feet[0].extremum, Extremum::Minimum);
  EXPECT_EQ(feet[2].extremum, Extremum::Maximum);
  EXPECT_NEAR(feet[2].at.uv[0], 0.5, 1e-12);
}

TEST(FootPoints, FromTheCentreOfASphereAreNotDecided) {
  const std::vector<FootPoint> feet =
      foot_points(only(testing::unit_sphere()), {0, 0, 0}, kTolerance);
  ASSERT_FALSE(feet.empty());
  for (const FootPoint& foot : feet) {
    EXPECT_EQ(foot.status, Status::Tolerance);
    EXPECT_GT(foot.size, 0);
  }
}

// Their forms have degrees of up to three times the patch's.
TEST(FootPoints, OnElevatedPatchesAreThoseOfThePatches) {
  auto random = seeded(3);
  for (const int degree : {9, 14, 20}) {
    RationalBezierPatch patch = testing::random_patch<Vec4>(random, 2, 2);
    for (Vec4& p : patch.points.values()) p[3] = uniform(random, 1, 2);
    const Vec3 point = random_point(random);
    const std::vector<FootPoint> wanted = foot_points(only(one_patch(patch)), point, kTolerance);
    const std::vector<FootPoint> found =
        foot_points(only(one_patch(elevated(patch, degree, degree))), point, kTolerance);
    ASSERT_EQ(found.size(), wanted.size()) << degree;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].status, wanted[i].status) << degree;
      EXPECT_NEAR(found[i].distance, wanted[i].distance, 1e-9) << degree;
    }
  }
}

TEST(FootPoints, OutsideOfTrimsAreLeftOut) {
  DistanceOperand half = only(testing::unit_sphere());
  half.trims = [](int, const Vec2& low, const Vec2& high) {
    return high[1] < 0 ? TrimSide::Outside : low[1] > 0 ? TrimSide::Inside : TrimSide::Mixed;
  };
  ASSERT_EQ(foot_points(half, {1, 1, 1}, kTolerance).size(), 1u);
}

TEST(FootPoints, RefusesWhatMakesNoSense) {
  const DistanceOperand sphere = only(testing::unit_sphere());
  EXPECT_THROW(foot_points(sphere, {0, std::nan(""), 0}, kTolerance), InvalidInput);
  EXPECT_THROW(foot_points(sphere, {0, 0, 0}, 0), InvalidInput);
}

// Random patches: feet are stationary, and every foot that many Newton starts find is there.
class FootPointsProperty : public ::testing::TestWithParam<int> {};

TEST_P(FootPointsProperty, AreAllThatASlowSearchFinds) {
  auto random = seeded(GetParam());
  RationalBezierPatch patch{Grid<Vec4>(2 + GetParam() % 3, 2 + GetParam() / 3 % 3)};
  for (Vec4& p : patch.points.values())
    p = testing::weighted(random_point(random), uniform(random, 1, 1 + GetParam() % 2));
  const Vec3 point = 2 * random_point(random);
  const std::vector<FootPoint> feet = foot_points(only(one_patch(patch)), point, kTolerance);
  for (const FootPoint& foot : feet) {
    EXPECT_EQ(foot.status, Status::Complete);
    const PatchJet jet = jet_at(patch, foot.at.uv[0], foot.at.uv[1], 1);
    EXPECT_LE(std::abs(dot(jet.point - point, jet.u)), 1e-9);
    EXPECT_LE(std::abs(dot(jet.point - point, jet.v)), 1e-9);
  }
  constexpr int kStarts = 12;
  for (int i = 0; i <= kStarts * kStarts; ++i) {
    Vec2 x{i % kStarts / (kStarts - 1.0), i / kStarts / double(kStarts)};
    double step = 1;
    for (int k = 0; k < 40 && step > 1e-14 && max_norm(x) < 3; ++k) {
      const PatchJet jet = jet_at(patch, x[0], x[1], 2);
      const Vec3 r = jet.point - point;
      const double a = dot(jet.u, jet.u) + dot(r, jet.uu), d = dot(jet.v, jet.v) + dot(r, jet.vv);
      const double b = dot(jet.u, jet.v) + dot(r, jet.uv);
      const Vec2 g{dot(r, jet.u), dot(r, jet.v)};
      const Vec2 move{(d * g[0] - b * g[1]) / (a * d - b * b),
                      (a * g[1] - b * g[0]) / (a * d - b * b)};
      x -= move;
      step = max_norm(move);
    }
    if (!(step <= 1e-12) || std::min(x[0], x[1]) < 0 || std::max(x[0], x[1]) > 1) continue;
    EXPECT_TRUE(std::any_of(feet.begin(), feet.end(),
                            [&](const FootPoint& foot) { return max_norm(foot.at.uv - x) < 1e-7; }))
        << x[0] << " " << x[1];
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, FootPointsProperty, ::testing::Range(0, 36));
// Feet where two have nearly met: the iteration in a piece converges slowly.
INSTANTIATE_TEST_SUITE_P(SlowSeeds, FootPointsProperty, ::testing::Values(310, 1207, 1331));

}  // namespace
}  // namespace blossom
