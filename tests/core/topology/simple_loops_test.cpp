// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/simple_loops.h"

#include <gtest/gtest.h>

#include "tests/support/flat_trims.h"

namespace blossom::testing {
namespace {

constexpr double kMargin = 1e-8;

bool are_simple(FlatLoops loops) {
  return blossom::are_simple(trims_of(std::move(loops)), kMargin);
}

FlatLoops square_with_hole(const std::vector<Vec2>& hole) {
  FlatLoops loops;
  loops.add_polygon(kSquare4);
  loops.add_polygon(hole);
  return loops;
}

TEST(SimpleLoops, AreThoseOfOrdinaryFaces) {
  EXPECT_TRUE(blossom::are_simple(square_without_disc(), kMargin));
  EXPECT_TRUE(blossom::are_simple(half_disc(), kMargin));
  EXPECT_TRUE(are_simple(square_with_hole({{1, 1}, {1, 2}, {2, 2}, {2, 1}})));
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

TEST(SimpleLoops, DoNotCrossThemselves) {
  FlatLoops bow, touching;
  bow.add_polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  EXPECT_FALSE(are_simple(bow));
  touching.add_polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}});  // a corner on a side
  EXPECT_FALSE(are_simple(touching));
}

TEST(SimpleLoops, HaveNoCurveThatCrossesItself) {
  FlatLoops loops;
  const int left = loops.add_vertex({0, 0}), right = loops.add_vertex({4, 0});
  const PlanarBezier knot{{{4, 0, 1}, {-8, 6, 1}, {12, 6, 1}, {0, 0, 1}}};
  loops.loops.push_back({loops.coedge(planar_line({0, 0}, {4, 0}, {0, 4}), left, right),
                         loops.coedge(PlanarCurve{{{knot, {0, 1}}}}, right, left)});
  EXPECT_FALSE(are_simple(loops));
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

// Nothing is said of arcs that leave a corner in one direction: they may cross beside it.
TEST(SimpleLoops, AreInDoubtWhereTheyTouchInACorner) {
  FlatLoops loops;
  const int start = loops.add_vertex({0, 0}), end = loops.add_vertex({1, 1}),
            top = loops.add_vertex({0, 2});
  const PlanarCurve arc = quarters_of_circle({0, 1}, 1, 1, 1, -0.5 * 3.141592653589793);
  loops.loops.push_back({loops.coedge(arc, start, end),
                         loops.coedge(planar_line({1, 1}, {2, 2}, {0, 1}), end, top),
                         loops.coedge(planar_line({2, 2}, {2, 0}, {0, 1}), top, start),
                         loops.coedge(planar_line({2, 0}, {0, 0}, {0, 1}), start, start)});
  loops.vertices[2].point = {2, 2, 0};
  loops.loops[0][2].end = loops.loops[0][3].start = loops.add_vertex({2, 0});
  EXPECT_FALSE(are_simple(loops));
}

}  // namespace
}  // namespace blossom::testing
