// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs c + h and c where h is a product of three linear forms that vanish in one point.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/surface_intersection.h"
#include "tests/support/components.h"
#include "tests/support/cubic_draws.h"
#include "tests/support/draws.h"
#include "tests/support/random.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::components;
using testing::Components;
using testing::Cubic;
using testing::CubicPair;
using testing::Frame;
using testing::Random;

constexpr double kTolerance = 1e-7;
constexpr double kOnCurve = 1e-5;  // chords of samples lie so near to the curve
constexpr std::size_t kMaxPoles = 60;

// A line through the frame's origin at an angle to its y axis.
struct Line {
  Vec2 direction;
  Cubic form;

  Line(const Frame& frame, double angle)
      : direction{-std::sin(angle) * frame.c - std::cos(angle) * frame.s,
                  -std::sin(angle) * frame.s + std::cos(angle) * frame.c},
        form(std::cos(angle) * frame.x + std::sin(angle) * frame.y) {}
};

double distance_to(const IntersectionCurve& curve, const Vec2& p) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i) {
    const Vec3 &from = curve.samples[i].point, &to = curve.samples[i + 1].point;
    const Vec2 a{from[0], from[1]}, run{to[0] - from[0], to[1] - from[1]};
    const double t = std::clamp(dot(p - a, run) / std::max(dot(run, run), 1e-300), 0.0, 1.0);
    least = std::min(least, norm(p - a - t * run));
  }
  return least;
}

// Points of the line within the unit square that no curve comes near.
int uncovered(const SurfaceIntersection& found, const Frame& frame, const Line& line) {
  int count = 0;
  for (int i = -750; i <= 750; ++i) {
    const Vec2 p = Vec2{frame.x0, frame.y0} + line.direction * (i / 500.0);
    if (std::min(p[0], p[1]) < 0 || std::max(p[0], p[1]) > 1) continue;
    count += std::ranges::none_of(found.curves, [&](const IntersectionCurve& curve) {
      return distance_to(curve, p) <= kOnCurve;
    });
  }
  return count;
}

void expect_well_written(const SurfaceIntersection& found) {
  for (const IntersectionCurve& curve : found.curves) {
    EXPECT_LE(std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}),
              kTolerance);
    EXPECT_LE(curve.curve.points.size(), kMaxPoles);
  }
}

SurfaceIntersection found_of(const BezierSurface& a, const BezierSurface& b) {
  IntersectionOptions options;
  options.tolerances.point = kTolerance;
  return intersect(a, b, options);
}

// A line of contact that a branch crosses: four curves that begin in one node, whatever the scale
// and the angle.
TEST(ThirdOrderNodes, LineOfContactMeetsTheBranchAcrossIt) {
  Random random = testing::seeded(5);
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    const Frame frame(random);
    const Line contact(frame, 0);
    const Line branch(frame, testing::uniform(random, 0.15, std::numbers::pi - 0.15));
    const double scale = testing::log_uniform(random, 0.03, 30);
    CubicPair pair = testing::cubic_pair(scale * (contact.form * contact.form * branch.form),
                                         testing::random_base(random));
    if (trial % 3 == 1) std::swap(pair.a, pair.b);
    const SurfaceIntersection found = found_of(pair.a, pair.b);
    EXPECT_EQ(components(found), (Components{.open = 4, .tangential = 2, .nodes = 1}));
    EXPECT_EQ(found.status, Status::Tolerance);
    EXPECT_EQ(uncovered(found, frame, contact), 0);
    EXPECT_EQ(uncovered(found, frame, branch), 0);
    expect_well_written(found);
  }
}

// The same where a knot line passes through the contact, wherever it does.
TEST(ThirdOrderNodes, KnotLinesChangeNothing) {
  Random random = testing::seeded(11);
  for (int trial = 0; trial < 30; ++trial) {
    SCOPED_TRACE(trial);
    const Frame frame(random);
    const Line contact(frame, 0), branch(frame, testing::uniform(random, 0.4, 2.7));
    const CubicPair pair = testing::cubic_pair(contact.form * contact.form * branch.form);
    const BezierSurface b = testing::split_in_u(pair.b, testing::uniform(random, 0.2, 0.8));
    const SurfaceIntersection found = found_of(pair.a, b);
    EXPECT_EQ(components(found), (Components{.open = 4, .tangential = 2, .nodes = 1}));
    expect_well_written(found);
  }
}

TEST(ThirdOrderNodes, ThreeBranchesMeet) {
  Random random = testing::seeded(7);
  for (int trial = 0; trial < 40; ++trial) {
    SCOPED_TRACE(trial);
    const Frame frame(random);
    const std::array lines{Line(frame, 0), Line(frame, testing::uniform(random, 0.7, 1.3)),
                           Line(frame, testing::uniform(random, 1.9, 2.5))};
    const double scale = testing::log_uniform(random, 0.1, 10);
    const CubicPair pair = testing::cubic_pair(
        scale * (lines[0].form * lines[1].form * lines[2].form), testing::random_base(random));
    const SurfaceIntersection found = found_of(pair.a, pair.b);
    EXPECT_EQ(components(found), (Components{.open = 6, .nodes = 1}));
    for (const Line& line : lines) EXPECT_EQ(uncovered(found, frame, line), 0);
    expect_well_written(found);
  }
}

}  // namespace
}  // namespace blossom
