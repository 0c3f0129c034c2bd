// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/narrowed_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/solid_trim.h"
#include "adapters/occt/soundness.h"

namespace blossom::occt {
namespace {

double largest_of_vertices(const TopoDS_Shape& shape) {
  double largest = 0;
  for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())));
  return largest;
}

void widen(const TopoDS_Shape& shape, double tolerance) {
  for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next())
    BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), tolerance);
}

bool has_sound_wires(const TopoDS_Shape& shape) {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (!wire_problems(TopoDS::Face(it.Current())).empty()) return false;
  return true;
}

// The base of the cone lies in a plane that touches the cylinder along its seam, and the base's
// rim touches both rims of the cylinder where they meet that: the cut leaves each of them there by
// the square of the way, and is known to some 1e-8.
TEST(NarrowedVertices, CoverNoMoreThanWhatEndsWhereACutTouchesRims) {
  const TrimTool cylinder = trim_tool(BRepPrimAPI_MakeCylinder(3, 6).Shape());
  const TrimTool cone =
      trim_tool(BRepPrimAPI_MakeCone(gp_Ax2({-3, 0, 3}, gp::DX()), 3, 1.5, 3).Shape());
  for (const SolidOperation operation :
       {SolidOperation::Cut, SolidOperation::Common, SolidOperation::Fuse}) {
    const SolidTrimResult made = trim_solids(cylinder, {cone}, operation);
    ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
    const TopoDS_Shape shape = compound_of(made.solids);
    EXPECT_LT(largest_of_vertices(shape), 1e-5);
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
    EXPECT_TRUE(has_sound_wires(shape));
  }
}

TEST(NarrowedVertices, StateWhatTheyNeed) {
  const TrimTool box = trim_tool(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  widen(box.solids.front(), 1e-3);
  narrow_vertices(box.solids, {});
  EXPECT_DOUBLE_EQ(largest_of_vertices(box.solids.front()), 1e-7);
}

TEST(NarrowedVertices, StayAsWideAsTheirEdgesAre) {
  const TrimTool box = trim_tool(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  widen(box.solids.front(), 1e-3);
  for (TopExp_Explorer it(box.solids.front(), TopAbs_EDGE); it.More(); it.Next())
    BRep_Builder().UpdateEdge(TopoDS::Edge(it.Current()), 2e-4);
  narrow_vertices(box.solids, {&box});
  EXPECT_DOUBLE_EQ(largest_of_vertices(box.solids.front()), 1e-3);
}

}  // namespace
}  // namespace blossom::occt
