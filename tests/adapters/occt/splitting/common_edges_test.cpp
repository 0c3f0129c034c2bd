// SPDX-License-Identifier: LGPL-2.1-or-later
// Which edges lie in faces of the other shape, where some of them are known to be equal.
#include "adapters/occt/splitting/common_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"

namespace blossom::occt {
namespace {

// Cubes that touch along the line x = y = 1, where each has an edge of its own.
TopoDS_Shape touching_cubes() {
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1)).Shape());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 0), gp_Pnt(2, 2, 1)).Shape());
  return both;
}

bool is_where_cubes_touch(const TopoDS_Edge& edge) {
  const RangedCurve of = curve_of(edge);
  return of.curve->Value(at(of.range, 0.5)).Distance(gp_Pnt(1, 1, 0.5)) < 1e-9;
}

// How often an edge of a shape where the cubes touch lies in a face of another one.
std::size_t coincident_where_cubes_touch(const TopoDS_Shape& shape, const TopoDS_Shape& other) {
  const std::vector<TopoDS_Face> a = faces_of(shape), b = faces_of(other);
  const ShapeIntersection found = intersect(a, b);
  EXPECT_TRUE(std::ranges::any_of(
      found.pairs, [](const FaceIntersection& pair) { return !pair.equal_edges.empty(); }));
  CommonEdges common(a, b, {});
  common.know_equal(found);
  for (const FaceIntersection& pair : found.pairs) common.add(pair);
  std::size_t count = 0;
  for (const std::vector<TopoDS_Edge>& lying : common.in_b())
    count += static_cast<std::size_t>(std::ranges::count_if(lying, is_where_cubes_touch));
  return count;
}

// The edge is equal to that of one cube, and lies in two faces of the other, too.
TEST(CommonEdges, WithAnEqualLieInAllFacesThatTouchIt) {
  const TopoDS_Shape bar = BRepPrimAPI_MakeBox(gp_Pnt(-1, 0, 0), gp_Pnt(1, 1, 1)).Shape();
  EXPECT_EQ(coincident_where_cubes_touch(bar, touching_cubes()), 4u);
}

// Each in the two faces that have its equal: what touches itself stays as it is.
TEST(CommonEdges, OfAShapeLieInTheirCopiesAlone) {
  const TopoDS_Shape cubes = touching_cubes();
  EXPECT_EQ(coincident_where_cubes_touch(cubes, BRepBuilderAPI_Copy(cubes).Shape()), 4u);
}

}  // namespace
}  // namespace blossom::occt
