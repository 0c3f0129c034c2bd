// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/edges/edge_union.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Pln.hxx>

namespace blossom::occt {
namespace {

constexpr double kSpeck = 1e-6;  // the size of what lies in one vertex

// A triangle in the plane z = 0 with its right angle in a point.
struct Triangle {
  Triangle(double x, double y, double size)
      : corners{BRepBuilderAPI_MakeVertex({x, y, 0}), BRepBuilderAPI_MakeVertex({x + size, y, 0}),
                BRepBuilderAPI_MakeVertex({x, y + size, 0})} {
    BRepBuilderAPI_MakeWire made;
    for (std::size_t i = 0; i < 3; ++i)
      made.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[(i + 1) % 3]));
    wire = made.Wire();
  }

  void join_corners(EdgeUnion& joined) const {
    joined.join(corners[0], corners[1]);
    joined.join(corners[0], corners[2]);
  }

  std::array<TopoDS_Vertex, 3> corners;
  TopoDS_Wire wire;
};

int wire_count(const TopoDS_Face& face) {
  int count = 0;
  for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next()) ++count;
  return count;
}

TEST(EdgeUnion, CountsAHoleThatLiesInOneVertex) {
  const Triangle border(0, 0, 10), hole(1, 1, kSpeck);
  BRepBuilderAPI_MakeFace made(gp_Pln(gp::XOY()), border.wire);
  made.Add(TopoDS::Wire(hole.wire.Reversed()));
  EdgeUnion joined;
  hole.join_corners(joined);
  const TopoDS_Face face = joined.rebuilt(made.Face());
  ASSERT_FALSE(face.IsNull());
  EXPECT_EQ(wire_count(face), 1);
  EXPECT_EQ(joined.lost_wires(), 1);
  EXPECT_EQ(joined.collapsed(), 0);
}

TEST(EdgeUnion, LeavesNothingOfAFaceThatLiesInOneVertex) {
  const Triangle speck(1, 1, kSpeck);
  EdgeUnion joined;
  speck.join_corners(joined);
  EXPECT_TRUE(joined.rebuilt(BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), speck.wire)).IsNull());
  EXPECT_EQ(joined.lost_wires(), 1);
}

// Both edges of the corner that moved are half in its ball then.
TEST(EdgeUnion, CountsEdgesThatAreHalfInAVertexOfTheirs) {
  for (const auto& [away, count] : {std::pair{1., 0}, {4.9, 0}, {6., 2}}) {
    const Triangle border(0, 0, 10);
    EdgeUnion joined;
    joined.join(border.corners[0], BRepBuilderAPI_MakeVertex({0, 0, away}));
    joined.rebuilt(BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), border.wire));
    EXPECT_EQ(joined.swallowed(), count) << away;
    EXPECT_EQ(joined.collapsed(), 0);
  }
}

TEST(EdgeUnion, KeepsAFaceOfWhichNothingIsJoined) {
  const TopoDS_Face face =
      BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), Triangle(0, 0, 10).wire).Face();
  EdgeUnion joined;
  EXPECT_TRUE(joined.rebuilt(face).IsEqual(face));
  EXPECT_EQ(joined.lost_wires(), 0);
}

}  // namespace
}  // namespace blossom::occt
