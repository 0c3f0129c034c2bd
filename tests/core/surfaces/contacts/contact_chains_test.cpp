// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/contact_chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/surface_intersection.h"
#include "tests/core/tracing/surface_pairs.h"
#include "tests/support/components.h"
#include "tests/support/cubic_family.h"
#include "tests/support/random.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

// About the axis z.
BezierSurface turned(const BezierSurface& surface, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  testing::Motion turn;
  turn.rotation = {Vec3{c, -s, 0}, Vec3{s, c, 0}, Vec3{0, 0, 1}};
  return moved(surface, turn);
}

// Of a graph's curve over a chord.
double length_over(const testing::Cubic& z, const Vec2& from, const Vec2& to) {
  constexpr int kSteps = 2000;
  double sum = 0;
  Vec3 last{from[0], from[1], z(from[0], from[1])};
  for (int i = 1; i <= kSteps; ++i) {
    const Vec2 x = from + (static_cast<double>(i) / kSteps) * (to - from);
    const Vec3 next{x[0], x[1], z(x[0], x[1])};
    sum += distance(last, next);
    last = next;
  }
  return sum;
}

// A torus touches the cylinder round it along its outer equator. Each surface's parameters jump at
// its seam, so the circle is cut there: its images stay on the surfaces.
TEST(ContactChains, EndWhereTheSeamOfASurfaceIs) {
  const double pi = std::numbers::pi;
  const BezierSurface a = testing::revolved(testing::circle(1, 0.4, -1, 2 * pi - 1, 4),
                                            {-1, pi / 2 - 1, pi - 1, 1.5 * pi - 1, 2 * pi - 1},
                                            ParameterLaw::Angle, 2 * pi, 4);
  const BezierSurface b = turned(testing::cylinder(1.4, -1, 1), 1);

  const SurfaceIntersection found = intersect(a, b);

  EXPECT_EQ(found.status, Status::Tolerance);
  ASSERT_FALSE(found.curves.empty());
  double length = 0;
  for (const IntersectionCurve& curve : found.curves) {
    EXPECT_TRUE(curve.tangential);
    EXPECT_FALSE(curve.closed);
    EXPECT_LE(std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}), 1e-6);
    length += curve.length;
  }
  EXPECT_NEAR(length, 2 * pi * 1.4, 1e-6);
}

// A cylinder touches the torus round it along the inner equator, a border of the torus's patches.
// Over one patch of the cylinder it passes a corner of those.
TEST(ContactChains, GoOnAlongABorderPastTheCornersOfPatches) {
  const BezierSurface torus = testing::torus(1, 0.4);
  for (const double angle : {0.3, 0.5443, 0.7, 1.2, 1.5}) {
    SCOPED_TRACE(angle);
    const BezierSurface cylinder = turned(testing::cylinder(0.6, -0.7, 0.8), angle);
    for (const SurfaceIntersection& found :
         {intersect(cylinder, torus), intersect(torus, cylinder)}) {
      double length = 0;
      for (const IntersectionCurve& curve : found.curves) {
        EXPECT_TRUE(curve.tangential);
        length += curve.length;
      }
      EXPECT_NEAR(length, 1.2 * std::numbers::pi, 1e-6);
    }
  }
}

// Four flat faces over the unit squares round the origin, at the height |x| - 0.8 |y|.
BezierSurface kinked() {
  BezierSurface surface{{-1, 0, 1}, {-1, 0, 1}};
  surface.patches = Grid<RationalBezierPatch>(2, 2, {Grid<Vec4>(2, 2)});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double x = surface.u_knots[static_cast<std::size_t>((i + 1) / 2)];
      const double y = surface.v_knots[static_cast<std::size_t>((j + 1) / 2)];
      surface.patches(i / 2, j / 2).points(i % 2, j % 2) = {x, y, std::abs(x) - 0.8 * std::abs(y),
                                                            1};
    }
  return surface;
}

// A plane through their corner meets all of them.
TEST(ContactChains, MeetWhereFourKinkedPatchesHaveACorner) {
  BezierSurface plane{{0, 1}, {0, 1}};
  plane.patches = Grid<RationalBezierPatch>(1, 1, {Grid<Vec4>(2, 2)});
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      plane.patches(0, 0).points(i, j) = {4.0 * i - 2, 4.0 * j - 2, 0.2 * i - 0.1, 1};
  testing::Random random = testing::seeded(0);
  for (int row = 0; row < 20; ++row) {
    const testing::Motion motion = testing::random_motion(random);
    const BezierSurface a = moved(kinked(), motion), b = moved(turned(plane, row), motion);

    for (const SurfaceIntersection& found : {intersect(a, b), intersect(b, a)}) {
      EXPECT_EQ(found.status, Status::Tolerance);
      EXPECT_EQ(testing::components(found), (testing::Components{.open = 4, .nodes = 1}));
      ASSERT_EQ(found.places.size(), 1u);
      EXPECT_EQ(found.places[0].kind, PlaceKind::Node);
      EXPECT_LE(distance(found.nodes[0].point, motion.shift), 1e-12);
    }
  }
}

// The surfaces meet along the border x = 0 of the first one, and along y = p - x / 10.
TEST(ContactChains, MeetWhereABranchEndsOnOneAlongABorder) {
  for (const double p : {0.125, 0.366, 0.655, 0.875}) {
    SCOPED_TRACE(p);
    const testing::Cubic h = testing::linear(0, 1, 0) * testing::linear(-p, 0.1, 1);
    const BezierSurface a = testing::graph(testing::base_cubic() + h, {0, 0}, {1, 0}, {0, 1});
    for (const BezierSurface& b :
         {testing::graph(testing::base_cubic(), {0, 0}, {1, 0}, {0, 1}),
          testing::graph(testing::base_cubic(), {-0.6, 0.3}, {1.6, -1.2}, {1.2, 1.6})})
      for (const SurfaceIntersection& found : {intersect(a, b), intersect(b, a)}) {
        EXPECT_EQ(testing::components(found), (testing::Components{.open = 3, .nodes = 1}));
        ASSERT_EQ(found.nodes.size(), 1u);
        const Vec3 node{0, p, testing::base_cubic()(0, p)};
        EXPECT_LE(distance(found.nodes[0].point, node), 1e-9);
        for (const IntersectionCurve& curve : found.curves)
          EXPECT_LE(std::min(distance(curve.samples.front().point, node),
                             distance(curve.samples.back().point, node)),
                    1e-9);
      }
  }
}

// Small and far from the origin: control points are rounded, so that the branch along the border is
// beside it near the node.
TEST(ContactChains, MeetInTheSameNodeWhereverThePairIs) {
  testing::Random random = testing::seeded(4);
  const testing::Cubic base = testing::base_cubic();
  for (int draw = 0; draw < 8; ++draw) {
    SCOPED_TRACE(draw);
    const double p = testing::uniform(random, 0.2, 0.8);
    const testing::Cubic h = testing::linear(0, 1, 0) * testing::linear(-p, 0.1, 1);
    testing::Motion motion = testing::random_motion(random);
    for (const double scale : {1e-2, 1e-3}) {
      SCOPED_TRACE(scale);
      motion.scale = scale;
      const auto placed = [&](const BezierSurface& surface) { return moved(surface, motion); };
      const BezierSurface a = placed(testing::graph(base + 0.25 * h, {0, 0}, {1, 0}, {0, 1}));
      const BezierSurface b = placed(testing::graph(base, {-0.6, 0.3}, {1.6, -1.2}, {1.2, 1.6}));
      const double length =
          length_over(base, {0, 0}, {0, 1}) + length_over(base, {0, p}, {1, p - 0.1});

      const SurfaceIntersection found = intersect(a, b, {.tolerances = {.point = 1e-7 * scale}});

      EXPECT_EQ(testing::components(found), (testing::Components{.open = 3, .nodes = 1}));
      double sum = 0;
      for (const IntersectionCurve& curve : found.curves) {
        sum += curve.length;
        EXPECT_LT(curve.samples.size(), 500u);
      }
      EXPECT_NEAR(sum, scale * length, 1e-5 * scale);
    }
  }
}

// Two cells share the loop's flank, where the surfaces are within the tolerance of each other, but
// only one of them has the loop.
TEST(ContactChains, AreNoneBesideTheBranchOfTheNextCell) {
  for (const double x : {0.4, 0.45, 0.5, 0.55, 0.58, 0.6})
    for (const double y : {0.4, 0.5, 0.58}) {
      SCOPED_TRACE(x);
      SCOPED_TRACE(y);
      const testing::Cubic h = 2.5e-5 * testing::loop(x, y, 0.155);
      const BezierSurface a = testing::graph(testing::base_cubic() + h, {0, 0}, {1, 0}, {0, 1});
      const BezierSurface b = testing::graph(testing::base_cubic(), {0, 0}, {1, 0}, {0, 1});
      EXPECT_EQ(testing::components(intersect(a, b)), (testing::Components{.closed = 1}));
      EXPECT_EQ(testing::components(intersect(b, a)), (testing::Components{.closed = 1}));
    }
}

// The gap of a valley falls towards the line where what counts of both surfaces ends: there is no
// branch beyond it.
TEST(ContactChains, StayWhereTheyEndWithAPart) {
  constexpr double kTolerance = 1e-7;
  for (const double low : {0.1, 0.2})
    for (const double slope : {0.5, 1.0, 2.0})
      for (const double end : {0.3, 0.5, 0.6}) {
        SCOPED_TRACE(low);
        SCOPED_TRACE(slope);
        SCOPED_TRACE(end);
        const testing::Cubic y = testing::linear(-0.5, 0, 1);
        const testing::Cubic gap =
            kTolerance * testing::linear(low + slope * end, -slope, 0) + y * y;
        const BezierSurface a = testing::graph(testing::base_cubic() + gap, {0, 0}, {1, 0}, {0, 1});
        const BezierSurface b = testing::graph(testing::base_cubic(), {0, 0}, {1, 0}, {0, 1});
        const PartTest part = [end](const Interval& u, const Interval&) {
          if (u.from > end) return PartSide::Outside;
          return u.to <= end ? PartSide::Inside : PartSide::Mixed;
        };
        for (const bool exchanged : {false, true}) {
          const SurfaceIntersection found =
              intersect(exchanged ? b : a, exchanged ? a : b,
                        {.tolerances = {.point = kTolerance}, .part_a = part, .part_b = part});
          EXPECT_EQ(found.status, Status::Tolerance);
          EXPECT_EQ(found.places.size(), 1u);
          EXPECT_EQ(found.curves.size() + found.points.size(), 1u);
        }
      }
}

}  // namespace
}  // namespace blossom
