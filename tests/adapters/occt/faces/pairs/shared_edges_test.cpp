// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/pairs/shared_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"

namespace blossom::occt {
namespace {

struct Neighbours {
  TopoDS_Face a, b;
  TopoDS_Edge edge;
};

std::vector<Neighbours> neighbours(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape map;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, map);
  std::vector<Neighbours> all;
  for (int i = 1; i <= map.Extent(); ++i)
    if (map(i).Extent() == 2 && !map(i).First().IsSame(map(i).Last()))
      all.push_back({TopoDS::Face(map(i).First()), TopoDS::Face(map(i).Last()),
                     TopoDS::Edge(map.FindKey(i))});
  return all;
}

// A wall with a quarter of a cylinder that goes on smoothly from it.
TopoDS_Shape bent_wall() {
  const gp_Circ round(gp_Ax2(gp_Pnt(2, 1, 0), gp_Dir(0, 0, 1)), 1);
  BRepBuilderAPI_MakeWire wire(
      BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(2, 0, 0)).Edge(),
      BRepBuilderAPI_MakeEdge(round, gp_Pnt(2, 0, 0), gp_Pnt(3, 1, 0)).Edge());
  return BRepPrimAPI_MakePrism(wire.Wire(), gp_Vec(0, 0, 2)).Shape();
}

TEST(SharedEdges, OfABoxAreItsEdges) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 3, 2).Shape();
  double sum = 0;
  for (const Neighbours& pair : neighbours(box)) {
    const auto edges = shared_edges(pair.a, pair.b);
    ASSERT_EQ(edges.size(), 1u);
    EXPECT_FALSE(edges[0].curve.tangential);
    EXPECT_NEAR(edges[0].curve.least_angle, std::numbers::pi / 2, 1e-9);
    sum += edges[0].curve.length;
  }
  EXPECT_NEAR(sum, 4 * (4 + 3 + 2), 1e-9);
}

TEST(SharedEdges, SeamsAndStrangersAreNone) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(cylinder).Shape();
  for (const TopoDS_Face& face : faces_of(cylinder)) {
    EXPECT_TRUE(shared_edges(face, face).empty());
    for (const TopoDS_Face& other : faces_of(copy)) EXPECT_TRUE(shared_edges(face, other).empty());
  }
  std::size_t circles = 0;
  for (const Neighbours& pair : neighbours(cylinder))
    for (const SharedEdge& edge : shared_edges(pair.a, pair.b)) {
      ++circles;
      EXPECT_TRUE(edge.curve.closed);
      EXPECT_NEAR(edge.curve.length, 2 * std::numbers::pi, 1e-3);
      EXPECT_LT(edge.curve.deviation.between, 1e-7);
    }
  EXPECT_EQ(circles, 2u);
}

// A tube that a plane through its seam cuts in two: the old seam keeps two curves on the surface,
// but each half has it once.
std::vector<TopoDS_Face> halves_of_a_tube() {
  TopTools_ListOfShape tubes, tools;
  for (const TopoDS_Face& face : faces_of(BRepPrimAPI_MakeCylinder(1, 2).Shape()))
    if (BRepAdaptor_Surface(face).GetType() == GeomAbs_Cylinder) tubes.Append(face);
  tools.Append(BRepBuilderAPI_MakeFace(gp_Pln(gp::ZOX()), -3, 3, -3, 3).Face());
  BRepAlgoAPI_Splitter split;
  split.SetArguments(tubes);
  split.SetTools(tools);
  split.Build();
  return faces_of(split.Shape());
}

TEST(SharedEdges, OfTwoHalvesIncludeTheOldSeam) {
  const std::vector<TopoDS_Face> halves = halves_of_a_tube();
  ASSERT_EQ(halves.size(), 2u);
  const std::vector<SharedEdge> edges = shared_edges(halves[0], halves[1]);
  ASSERT_EQ(edges.size(), 2u);
  const TrimShapes shapes = trim_shapes(halves[0]);
  EXPECT_TRUE(std::ranges::any_of(edges, [&](const SharedEdge& x) {
    return BRep_Tool::IsClosed(TopoDS::Edge(shapes.edges(x.in_a + 1)), halves[0]);
  }));
  for (const SharedEdge& edge : edges) {
    EXPECT_NEAR(edge.curve.length, 2, 1e-9);
    EXPECT_LT(edge.gap, 1e-9);
  }
}

TEST(SharedEdges, AreAllThatTwoHalvesOfOneSurfaceHaveInCommon) {
  const auto found = self_intersect(halves_of_a_tube(), SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

// Both faces have the edge, and nothing else in common: that is proven.
TEST(SharedEdges, ThatAreSmoothAreTangentialCurves) {
  const std::vector<Neighbours> pairs = neighbours(bent_wall());
  ASSERT_EQ(pairs.size(), 1u);
  const ShapeIntersection found = intersect({pairs[0].a}, {pairs[0].b});
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.pairs.size(), 1u);
  const SurfaceIntersection& one = found.pairs[0].found;
  ASSERT_EQ(one.curves.size(), 1u);
  EXPECT_TRUE(one.curves[0].tangential);
  EXPECT_NEAR(one.curves[0].length, 2, 1e-9);
  EXPECT_TRUE(one.points.empty());
  EXPECT_TRUE(one.places.empty());
}

}  // namespace
}  // namespace blossom::occt
