// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/simple_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/support/flat_trims.h"

namespace blossom::testing {
namespace {

constexpr double kMargin = 1e-8;
constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

bool are_simple(const FaceTrims& trims) { return nesting_of(trims, kMargin) == Nesting::Sound; }

bool are_simple(FlatLoops loops) { return are_simple(trims_of(std::move(loops))); }

FlatLoops flat_polygon(const std::vector<Vec2>& corners, double gap = 0) {
  FlatLoops loops;
  loops.add_polygon(corners, gap);
  return loops;
}

FlatLoops square_with_hole(const std::vector<Vec2>& hole) {
  FlatLoops loops;
  loops.add_polygon(kSquare4);
  loops.add_polygon(hole);
  return loops;
}

TEST(SimpleLoops, AreThoseOfOrdinaryFaces) {
  EXPECT_TRUE(are_simple(square_without_disc()));
  EXPECT_TRUE(are_simple(half_disc()));
  EXPECT_TRUE(are_simple(square_with_hole({{1, 1}, {1, 2}, {2, 2}, {2, 1}})));
}

// Of loops that are apart, holes outside of the loop round the face or within each other.
TEST(SimpleLoops, TellHolesThatGoAstray) {
  const auto nesting = [](std::vector<std::vector<Vec2>> polygons) {
    FlatLoops loops;
    for (const std::vector<Vec2>& polygon : polygons) loops.add_polygon(polygon);
    return nesting_of(trims_of(std::move(loops)), kMargin);
  };
  const std::vector<Vec2> hole{{1, 1}, {1, 3}, {3, 3}, {3, 1}}, beside{{5, 1}, {5, 2}, {6, 2}},
      within{{1.5, 1.5}, {1.5, 2}, {2, 2}}, around{{-1, -1}, {-1, 5}, {5, 5}, {5, -1}},
      across{{3, 1}, {3, 2}, {5, 2}, {5, 1}}, other{{5, 1}, {6, 1}, {6, 2}};
  EXPECT_EQ(nesting({kSquare4, hole}), Nesting::Sound);
  EXPECT_EQ(nesting({kSquare4, beside}), Nesting::HoleAstray);
  EXPECT_EQ(nesting({kSquare4, around}), Nesting::HoleAstray);
  EXPECT_EQ(nesting({kSquare4, hole, within}), Nesting::HoleAstray);
  EXPECT_EQ(nesting({kSquare4, across}), Nesting::InDoubt);
  EXPECT_EQ(nesting({kSquare4, other}), Nesting::InDoubt);
  EXPECT_EQ(nesting({hole}), Nesting::InDoubt);
}

TEST(SimpleLoops, MayHaveGapsThatVerticesCover) {
  FlatLoops covered, open;
  covered.add_polygon(kSquare4, 1e-3);
  for (FaceVertex& vertex : covered.vertices) vertex.tolerance = 1e-2;
  EXPECT_TRUE(are_simple(covered));
  open.add_polygon(kSquare4, 1e-3);
  for (FaceVertex& vertex : open.vertices) vertex.tolerance = 1e-4;
  EXPECT_FALSE(are_simple(open));
}

// The tip of the hole pokes through the way over the gap, between the ends of two sides.
TEST(SimpleLoops, DoNotMeetOverTheirGaps) {
  for (const bool meets : {false, true}) {
    FlatLoops loops = flat_polygon(kSquare4, 0.1);
    for (FaceVertex& vertex : loops.vertices) vertex.tolerance = 2;
    loops.add_polygon({{2, 1}, {3, 2}, meets ? Vec2{3.97, 0.03} : Vec2{3.5, 0.5}});
    EXPECT_EQ(are_simple(loops), !meets);
  }
}

const std::vector<Vec2> kBow{{0, 2}, {4, 0}, {4, 4}, {0, 0}};  // its larger half runs to the left
const std::vector<Vec2> kNoBow{{0, 2}, {0, 0}, {4, 0}, {4, 4}};

TEST(SimpleLoops, DoNotCrossThemselves) {
  EXPECT_FALSE(are_simple(flat_polygon(kBow)));
  EXPECT_TRUE(are_simple(flat_polygon(kNoBow)));
  EXPECT_FALSE(
      are_simple(flat_polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})));  // corner on a side
  EXPECT_TRUE(are_simple(flat_polygon({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}})));
}

// Between a curve from the origin to (4, 0) and the x-axis.
FlatLoops below_axis(const Vec2& second, const Vec2& third) {
  FlatLoops loops;
  const int left = loops.add_vertex({0, 0}), right = loops.add_vertex({4, 0});
  const PlanarBezier curve{
      {{0, 0, 1}, {second[0], second[1], 1}, {third[0], third[1], 1}, {4, 0, 1}}};
  loops.loops.push_back({loops.coedge(PlanarCurve{{{curve, {0, 1}}}}, left, right),
                         loops.coedge(planar_line({4, 0}, {0, 0}, {0, 4}), right, left)});
  return loops;
}

TEST(SimpleLoops, HaveNoCurveThatCrossesItself) {
  EXPECT_FALSE(are_simple(below_axis({12, 6}, {-8, 6})));  // its knot runs to the left
  EXPECT_TRUE(are_simple(below_axis({0, -6}, {4, -6})));
}

TEST(SimpleLoops, MayHaveCoedgesThatRunAgainstTheirCurves) {
  for (std::size_t turned = 0; turned < 4; ++turned)
    for (const auto& corners : {kBow, kNoBow}) {
      FlatLoops loops = flat_polygon(corners);
      Coedge& coedge = loops.loops.front()[turned];
      coedge.reversed = true;
      std::ranges::reverse(coedge.curve.spans.front().curve.points);
      EXPECT_EQ(are_simple(loops), corners == kNoBow);
    }
}

// x and y are four times and a quarter of the parameters. What a vertex covers is in space.
TEST(SimpleLoops, MayHaveParametersThatAreNoLengths) {
  SurfaceChart chart = plane_chart();
  chart.scale = {4, 0.25};
  chart.jet = [](const Vec2& uv) {
    return SurfaceJet{{4 * uv[0], 0.25 * uv[1], 0}, {4, 0, 0}, {0, 0.25, 0}};
  };
  for (const double tolerance : {1e-2, 1e-3}) {
    FlatLoops loops = flat_polygon(kSquare4, 1e-3);
    for (FaceVertex& vertex : loops.vertices) vertex.tolerance = tolerance;
    for (Coedge& coedge : loops.loops.front())
      coedge.curve = transformed(std::move(coedge.curve), {0.25, 4}, {});
    const auto trims = blossom::trims_of(chart, loops.vertices, loops.loops);
    ASSERT_TRUE(trims);
    EXPECT_EQ(are_simple(*trims), tolerance == 1e-2);
  }
}

// The northern half of a ball, whose loop runs along the meridian 0 on both sides.
TEST(SimpleLoops, MayRunAlongASeamAndThroughAPole) {
  constexpr double kTurn = 4 * kQuarterTurn, kPole = kQuarterTurn;
  SurfaceChart chart = plane_chart();
  chart.period = {kTurn, 0};
  chart.jet = [](const Vec2& uv) {
    const double cu = std::cos(uv[0]), su = std::sin(uv[0]), cv = std::cos(uv[1]),
                 sv = std::sin(uv[1]);
    return SurfaceJet{{cu * cv, su * cv, sv}, {-su * cv, cu * cv, 0}, {-cu * sv, -su * sv, cv}};
  };
  for (const double height : {1.0, 1.1}) {
    FlatLoops loops;
    const int equator = loops.add_vertex({1, 0}), pole = loops.add_vertex({0, 0});
    loops.vertices.back().point[2] = height;
    const auto line = [&](const Vec2& from, const Vec2& to, int start, int end) {
      return loops.coedge(planar_line(from, to, {0, distance(from, to)}), start, end);
    };
    std::vector<Coedge> loop{
        line({0, 0}, {kTurn, 0}, equator, equator), line({kTurn, 0}, {kTurn, kPole}, equator, pole),
        line({kTurn, kPole}, {0, kPole}, pole, pole), line({0, kPole}, {0, 0}, pole, equator)};
    loop[2].degenerated = true;
    const auto trims = blossom::trims_of(chart, loops.vertices, {loop});
    ASSERT_TRUE(trims);
    EXPECT_EQ(are_simple(*trims), height == 1.0);
  }
}

// Where both derivatives are 0 they say nothing of what lies beside: here of a gap of 1e-3.
TEST(SimpleLoops, AreInDoubtOfGapsWhereTheChartStandsStill) {
  SurfaceChart chart = plane_chart();
  chart.jet = [](const Vec2& uv) {
    const double u = uv[0], v = uv[1];
    return SurfaceJet{{u * u * u, v * v * v, 0}, {3 * u * u, 0, 0}, {0, 3 * v * v, 0}};
  };
  for (const double gap : {0.0, 0.1}) {
    FlatLoops loops = flat_polygon({{0, 1}, {0, 0}, {1, 0}, {1, 1}});
    loops.loops.front().front().curve = planar_line({0, 1}, {0, gap}, {0, 1 - gap});
    const auto trims = blossom::trims_of(chart, loops.vertices, loops.loops);
    ASSERT_TRUE(trims);
    EXPECT_EQ(are_simple(*trims), gap == 0);
    for (FaceVertex& vertex : loops.vertices) vertex.tolerance = 0.5;
    EXPECT_TRUE(are_simple(loops));  // of a plane chart
  }
}

// A strip along a quarter of a circle: too narrow a one takes too many pieces.
TEST(SimpleLoops, AreInDoubtWhereTheyRunBesideEachOtherForLong) {
  for (const double width : {1e-2, 3e-8}) {
    const double inner = 1 - width;
    FlatLoops loops;
    const int a = loops.add_vertex({1, 0}), b = loops.add_vertex({0, 1}),
              c = loops.add_vertex({0, inner}), d = loops.add_vertex({inner, 0});
    loops.loops.push_back(
        {loops.coedge(quarters_of_circle({0, 0}, 1, 1, 1), a, b),
         loops.coedge(planar_line({0, 1}, {0, inner}, {0, width}), b, c),
         loops.coedge(quarters_of_circle({0, 0}, inner, -1, 1, kQuarterTurn), c, d),
         loops.coedge(planar_line({inner, 0}, {1, 0}, {0, width}), d, a)});
    EXPECT_EQ(are_simple(loops), width == 1e-2);
  }
}

TEST(SimpleLoops, AreOneRoundAllOthers) {
  EXPECT_FALSE(are_simple(square_with_hole({{3, 1}, {3, 2}, {5, 2}, {5, 1}})));  // across
  EXPECT_FALSE(are_simple(square_with_hole({{6, 1}, {6, 2}, {7, 2}, {7, 1}})));  // beside
  EXPECT_FALSE(are_simple(square_with_hole({{1, 1}, {2, 1}, {2, 2}, {1, 2}})));  // the wrong way
  FlatLoops nested = square_with_hole({{1, 1}, {1, 3}, {3, 3}, {3, 1}});
  nested.add_polygon({{1.5, 1.5}, {1.5, 2}, {2, 2}, {2, 1.5}});
  EXPECT_FALSE(are_simple(nested));
  FlatLoops inside_out;
  inside_out.add_polygon({{0, 0}, {0, 4}, {4, 4}, {4, 0}});
  EXPECT_FALSE(are_simple(inside_out));
}

// Between an arc that reaches the origin along the x-axis, and a line from there to (2, y).
FlatLoops below_arc(double y) {
  FlatLoops loops;
  const int origin = loops.add_vertex({0, 0}), low = loops.add_vertex({2, y}),
            top = loops.add_vertex({2, 2}), end = loops.add_vertex({1, 1});
  loops.loops.push_back({loops.coedge(planar_line({0, 0}, {2, y}, {0, 2}), origin, low),
                         loops.coedge(planar_line({2, y}, {2, 2}, {0, 2}), low, top),
                         loops.coedge(planar_line({2, 2}, {1, 1}, {0, 1}), top, end),
                         loops.coedge(quarters_of_circle({0, 1}, 1, -1, 1), end, origin)});
  return loops;
}

// Nothing is said of curves that leave a corner in one direction: they may cross beside it.
TEST(SimpleLoops, AreInDoubtWhereTheyTouchInACorner) {
  EXPECT_FALSE(are_simple(below_arc(0)));
  EXPECT_TRUE(are_simple(below_arc(-1)));
}

}  // namespace
}  // namespace blossom::testing
