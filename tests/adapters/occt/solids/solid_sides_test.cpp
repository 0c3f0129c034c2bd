// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/solid_sides.h"
#include "adapters/occt/faces/point_inside.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>

namespace blossom::occt {
namespace {

// The faces of boxes, which no curves cross.
SplitSolid faces_as_pieces(const char* name, const TrimTool& box, const std::vector<int>& faces) {
  SplitSolid solid{name, &box, {}, {}};
  for (const int face : faces)
    solid.pieces.push_back({box.faces[static_cast<std::size_t>(face)], face});
  return solid;
}

// Its faces are those at x = low and high, then y, then z.
TrimTool box_tool(const gp_Pnt& low, const gp_Pnt& high) {
  return trim_tool(BRepPrimAPI_MakeBox(low, high).Shape());
}

TEST(SolidSides, AreThoseThatRaysFromOnePieceAgreeOnWhereTheOtherHasNone) {
  const TrimTool small = box_tool({1, 1, 5}, {3, 3, 15});
  const std::optional<gp_Pnt> on_wall = point_inside(small.faces[0]);
  ASSERT_TRUE(on_wall);
  // Where rays from a wall start the large box ends, so that none of them is certain.
  const TrimTool large = box_tool({0, 0, 0}, {10, 10, on_wall->Z()});
  SplitSolid b = faces_as_pieces("tool", large, {});
  for (const std::vector<int>& faces : {std::vector{4}, std::vector{4, 0}, std::vector{0, 4}}) {
    SplitSolid a = faces_as_pieces("part", small, faces);
    const std::vector<std::string> obstacles = find_sides(a, b, {}, 1e-7).obstacles;
    EXPECT_TRUE(obstacles.empty()) << obstacles.front();
    for (const SolidPiece& piece : a.pieces) EXPECT_EQ(piece.side, SolidSide::Inside);
  }
  SplitSolid walls = faces_as_pieces("part", small, {0, 2});
  const std::vector<std::string> obstacles = find_sides(walls, b, {}, 1e-7).obstacles;
  ASSERT_EQ(obstacles.size(), 1u);
  EXPECT_NE(obstacles.front().find("rays cannot tell"), std::string::npos) << obstacles.front();
}

}  // namespace
}  // namespace blossom::occt
