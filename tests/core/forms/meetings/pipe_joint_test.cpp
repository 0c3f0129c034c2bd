// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/forms/meetings/pipe_joint.h"

namespace blossom {
namespace {

using std::numbers::pi;
constexpr double kExact = 1e-10;

// Bent round a centre beside the origin, so that it runs along z there.
Elementary elbow(double bend, double turned, double tube = 1) {
  const Vec3 towards{std::cos(turned), std::sin(turned), 0};
  return {ElementaryKind::Torus, bend * towards, cross({0, 0, 1}, towards), bend, tube, 0};
}
Elementary pipe(double tube = 1) {
  return {ElementaryKind::Cylinder, {0, 0, -7}, {0, 0, 1}, tube, 0, 0};
}

struct Pair {
  Elementary a, b;
  std::size_t loops;
};
std::vector<Pair> pairs() {
  return {{pipe(), elbow(3, 0.3), 1},        {elbow(3, 0), elbow(3, 1), 1},
          {elbow(3, 0), elbow(3, pi), 1},    {elbow(3, 0.1), elbow(4.5, 0.1), 1},
          {elbow(3, 0.1), elbow(4, 0.7), 1}, {elbow(3, 0.1), elbow(4, 0.1 - pi), 1},
          {elbow(3, 0.1), elbow(3, 0.2), 2}, {elbow(3, 0), elbow(3.1, 0), 2},
          {elbow(1.5, 0.1), elbow(9, 2), 1}};
}

TEST(PipeJoint, CrossingsLieOnBothPipesAndPassTheJointInTheirNodes) {
  for (const auto& [x, y, loops] : pairs())
    for (const auto& [a, b] : {std::pair{x, y}, std::pair{y, x}}) {
      const auto joint = pipe_joint(a, b, kExact);
      ASSERT_TRUE(joint);
      EXPECT_LT(norm(joint->centre), 1e-14);
      EXPECT_NEAR(std::abs(joint->axis[2]), 1, 1e-15);
      const std::vector<PipeCrossing> found = crossings_beside(*joint);
      EXPECT_EQ(found.size(), loops);
      for (const PipeCrossing& crossing : found) {
        for (double t = 0.05; t < 2 * pi; t += 0.1) {
          const Vec3 point = jet_at(crossing, t)[0];
          EXPECT_LT(std::abs(height_over(a, point).value), 1e-13);
          EXPECT_LT(std::abs(height_over(b, point).value), 1e-13);
        }
        for (const double t : crossing.nodes) {
          const Vec3 node = jet_at(crossing, t)[0];
          EXPECT_NEAR(node[2], 0, 1e-14);
          EXPECT_NEAR(norm(node), 1, 1e-14);
        }
      }
    }
}

TEST(PipeJoint, CrossingsHaveTheDerivativesOfTheirPoints) {
  constexpr double kStep = 1e-4;
  for (const auto& [a, b, loops] : pairs())
    for (const PipeCrossing& crossing : crossings_beside(*pipe_joint(a, b, kExact)))
      for (const double t : {0.0, 0.7, 2.0, 3.5, 5.0}) {
        const auto jet = jet_at(crossing, t);
        const Vec3 before = jet_at(crossing, t - kStep)[0], after = jet_at(crossing, t + kStep)[0];
        const Vec3 rate = (0.5 / kStep) * (after - before);
        const Vec3 bend = (1 / (kStep * kStep)) * ((after - jet[0]) - (jet[0] - before));
        EXPECT_LT(distance(jet[1], rate), 1e-6 * (1 + norm(jet[2])));
        EXPECT_LT(distance(jet[2], bend), 1e-5 * (1 + norm(jet[2])));
      }
}

// Of a cylinder and a torus: x = z^2 / (4 R), so z goes as far as 2 sqrt(R r).
TEST(PipeJoint, ACylinderAndATorusCrossInAParabolicCylinder) {
  const auto joint = pipe_joint(pipe(), elbow(4, 0), kExact);
  const std::vector<PipeCrossing> found = crossings_beside(*joint);
  double most = 0;
  for (double t = 0; t < 2 * pi; t += 0.01) {
    const Vec3 p = jet_at(found[0], t)[0];
    EXPECT_NEAR(p[0], p[2] * p[2] / 16, 1e-14);
    most = std::max(most, std::abs(p[2]));
  }
  EXPECT_NEAR(most, 4, 1e-3);
  EXPECT_NEAR(arc_length(found[0], {0, 2 * pi}), 2 * arc_length(found[0], {0, pi}), 1e-11);
}

TEST(PipeJoint, OthersHaveNone) {
  EXPECT_FALSE(pipe_joint(pipe(), pipe(), kExact));
  EXPECT_FALSE(pipe_joint(pipe(), elbow(3, 0, 1 + 1e-6), kExact));
  EXPECT_FALSE(pipe_joint(elbow(3, 0), elbow(3, 0), kExact));
  EXPECT_FALSE(pipe_joint(elbow(3, 0), elbow(3, 1e-5), kExact));
  EXPECT_FALSE(pipe_joint(elbow(1, 0, 2), elbow(1, 1, 2), kExact));
  Elementary aside = elbow(3, 0);
  aside.centre += Vec3{0, 1e-6, 0};
  EXPECT_FALSE(pipe_joint(pipe(), aside, kExact));
  EXPECT_FALSE(pipe_joint(elbow(3, 1), aside, kExact));
}

TEST(PipeJoint, PipesThatTouchOnTheFarSideHaveNoCrossingInClosedForm) {
  const auto joint = pipe_joint(elbow(3, 0.1), elbow(4, 0.1), kExact);
  ASSERT_TRUE(joint);
  EXPECT_TRUE(crossings_beside(*joint).empty());
}

}  // namespace
}  // namespace blossom
