// SPDX-License-Identifier: LGPL-2.1-or-later
// On which side of solid tools the pieces of whole parts lie, beside what closed forms say.

#include "adapters/occt/trim.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Fuse.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/faces/point_inside.h"
#include "adapters/occt/intersection_edges.h"
#include "tests/adapters/occt/solids/random_solids.h"
#include "tests/support/random.h"

namespace blossom::occt {
namespace {

using testing::SimpleSolid;

std::vector<PartFace> part_of(const SimpleSolid& solid) {
  std::vector<PartFace> part;
  for (const TopoDS_Face& face : faces_of(solid.shape()))
    part.push_back({static_cast<int>(part.size()) + 1, face});
  return part;
}

void expect_true_sides(const TrimResult& found, const SimpleSolid& first, const SimpleSolid& second,
                       const std::string& words) {
  double area = 0, whole = 0;
  for (const auto& [face, size] : found.areas) whole += size;
  for (const TrimPiece& piece : found.pieces) {
    area += piece.area;
    EXPECT_NE(piece.side, PieceSide::Unknown) << words << ", piece " << piece.number;
    const std::optional<gp_Pnt> point = point_inside(piece.shape);
    if (!point || (piece.side != PieceSide::Inside && piece.side != PieceSide::Outside)) continue;
    const bool inside = first.holds(vec(*point)) || second.holds(vec(*point));
    EXPECT_EQ(piece.side == PieceSide::Inside, inside)
        << words << ", piece " << piece.number << " of " << piece.area;
  }
  EXPECT_NEAR(area, whole, 1e-6 * whole) << words;
}

TEST(TrimBySolids, GivesPiecesTheirTrueSides) {
  testing::Random random(71);
  for (int i = 0; i < 200; ++i) {
    const SimpleSolid part = testing::random_tool(random), first = testing::random_tool(random),
                      second = testing::random_tool(random);
    const TopoDS_Shape tool = BRepAlgoAPI_Fuse(first.shape(), second.shape()).Shape();
    expect_true_sides(
        trim(part_of(part), {trim_tool(tool)}, {.keep = Keep::Inside, .intersection = {}}), first,
        second, part.words() + " by " + first.words() + " and " + second.words());
  }
}

TEST(TrimBySolids, TakesWhatIsInsideOfAnyTool) {
  testing::Random random(8);
  for (int i = 0; i < 20; ++i) {
    const SimpleSolid part = testing::random_tool(random), first = testing::random_tool(random),
                      second = testing::random_tool(random);
    expect_true_sides(trim(part_of(part), {trim_tool(first.shape()), trim_tool(second.shape())},
                           {.keep = Keep::Outside, .intersection = {}}),
                      first, second, part.words() + " by " + first.words() + ", " + second.words());
  }
}

}  // namespace
}  // namespace blossom::occt
