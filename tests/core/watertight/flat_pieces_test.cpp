// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/flat_pieces.h"

#include <gtest/gtest.h>

#include "core/blossom/triangle_composition.h"

namespace blossom {
namespace {

constexpr double kWithin = 1e-7;
constexpr double kHeight = 1e-5;

// A quadratic triangle over (0, 0), (4, 0), (0, 3) of the plane z = x + y, whose side to the right
// bulges by so much; the middle of the lower side is so far off the plane.
WatertightPieces one_piece(double bulge, double off_plane) {
  const auto at = [](double x, double y) { return Vec3{x, y, x + y}; };
  const BezierTriangle form{2,
                            {at(0, 3), at(2 + bulge, 1.5 + bulge), at(4, 0), at(0, 1.5),
                             at(2, 0) + Vec3{0, 0, off_plane}, at(0, 0)}};
  WatertightPieces pieces;
  pieces.vertices = {form(2, 0), form(0, 2), form(0, 0)};
  pieces.pieces = {{0, form, {0, 1, 2}, {0, 1, 2}, {true, true, true}, 0}};
  for (int k = 0; k < 3; ++k)
    pieces.sides.push_back({-1, k, (k + 1) % 3, side_of(form, k, (k + 1) % 3)});
  return pieces;
}

std::optional<PiecePlane> plane_of(const WatertightPieces& pieces) {
  return plane_of(pieces, pieces.pieces.front(), kWithin, kHeight);
}

TEST(FlatPieces, HaveAPlaneInWhichTheyTurnCounterClockwise) {
  const WatertightPieces pieces = one_piece(0.5, 0);

  const auto plane = plane_of(pieces);

  ASSERT_TRUE(plane);
  EXPECT_LE(plane->error, 1e-15);
  EXPECT_NEAR(norm(plane->x), 1, 1e-15);
  EXPECT_NEAR(norm(plane->y), 1, 1e-15);
  EXPECT_NEAR(dot(plane->x, plane->y), 0, 1e-15);
  const Vec2 a = plane->at(pieces.vertices[0]), b = plane->at(pieces.vertices[1]),
             c = plane->at(pieces.vertices[2]);
  // Twice the area: 12 in x and y, times the root of 3 on the slope.
  EXPECT_NEAR((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 20.784609690826528,
              1e-13);
}

TEST(FlatPieces, StateHowFarTheyAreFromIt) {
  const auto plane = plane_of(one_piece(0.5, 5e-8));
  ASSERT_TRUE(plane);
  EXPECT_GT(plane->error, 1e-8);
  EXPECT_LE(plane->error, kWithin);
}

TEST(FlatPieces, AreNoneThatBendTurnOverOrAreTooNarrow) {
  EXPECT_FALSE(plane_of(one_piece(0.5, 1e-6)));
  EXPECT_FALSE(plane_of(one_piece(-3, 0)));
  const WatertightPieces pieces = one_piece(0.5, 0);
  EXPECT_TRUE(blossom::plane_of(pieces, pieces.pieces.front(), kWithin, 3));
  EXPECT_FALSE(blossom::plane_of(pieces, pieces.pieces.front(), kWithin, 5));
}

TEST(FlatPieces, AreNoneWhoseSidesAreElsewhere) {
  WatertightPieces pieces = one_piece(0.5, 0);
  pieces.sides[1].curve.points[1] += Vec3{0, 0, 1e-6};
  EXPECT_FALSE(plane_of(pieces));
}

}  // namespace
}  // namespace blossom
