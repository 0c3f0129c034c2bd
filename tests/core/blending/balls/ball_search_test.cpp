// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/ball_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/errors.h"
#include "tests/support/ball_shapes.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::floor_face;
using testing::plane_patch;
using testing::wall_face;
using testing::whole_cylinder;

using std::numbers::pi;

BallSpines spines_of(const BezierSurface& a, int side_a, const BezierSurface& b, int side_b,
                     double r) {
  return ball_spines(whole_support(a, side_a), whole_support(b, side_b), r);
}

// The length of the centre's path, by many chords.
double centre_length(const BallTrack& track) {
  constexpr int kChords = 2000;
  double sum = 0;
  Vec3 before = track.at(track.domain().from).centre;
  for (int i = 1; i <= kChords; ++i) {
    const Vec3 c = track.at(at(track.domain(), double(i) / kChords)).centre;
    sum += distance(before, c);
    before = c;
  }
  return sum;
}

TEST(BallSearch, FindsOneTrackBesideAFreeFormEdgeAndNoneOnOtherSides) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  for (const double r : {0.02, 0.05, 0.1, 0.2, 0.4}) {
    const BallSpines spines = spines_of(floor, 1, wall, 1, r);
    EXPECT_EQ(spines.status, Status::Complete) << r;
    ASSERT_EQ(spines.spines.size(), 1U) << r;
    EXPECT_TRUE(spines.spines[0].is_valid());
    EXPECT_TRUE(spines.lost.empty());
    EXPECT_LE(spines.offset_errors[0], 1e-9);
    for (const auto& [s, t] : {std::pair{1, -1}, std::pair{-1, 1}, std::pair{-1, -1}}) {
      const BallSpines none = spines_of(floor, s, wall, t, r);
      EXPECT_EQ(none.status, Status::Complete);
      EXPECT_TRUE(none.spines.empty());
    }
  }
}

TEST(BallSearch, BesideASphereRunsRoundACircle) {
  const double R = 2, h = 0.5, r = 0.3;  // the sphere's centre is h below the plane
  const BezierSurface sphere = testing::upper_sphere(R);
  const BezierSurface plane = plane_patch({0, 0, h}, {1, 0, 0}, {0, 1, 0}, {-4, 4}, {-4, 4});
  const BallSpines spines = spines_of(plane, 1, sphere, 1, r);
  EXPECT_EQ(spines.status, Status::Complete);
  ASSERT_EQ(spines.spines.size(), 1U);
  const BallTrack& track = spines.spines[0].track;
  EXPECT_TRUE(track.closed());
  const double radius = std::sqrt((R + r) * (R + r) - (h + r) * (h + r));
  for (int i = 0; i <= 20; ++i) {
    const BallPoint ball = track.at(at(track.domain(), i / 20.0));
    EXPECT_NEAR(std::hypot(ball.centre[0], ball.centre[1]), radius, 1e-14);
    EXPECT_NEAR(ball.centre[2], h + r, 1e-14);
  }
}

TEST(BallSearch, BetweenCylindersHasTheCentresOnBothLargerOnes) {
  const double R1 = 1, R2 = 0.6, r = 0.15;
  BezierSurface a = whole_cylinder(R1, 6), b = whole_cylinder(R2, 6);
  testing::Motion down, turned;
  down.shift = {0, 0, -3};
  turned.rotation = {Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}};
  turned.shift = {-3, 0, 0};
  a = testing::moved(a, down);
  b = testing::moved(b, turned);
  const BallSpines spines = spines_of(a, 1, b, 1, r);
  EXPECT_EQ(spines.status, Status::Complete);
  ASSERT_EQ(spines.spines.size(), 2U);
  for (const BallSpine& spine : spines.spines) {
    EXPECT_TRUE(spine.track.closed());
    EXPECT_TRUE(spine.is_valid());
    for (int i = 0; i <= 50; ++i) {
      const Vec3 c = spine.track.at(at(spine.track.domain(), i / 50.0)).centre;
      EXPECT_NEAR(std::hypot(c[0], c[1]), R1 + r, 1e-14);
      EXPECT_NEAR(std::hypot(c[1], c[2]), R2 + r, 1e-14);
    }
  }
}

// z = 2r - gap + k rho^2 over the plane z = 0: a ball squeezed between them runs round a loop.
TEST(BallSearch, SqueezedUnderAParaboloidRunsRoundASmallLoop) {
  const double r = 0.3;
  for (const double k : {1.0, 4.0})
    for (const double gap : {1e-2, 1e-4, 1e-6}) {
      const testing::Cubic roof =
          testing::loop(0, 0, std::sqrt(gap / k), k) + testing::constant(2 * r);
      const BezierSurface plane = plane_patch({-0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0});
      const BezierSurface bowl = testing::graph(roof, {-0.5, -0.5}, {1, 0}, {0, 1});
      const BallSpines spines = spines_of(plane, 1, bowl, -1, r);
      EXPECT_EQ(spines.status, Status::Complete) << k << " " << gap;
      ASSERT_EQ(spines.spines.size(), 1U) << k << " " << gap;
      const BallTrack& track = spines.spines[0].track;
      EXPECT_TRUE(track.closed());
      const double expected = 2 * pi * std::sqrt(gap * (1 + 2 * k * r) / k);
      EXPECT_NEAR(centre_length(track) / expected, 1, 3 * gap + 1e-5);
    }
}

TEST(BallSearch, TurnsBackInATroughAtTheCuspsOfItsClosedForm) {
  const double a = 2;
  const BezierSurface trough = testing::trough(a, 0.5, 1);
  const BezierSurface wall = plane_patch({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {-3, 3}, {-1, 3});
  for (const double r : {0.2, 0.24, 0.2499, 0.2501, 0.251, 0.26, 0.3}) {
    const BallSpines spines = spines_of(trough, 1, wall, -1, r);
    ASSERT_EQ(spines.spines.size(), 1U) << r;
    EXPECT_EQ(spines.status, Status::Complete) << r;
    const BallSpine& spine = spines.spines[0];
    ASSERT_EQ(spine.cusps.size(), r < 0.25 ? 0U : 2U) << r;
    EXPECT_EQ(spine.stretches.size(), r < 0.25 ? 1U : 3U) << r;
    EXPECT_EQ(spine.is_valid(), r < 0.25);
    const BallPinch tightest = tightest_of(spine.track);
    EXPECT_NEAR(tightest.factor, 1 - 2 * a * r, 1e-12);
    EXPECT_EQ(tightest.support, 0);
    for (const BallCusp& cusp : spine.cusps) {
      const double x = std::sqrt(std::pow(2 * a * r, 2.0 / 3) - 1) / (2 * a);
      EXPECT_EQ(cusp.support, 0);
      EXPECT_NEAR(std::abs(spine.track.at(cusp.parameter).contacts[0].point[0]), x, 1e-10);
    }
  }
}

TEST(BallSearch, FindsTheSameTracksOfSwappedReversedAndScaledSurfaces) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallSpines plain = spines_of(floor, 1, wall, 1, 0.1);
  ASSERT_EQ(plain.spines.size(), 1U);
  const double length = centre_length(plain.spines[0].track);
  const BezierSurface back = testing::reversed(floor), flipped = testing::exchanged(wall);
  const BallSpines swapped = spines_of(flipped, -1, back, 1, 0.1);
  ASSERT_EQ(swapped.spines.size(), 1U);
  EXPECT_NEAR(centre_length(swapped.spines[0].track), length, 1e-9);
  auto random = testing::seeded(3);
  for (const double scale : {1e-3, 1e3}) {
    testing::Motion motion = testing::random_motion(random);
    motion.scale = scale;
    BallSpineOptions options;
    options.fit_tolerance *= scale;
    options.intersection.tolerances.point *= scale;
    const BezierSurface a = testing::moved(floor, motion), b = testing::moved(wall, motion);
    const BallSpines moved =
        ball_spines(whole_support(a, 1), whole_support(b, 1), 0.1 * scale, options);
    ASSERT_EQ(moved.spines.size(), 1U);
    EXPECT_NEAR(centre_length(moved.spines[0].track) / scale, length, 1e-9);
  }
}

// A bicubic over a square of a plane, its points moved by up to `rough`.
BezierSurface rough_plane(testing::Random& random, const Vec3& origin, const Vec3& e, const Vec3& f,
                          double rough) {
  RationalBezierPatch patch{Grid<Vec4>(4, 4)};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      Vec3 p = origin + e * (i / 3.0) + f * (j / 3.0);
      for (int k = 0; k < 3; ++k) p[k] += testing::uniform(random, -rough, rough);
      patch.points(i, j) = {p[0], p[1], p[2], 1};
    }
  return testing::of_patch(patch);
}

TEST(BallSearch, TouchesRandomFacesToRounding) {
  auto random = testing::seeded(11);
  int found = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const BezierSurface floor = rough_plane(random, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.12);
    const BezierSurface wall = rough_plane(random, {0, 0.5, -0.5}, {1, 0, 0}, {0, 0, 1}, 0.12);
    const double r = testing::uniform(random, 0.02, 0.2);
    const int side = testing::pick(random, 0, 1) == 0 ? 1 : -1;
    const BallSpines spines = spines_of(floor, 1, wall, side, r);
    EXPECT_TRUE(spines.lost.empty()) << trial;
    found += static_cast<int>(spines.spines.size());
    for (const BallSpine& spine : spines.spines)
      for (int i = 0; i <= 30; ++i) {
        const BallPoint ball = spine.track.at(at(spine.track.domain(), i / 30.0));
        for (const BallContact& contact : ball.contacts)
          EXPECT_NEAR(distance(contact.point, ball.centre), r, 1e-14) << trial;
      }
  }
  EXPECT_GE(found, 12);
}

TEST(BallSearch, IsChosenByAPointOfTheEdge) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  const BallSpines spines = spines_of(floor, 1, wall, 1, 0.1);
  EXPECT_EQ(nearest_spine(spines, {0.5, 0.5, 0}), 0);
  EXPECT_EQ(nearest_spine({}, {0.5, 0.5, 0}), -1);
}

TEST(BallSearch, RefusesWhatIsNoRadius) {
  const BezierSurface floor = floor_face(), wall = wall_face();
  EXPECT_THROW(spines_of(floor, 1, wall, 1, 0), InvalidInput);
  EXPECT_THROW(spines_of(floor, 0, wall, 1, 0.1), InvalidInput);
}

}  // namespace
}  // namespace blossom
