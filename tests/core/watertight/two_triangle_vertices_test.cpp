// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/two_triangle_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <variant>
#include <vector>

#include "core/blossom/triangle_composition.h"
#include "core/forms/algebra/de_casteljau.h"

namespace blossom {
namespace {

constexpr double kRounding = 1e-15;

// Corners 0 (the tip), 1, 2; 3 is behind the side from 1 to 2 above, 4 behind that below.
const std::vector<Vec3> kVertices{{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {3, 0, 1}, {3, 0, -1}};

// A triangle of degree 2 that bulges upwards by so much.
WatertightPiece bulging(std::array<int, 3> corners, double height) {
  BezierTriangle form{2, {}};
  const auto at = [&](std::size_t k) { return kVertices[static_cast<std::size_t>(corners[k])]; };
  for (int nu = 0; nu <= 2; ++nu)
    for (int mu = 0; nu + mu <= 2; ++mu) {
      const bool is_corner = nu == 2 || mu == 2 || nu + mu == 0;
      form.points.push_back(0.5 * (nu * at(0) + mu * at(1) + (2 - nu - mu) * at(2)) +
                            Vec3{0, 0, is_corner ? 0 : height});
    }
  return {0, form, {corners.begin(), corners.end()}, {}, {}, 0};
}

// Two triangles with a common tip on an edge, and one behind each.
WatertightPieces lens() {
  WatertightPieces pieces;
  pieces.vertices = kVertices;
  pieces.pieces = {bulging({1, 2, 0}, 0.1), bulging({0, 2, 1}, -0.2), bulging({2, 1, 3}, 0.1),
                   bulging({4, 1, 2}, -0.2)};
  const auto side = [&](std::size_t piece, int k, int edge, int from, int to) {
    pieces.sides.push_back(
        {edge, from, to,
         side_of(std::get<BezierTriangle>(pieces.pieces[piece].form), k, (k + 1) % 3)});
  };
  side(0, 1, 0, 2, 0);
  side(0, 2, 0, 0, 1);
  side(0, 0, -1, 1, 2);  // above
  side(1, 1, -1, 2, 1);  // below
  side(2, 1, 1, 1, 3);
  side(2, 2, 1, 3, 2);
  side(3, 0, 1, 4, 1);
  side(3, 2, 1, 2, 4);
  pieces.pieces[0].sides = {2, 0, 1};
  pieces.pieces[1].sides = {0, 3, 1};
  pieces.pieces[2].sides = {2, 4, 5};
  pieces.pieces[3].sides = {6, 3, 7};
  return pieces;
}

int count_at(const WatertightPieces& pieces, int vertex) {
  int count = 0;
  for (const WatertightPiece& piece : pieces.pieces)
    count += static_cast<int>(std::ranges::count(piece.vertices, vertex));
  return count;
}

TEST(ClosedTips, AreOpenedByHalvingOneTriangleAndTheOneBehind) {
  const WatertightPieces given = lens();
  WatertightPieces pieces = given;
  divide_two_triangle_vertices(pieces);
  EXPECT_EQ(count_at(pieces, 0), 3);
  ASSERT_EQ(pieces.pieces.size(), 6u);
  ASSERT_EQ(pieces.vertices.size(), 6u);
  EXPECT_LE(distance(pieces.vertices.back(), point_at(given.sides[2].curve, 0.5)), kRounding);
  const auto& whole = std::get<BezierTriangle>(given.pieces[0].form);
  const auto& half = std::get<BezierTriangle>(pieces.pieces[0].form);
  EXPECT_LE(distance(point_at(half, 0.25, 0.5), point_at(whole, 0.5, 0.25)), kRounding);
}

TEST(ClosedTips, LeaveWholeSidesBetweenTheirVertices) {
  WatertightPieces pieces = lens();
  divide_two_triangle_vertices(pieces);
  std::map<int, int> uses;
  for (const WatertightPiece& piece : pieces.pieces)
    for (std::size_t k = 0; k < 3; ++k) {
      ++uses[piece.sides[k]];
      const WatertightSide& side = pieces.sides[static_cast<std::size_t>(piece.sides[k])];
      const int from = piece.vertices[k], to = piece.vertices[(k + 1) % 3];
      EXPECT_TRUE((side.from == from && side.to == to) || (side.from == to && side.to == from));
      const BezierCurve own = side_of(std::get<BezierTriangle>(piece.form), static_cast<int>(k),
                                      static_cast<int>((k + 1) % 3));
      EXPECT_LE(distance(own.points.front(), pieces.vertices[static_cast<std::size_t>(from)]),
                kRounding);
      EXPECT_LE(
          distance(side.curve.points.front(), pieces.vertices[static_cast<std::size_t>(side.from)]),
          kRounding);
      EXPECT_LE(
          distance(side.curve.points.back(), pieces.vertices[static_cast<std::size_t>(side.to)]),
          kRounding);
    }
  for (const auto& [side, count] : uses) EXPECT_EQ(count, side >= 4 && side <= 7 ? 1 : 2);
}

TEST(ClosedTips, StayWhereEdgesAreBehind) {
  WatertightPieces pieces = lens();
  pieces.sides[2].edge = pieces.sides[3].edge = 2;
  divide_two_triangle_vertices(pieces);
  EXPECT_EQ(pieces.pieces.size(), 4u);
}

// The faces above and below have a border of two edges in common, and a chord over both.
WatertightPieces two_faces() {
  WatertightPieces pieces = lens();
  pieces.pieces[1].face = pieces.pieces[3].face = 1;
  return pieces;
}

TEST(FacingChords, AreDividedInTheFaceThatLeavesThemMore) {
  const WatertightPieces given = two_faces();
  WatertightPieces pieces = given;
  divide_facing_chords(pieces);
  ASSERT_EQ(pieces.pieces.size(), 6u);
  ASSERT_EQ(pieces.vertices.size(), 6u);
  EXPECT_LE(distance(pieces.vertices.back(), point_at(given.sides[3].curve, 0.5)), kRounding);
  EXPECT_EQ(count_at(pieces, 0), 3);
  EXPECT_EQ(count_at(pieces, 5), 4);
  for (const WatertightPiece& piece : pieces.pieces)
    EXPECT_EQ(piece.face == 1, std::ranges::count(piece.vertices, 5) == 1);
}

TEST(FacingChords, StayWhereTheOtherFaceHasNone) {
  WatertightPieces pieces = two_faces();
  pieces.sides[3].edge = 2;
  divide_facing_chords(pieces);
  EXPECT_EQ(pieces.pieces.size(), 4u);
}

// Halves of it would have two sides with the same ends again.
TEST(FacingChords, StayBesideATriangleAtAPole) {
  WatertightPieces pieces = two_faces();
  pieces.sides[6].curve.points.clear();
  pieces.sides[7].curve.points.clear();
  divide_facing_chords(pieces);
  EXPECT_EQ(pieces.pieces.size(), 4u);
}

TEST(FacingChords, StayInsideOfATriangle) {
  WatertightPieces pieces = two_faces();
  pieces.sides.push_back({2, 2, 1, pieces.sides[3].curve});
  pieces.pieces[1].sides = {0, 8, 1};
  pieces.pieces[3] = bulging({1, 2, 1}, -0.2);
  pieces.pieces[3].face = 1;
  pieces.pieces[3].sides = {3, 3, 7};
  divide_facing_chords(pieces);
  EXPECT_EQ(pieces.pieces.size(), 4u);
}

TEST(FacingChords, StayOverOtherStretches) {
  WatertightPieces pieces = two_faces();
  pieces.sides[0].edge = -1;  // the faces have one edge in common, and no chord is over that alone
  divide_facing_chords(pieces);
  EXPECT_EQ(pieces.pieces.size(), 4u);
}

}  // namespace
}  // namespace blossom
