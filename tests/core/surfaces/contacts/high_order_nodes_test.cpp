// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs c + h and c where h is a product of three linear forms or more that vanish in one point.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/forms/algebra/degree.h"
#include "core/forms/algebra/products.h"
#include "core/surface_intersection.h"
#include "core/surfaces/retry/finer_tolerance.h"
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
TEST(HighOrderNodes, LineOfContactMeetsTheBranchAcrossIt) {
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
TEST(HighOrderNodes, KnotLinesChangeNothing) {
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

TEST(HighOrderNodes, ThreeBranchesMeet) {
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

// Over the unit square: k + x u + y v.
BezierFunction2 bilinear(double k, double x, double y) {
  BezierFunction2 f{Grid<double>(2, 2)};
  f.points(0, 0) = k;
  f.points(1, 0) = k + x;
  f.points(0, 1) = k + y;
  f.points(1, 1) = k + x + y;
  return f;
}

// The graph of a function over the unit square, of a higher degree than it needs.
BezierSurface graph_of(const BezierFunction2& function) {
  const int degree = std::max(function.points.rows(), function.points.columns());
  const BezierFunction2 z = elevated(function, degree, degree);
  const BezierFunction2 u = elevated(bilinear(0, 1, 0), degree, degree),
                        v = elevated(bilinear(0, 0, 1), degree, degree);
  Grid<Vec4> net(degree + 1, degree + 1);
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      net(i, j) = {u.points(i, j), v.points(i, j), z.points(i, j), 1};
  return testing::of_patch(RationalBezierPatch{net});
}

// Lines through a point of the unit square, with what of them lies in the square.
struct Star {
  double x, y, scale;
  std::vector<double> angles;

  double length() const {
    double sum = 0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      if (i > 0 && angles[i] == angles[i - 1]) continue;
      const Vec2 d{std::cos(angles[i]), std::sin(angles[i])};
      double from = -1e9, to = 1e9;
      for (const auto& [p, run] : {std::pair{x, d[0]}, std::pair{y, d[1]}}) {
        from = std::max(from, std::min(-p / run, (1 - p) / run));
        to = std::min(to, std::max(-p / run, (1 - p) / run));
      }
      sum += to - from;
    }
    return sum;
  }

  // The graph of the product of all lines.
  BezierSurface graph() const {
    BezierFunction2 z = bilinear(scale, 0, 0);
    for (const double t : angles)
      z = product(bilinear(std::cos(t) * y - std::sin(t) * x, std::sin(t), -std::cos(t)), z);
    return graph_of(z);
  }
};

BezierSurface floor_below() {
  Grid<Vec4> net(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) net(i, j) = {1.7 * i - 0.4, 1.9 * j - 0.3, 0, 1};
  return testing::of_patch(RationalBezierPatch{net});
}

double length_of(const SurfaceIntersection& found) {
  double sum = 0;
  for (const IntersectionCurve& curve : found.curves) sum += curve.length;
  return sum;
}

Star saddle(Random& random, int n) {
  const double turn = testing::uniform(random, 0, std::numbers::pi);
  Star star{testing::uniform(random, 0.3, 0.7),
            testing::uniform(random, 0.3, 0.7),
            testing::log_uniform(random, 0.3, 3) * std::pow(2, n - 1),
            {}};
  for (int k = 0; k < n; ++k) star.angles.push_back(turn + k * std::numbers::pi / n);
  return star;
}

// z = Re (x + iy)^n, n branches through one point: 2n arms as long as the branches, none twice.
TEST(HighOrderNodes, SaddlesOfAnyOrderHaveTheirArms) {
  Random random = testing::seeded(17);
  for (int n = 2; n <= 6; ++n)
    for (int trial = 0; trial < 6; ++trial) {
      SCOPED_TRACE(::testing::Message() << n << " fold, trial " << trial);
      const Star star = saddle(random, n);
      const testing::Motion motion = testing::random_motion(random);
      const SurfaceIntersection found =
          found_of(testing::moved(star.graph(), motion), testing::moved(floor_below(), motion));
      EXPECT_EQ(components(found), (Components{.open = 2 * n, .nodes = 1}));
      EXPECT_NEAR(length_of(found), star.length(), 1e-6);
      expect_well_written(found);
    }
}

// x^2 y, x^2 y^2, x^3 y, x^2 y (x + y): lines in which the surfaces touch, and others.
TEST(HighOrderNodes, LinesOfContactMeetBranches) {
  Random random = testing::seeded(19);
  const struct {
    std::vector<double> angles;
    Components components;
  } kinds[]{{{0, 0, 1.3}, {.open = 4, .tangential = 2, .nodes = 1}},
            {{0, 0, 1.3, 1.3}, {.open = 4, .tangential = 4, .nodes = 1}},
            {{0, 0, 0, 1.3}, {.open = 4, .tangential = 2, .nodes = 1}},
            {{0, 0, 1, 2}, {.open = 6, .tangential = 2, .nodes = 1}}};
  for (const auto& kind : kinds)
    for (int trial = 0; trial < 6; ++trial) {
      SCOPED_TRACE(trial);
      Star star = saddle(random, 3);
      const double turn = star.angles[0];
      star.angles = kind.angles;
      for (double& angle : star.angles) angle += turn;
      const SurfaceIntersection found = found_of(star.graph(), floor_below());
      EXPECT_EQ(components(found), kind.components);
      EXPECT_NEAR(length_of(found), star.length(), 1e-6);
    }
}

// z = x^2 (y + bend x^2): a line of contact and a branch that bends away from its tangent, by more
// than rounding over the disc. It leads to the node all the same, and no finer tolerance is asked.
TEST(HighOrderNodes, BentBranchesReachTheNode) {
  Random random = testing::seeded(29);
  for (int trial = 0; trial < 10; ++trial) {
    SCOPED_TRACE(trial);
    const Star star = saddle(random, 3);
    const double c = std::cos(star.angles[0]), s = std::sin(star.angles[0]);
    const BezierFunction2 x = bilinear(-c * star.x - s * star.y, c, s);
    const BezierFunction2 y = bilinear(s * star.x - c * star.y, -s, c);
    const double bend = testing::uniform(random, 1.5, 3) * (trial % 2 == 0 ? 1 : -1);
    const BezierFunction2 square = product(x, x), across = elevated(y, 2, 2);
    BezierFunction2 branch = square;
    for (std::size_t i = 0; i < branch.points.values().size(); ++i)
      branch.points.values()[i] = bend * square.points.values()[i] + across.points.values()[i];
    const double scale = testing::log_uniform(random, 0.003, 0.03);
    const SurfaceIntersection found =
        found_of(graph_of(product(product(bilinear(scale, 0, 0), square), branch)), floor_below());
    EXPECT_EQ(components(found), (Components{.open = 4, .tangential = 2, .nodes = 1}));
    EXPECT_FALSE(ends_beside_node(found));
    ASSERT_EQ(found.nodes.size(), 1u);
    for (const IntersectionCurve& curve : found.curves)
      EXPECT_LE(std::min(distance(curve.samples.front().point, found.nodes[0].point),
                         distance(curve.samples.back().point, found.nodes[0].point)),
                kTolerance);
    expect_well_written(found);
  }
}

// The floor tilted by so little that all stays within tolerance where three branches would meet:
// none is traced through that region, and none ends in it where finer tolerances tell them apart.
TEST(HighOrderNodes, BranchesThatPassEachOtherWithinToleranceAreWhole) {
  Random random = testing::seeded(23);
  for (int trial = 0; trial < 10; ++trial) {
    SCOPED_TRACE(trial);
    const Star star = saddle(random, 3);
    const double radius = std::cbrt(8 * kTolerance / (star.scale / 4));
    BezierSurface floor = floor_below();
    for (Vec4& p : floor.patches(0, 0).points.values())
      p[2] = 0.8 * kTolerance / radius * (p[0] - star.x);
    const SurfaceIntersection found = found_of(star.graph(), floor);
    EXPECT_EQ(components(found).open, 3);
    // Each of two branches turns away from the node by less than the disc's radius.
    EXPECT_NEAR(length_of(found), star.length(), 2 * radius);
    for (const IntersectionCurve& curve : found.curves)
      EXPECT_LE(curve.curve.points.size(), 2 * kMaxPoles);
  }
}

// A patch, one ruled from its last border to the first one of the other, and that one.
BezierSurface joined_by_ruled(const RationalBezierPatch& first, const RationalBezierPatch& last) {
  const int n = first.points.rows() - 1;
  RationalBezierPatch between = first;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < first.points.columns(); ++j)
      between.points(i, j) = first.points(n, j) + (last.points(0, j) - first.points(n, j)) *
                                                      (static_cast<double>(i) / n);
  BezierSurface surface{.u_knots = {0, 1, 2, 3}, .v_knots = {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(3, 1);
  surface.patches(0, 0) = first;
  surface.patches(1, 0) = between;
  surface.patches(2, 0) = last;
  return surface;
}

// The same beside a bump that the floor misses by half the tolerance: the finer search that tells
// the branches apart does not see the near miss, and must not lose it.
TEST(HighOrderNodes, BranchesThatPassEachOtherHideNoNearMiss) {
  const Star star{0.5, 0.5, 2, {1, 1.6, 2.2}};
  const double slope = 0.4 * kTolerance / std::cbrt(8 * kTolerance / (star.scale / 4));
  const RationalBezierPatch crossed = star.graph().patches(0, 0);
  const int degree = crossed.points.rows() - 1;
  const BezierFunction2 x = bilinear(-0.5, 1, 0), y = bilinear(-0.5, 0, 1);
  const BezierFunction2 xx = elevated(product(x, x), degree, degree),
                        yy = elevated(product(y, y), degree, degree);
  RationalBezierPatch bump = crossed;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j) {
      Vec4& p = bump.points(i, j);
      p[0] += 2;
      p[2] = xx.points(i, j) + yy.points(i, j) + slope * (p[0] - star.x) + 0.5 * kTolerance;
    }
  BezierSurface floor = floor_below();
  for (Vec4& p : floor.patches(0, 0).points.values()) {
    if (p[0] > 0) p[0] += 2;
    p[2] = slope * (p[0] - star.x);
  }
  const SurfaceIntersection found = found_of(joined_by_ruled(crossed, bump), floor);
  EXPECT_TRUE(std::ranges::any_of(found.places, [](const Place& place) {
    return place.box_low[0] <= 2.5 && 2.5 <= place.box_high[0];
  }));
}

}  // namespace
}  // namespace blossom
