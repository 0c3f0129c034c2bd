// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces that touch along a line and cross there, and their neighbours.
//
// Two graphs c + h and c over the plane with h = k l^3 + e l, where l vanishes along a line or a
// hyperbola.

#include "core/surfaces/gap/cells/odd_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/surface_intersection.h"
#include "tests/support/components.h"
#include "tests/support/cubic_family.h"
#include "tests/support/random.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::Components;
using testing::components;
using testing::constant;
using testing::Cubic;
using testing::linear;
using testing::Random;
using testing::uniform;

constexpr double kTolerance = 1e-7;

// One branch through the unit square, not near its corners.
Cubic random_line(Random& random) {
  for (;;) {
    const double a = uniform(random, 0.3, 0.7), b = uniform(random, -1.5, 1.5);
    const double c = uniform(random, 0.3, 0.7), d = uniform(random, -1, 1);
    const Cubic x = linear(-a, 1, 0), y = linear(-c, 0, 1);
    const Cubic l = x + b * y + d * (x * y);
    if (std::min({std::abs(l(0, 0)), std::abs(l(1, 0)), std::abs(l(0, 1)), std::abs(l(1, 1))}) >
        0.1)
      return l;
  }
}

SurfaceIntersection meet(const Cubic& h, Random& random) {
  const testing::CubicPair pair = testing::cubic_pair(h);
  const testing::Motion motion = testing::random_motion(random);
  return intersect(moved(pair.a, motion), moved(pair.b, motion), {.time_limit = 10});
}

class OddContact : public ::testing::TestWithParam<int> {};

TEST_P(OddContact, IsOneTangentialCurve) {
  Random random = testing::seeded(GetParam());
  const Cubic l = random_line(random);
  const double k = uniform(random, 0.3, 3);
  const SurfaceIntersection found = meet(k * (l * l * l), random);

  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_EQ(components(found), (Components{.open = 1, .tangential = 1}));
  for (const IntersectionCurve& curve : found.curves)
    for (const SurfacePoint& sample : curve.samples)
      EXPECT_LE(std::abs(l(sample.uv_a[0], sample.uv_a[1])), 1e-6);
}

// A crossing at a small angle, or three next to each other, within a part of the tolerance.
TEST_P(OddContact, IsWhatCannotBeToldFromIt) {
  Random random = testing::seeded(1000 + GetParam());
  const Cubic l = random_line(random);
  const double k = uniform(random, 0.3, 3), sign = GetParam() % 2 == 0 ? 1 : -1;
  const double e = sign * std::exp(uniform(random, std::log(1e-10), std::log(3e-6)));
  const SurfaceIntersection found = meet(k * (l * l * l) + e * l, random);

  EXPECT_EQ(found.status, Status::Tolerance) << "e " << e << " k " << k;
  EXPECT_EQ(components(found), (Components{.open = 1, .tangential = 1})) << "e " << e;
}

using CurvesNearACrossingContact = OddContact;

// At small angles, but beyond a few tolerances: one curve that crosses all along.
TEST_P(CurvesNearACrossingContact, AreOneAtASmallAngle) {
  Random random = testing::seeded(2000 + GetParam());
  const Cubic l = random_line(random);
  const double k = uniform(random, 0.3, 3);
  const double e = std::exp(uniform(random, std::log(6e-5), std::log(2e-3)));
  const SurfaceIntersection found = meet(k * (l * l * l) + e * l, random);

  EXPECT_EQ(found.status, Status::Complete) << "e " << e << " k " << k;
  EXPECT_EQ(components(found), (Components{.open = 1})) << "e " << e << " k " << k;
}

// Beyond a few tolerances there are three, and that is proven.
TEST_P(CurvesNearACrossingContact, AreThreeWhenTheGapChangesItsSignThreeTimes) {
  Random random = testing::seeded(3000 + GetParam());
  const Cubic l = random_line(random);
  const double k = uniform(random, 0.3, 3), depth = uniform(random, 6, 100) * kTolerance;
  // k l^3 - e l is (2 / 3) e sqrt(e / (3 k)) deep.
  const double e = std::cbrt(27.0 / 4 * k * depth * depth);
  const SurfaceIntersection found = meet(k * (l * l * l) + -e * l, random);

  EXPECT_EQ(found.status, Status::Complete) << "e " << e << " k " << k;
  EXPECT_EQ(components(found), (Components{.open = 3})) << "e " << e << " k " << k;
}

INSTANTIATE_TEST_SUITE_P(Seeds, OddContact, ::testing::Range(0, 30));
INSTANTIATE_TEST_SUITE_P(Seeds, CurvesNearACrossingContact, ::testing::Range(0, 30));

}  // namespace
}  // namespace blossom
