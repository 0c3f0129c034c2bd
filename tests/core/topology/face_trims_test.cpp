// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/face_trims.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "core/topology/chart_region.h"
#include "tests/support/flat_trims.h"

namespace blossom {
namespace {

using std::numbers::pi;
using testing::FlatLoops;
using testing::kSquare4;
using testing::plane_chart;
using testing::square_without_disc;

TEST(TrimsOf, AnOpenLoopAreNone) {
  FlatLoops loops;
  loops.add_polygon(kSquare4);
  loops.loops.front().pop_back();
  EXPECT_FALSE(trims_of(plane_chart(), loops.vertices, loops.loops));
}

TEST(TrimsOf, ARectangleAreNatural) {
  FlatLoops loops;
  loops.add_polygon(kSquare4);
  const FaceTrims trims = testing::trims_of(loops);
  EXPECT_TRUE(trims.natural);
  EXPECT_EQ(trims.corners.size(), 4u);
  EXPECT_EQ(trims.largest_gap, 0);
  EXPECT_FALSE(square_without_disc().natural);
}

// Both sides of the seam end in the same two vertices.
TEST(TrimsOf, ASeamHaveCornersOfTheirOwnOnEachSide) {
  FlatLoops loops;
  const int low = loops.add_vertex({0, 0}), high = loops.add_vertex({0, 3});
  std::vector<Coedge> loop{loops.coedge(planar_line({0, 0}, {6, 0}, {0, 6}), low, low),
                           loops.coedge(planar_line({6, 0}, {6, 3}, {0, 3}), low, high),
                           loops.coedge(planar_line({0, 3}, {6, 3}, {0, 6}), high, high),
                           loops.coedge(planar_line({0, 0}, {0, 3}, {0, 3}), high, low)};
  loop[2].reversed = loop[3].reversed = true;
  loop[3].edge = loop[1].edge;
  loops.loops.push_back(std::move(loop));
  const FaceTrims trims = testing::trims_of(loops);
  EXPECT_EQ(trims.corners.size(), 4u);
  EXPECT_EQ(trims.largest_gap, 0);
  EXPECT_TRUE(is_inside(trims, {3, 1}));
}

struct TouchingWires {
  double off = 0;  // of the hole's ends from the vertex
  double tolerance = 0;
  double scale = 1;  // chart coordinates per model length
};

// A hole touches the border from inside in a vertex, which its curves miss.
TEST(TrimsOf, WiresThatTouchInAVertexHaveTheSameCornerThere) {
  for (const auto& [off, tolerance, scale] : {TouchingWires{1e-15, 1e-7, 1}, {8e-5, 1e-4, 2}}) {
    FlatLoops loops;
    const int at = loops.add_vertex({2, 0}), a = loops.add_vertex({0, 0}),
              b = loops.add_vertex({4, 0});
    const int c = loops.add_vertex({4, 4}), d = loops.add_vertex({0, 4});
    const int e = loops.add_vertex({3, 1}), f = loops.add_vertex({1, 1});
    loops.vertices[static_cast<std::size_t>(at)].tolerance = tolerance;
    const auto line = [&](const Vec2& from, const Vec2& to, int start, int end) {
      return loops.coedge(planar_line(from, to, {0, distance(from, to)}), start, end);
    };
    loops.loops.push_back({line({0, 0}, {2, 0}, a, at), line({2, 0}, {4, 0}, at, b),
                           line({4, 0}, {4, 4}, b, c), line({4, 4}, {0, 4}, c, d),
                           line({0, 4}, {0, 0}, d, a)});
    loops.loops.push_back({line({2, -off}, {1, 1}, at, f), line({1, 1}, {3, 1}, f, e),
                           line({3, 1}, {2, -off}, e, at)});
    SurfaceChart chart = plane_chart();
    chart.scale = {scale, scale};
    const auto trims = trims_of(chart, loops.vertices, loops.loops);
    ASSERT_TRUE(trims);
    const auto corner = [&](int loop, int coedge) {
      return trims->corners[static_cast<std::size_t>(
          trims->loops[static_cast<std::size_t>(loop)][static_cast<std::size_t>(coedge)].from)];
    };
    EXPECT_EQ(corner(0, 1), corner(1, 0));
    EXPECT_NE(corner(0, 1), corner(1, 1));
    EXPECT_LE(trims->largest_gap, 2 * off);
  }
}

TEST(TrimsOf, ACircleOvershootByTheCircleAndNotByItsControlPoints) {
  for (const auto& [half, wanted] : {std::pair{1.0, 0.0}, {0.9, 0.1}}) {
    FlatLoops loops;
    const int vertex = loops.add_vertex({std::sqrt(0.5), std::sqrt(0.5)});
    loops.loops.push_back(
        {loops.coedge(testing::quarters_of_circle({0, 0}, 1, 1, 4, pi / 4), vertex, vertex)});
    SurfaceChart chart = plane_chart();
    chart.bounds = {{-half, -half}, {half, half}};
    const auto trims = trims_of(chart, loops.vertices, loops.loops);
    ASSERT_TRUE(trims);
    EXPECT_NEAR(trims->overshoot, wanted, 1e-7);
  }
}

// Pieces of a curve end in one point but for roundings; nothing goes through between them.
TEST(IsInside, HoldsAtHeightsWherePiecesOfACurveEnd) {
  for (int turn = 0; turn < 200; ++turn) {
    FlatLoops loops;
    const double from = 0.031 * turn;
    PlanarCurve circle = testing::quarters_of_circle({0, 0}, 1, 1, 4, from);
    for (std::size_t k = 0; k < circle.spans.size(); ++k)
      for (Vec3& pole : circle.spans[k].curve.points)
        pole = (1 + 0.3 * static_cast<double>(k)) * pole;
    const int vertex = loops.add_vertex({std::cos(from), std::sin(from)});
    loops.loops.push_back({loops.coedge(circle, vertex, vertex)});
    SurfaceChart chart = plane_chart();
    chart.bounds = {{-4, -4}, {4, 4}};
    const auto trims = trims_of(chart, loops.vertices, loops.loops);
    ASSERT_TRUE(trims);
    for (const PlanarSpan& span : circle.spans)
      for (const Vec3& end : {span.curve.points.front(), span.curve.points.back()})
        EXPECT_FALSE(is_inside(*trims, {-1.001, projected(end)[1]})) << "turned by " << from;
  }
}

TEST(BorderAt, IsTheVertexOrElseTheEdge) {
  const FaceTrims trims = square_without_disc();
  EXPECT_EQ(border_at(trims, {4, 4}).value().vertex, 2);
  const auto side = border_at(trims, {4, 1});
  ASSERT_TRUE(side);
  EXPECT_EQ(side->vertex, -1);
  EXPECT_EQ(side->coedge->edge, 1);
  EXPECT_FALSE(border_at(trims, {1, 0.5}));
}

TEST(ChartRegion, AgreesWithWhatIsInside) {
  const FaceTrims trims = square_without_disc();
  const ChartRegion region(trims);
  int near = 0;
  for (int i = 0; i < 50; ++i)
    for (int k = 0; k < 50; ++k) {
      const Vec2 point{0.013 + 0.0797 * i, 0.007 + 0.0797 * k};
      const ChartRegion::Place place = region.place(point);
      if (place == ChartRegion::Place::Near)
        ++near;
      else
        EXPECT_EQ(place == ChartRegion::Place::Inside, is_inside(trims, point));
    }
  EXPECT_GT(near, 0);
  EXPECT_LT(near, 1000);
}

TEST(PartSide, TellsWhereARectangleLies) {
  const FaceTrims trims = square_without_disc();
  EXPECT_EQ(part_side(trims, {0.1, 0.9}, {0.1, 0.9}), PartSide::Inside);
  EXPECT_EQ(part_side(trims, {1.5, 2.5}, {1.5, 2.5}), PartSide::Outside);
  EXPECT_EQ(part_side(trims, {0.5, 2}, {0.5, 2}), PartSide::Mixed);
  EXPECT_EQ(part_side(trims, {0, 4}, {0, 4}), PartSide::Mixed);
  EXPECT_EQ(part_side(trims, {4.5, 5}, {1, 2}), PartSide::Outside);
  // In the hole, though no corner of it is far from the wire.
  EXPECT_EQ(part_side(trims, {1.3, 2.7}, {1.3, 2.7}), PartSide::Outside);
  EXPECT_EQ(part_side(trims, {1.29, 2.71}, {1.29, 2.71}), PartSide::Mixed);
}

// The arc is one span, whose pieces' boxes reach much farther off it.
TEST(PartSide, TellsPointsCloseToACurvedWire) {
  const FaceTrims trims = square_without_disc();
  for (int i = 0; i < 40; ++i) {
    const Vec2 out{std::cos(0.1 + i), std::sin(0.1 + i)};
    const auto side = [&](double radius) {
      const Vec2 at = Vec2{2, 2} + radius * out;
      return part_side(trims, {at[0], at[0]}, {at[1], at[1]});
    };
    EXPECT_EQ(side(1 + 1e-5), PartSide::Inside);
    EXPECT_EQ(side(1), PartSide::Mixed);
    EXPECT_EQ(side(1 - 1e-5), PartSide::Outside);
  }
}

}  // namespace
}  // namespace blossom
