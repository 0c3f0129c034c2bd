// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of one model meet in what they share alone, or what else they have in common is found.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Bnd_Box.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/intersection.h"
#include "tests/adapters/occt/ordinary_solids.h"

namespace blossom::occt {
namespace {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_FACE, map);
  std::vector<TopoDS_Face> faces;
  for (int i = 1; i <= map.Extent(); ++i) faces.push_back(TopoDS::Face(map(i)));
  return faces;
}

// A floor that goes on in a sheet: in the xz-plane a line to (4, 0) and a curve from there on.
std::vector<TopoDS_Face> floor_and_sheet(const std::vector<gp_Pnt>& poles) {
  TColgp_Array1OfPnt points(1, static_cast<int>(poles.size()));
  for (int i = 1; i <= points.Length(); ++i) points(i) = poles[static_cast<std::size_t>(i - 1)];
  const Handle(Geom_BezierCurve) curve = new Geom_BezierCurve(points);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(4, 0, 0)).Edge(),
                               BRepBuilderAPI_MakeEdge(curve).Edge());
  return faces_of(BRepPrimAPI_MakePrism(wire.Wire(), gp_Vec(0, 2, 0)).Shape());
}

TEST(NeighbourProof, LeavesNothingOfASheetThatGoesOnSmoothly) {
  const auto found = self_intersect(floor_and_sheet({{4, 0, 0}, {7, 0, 0}, {7, 0, 4}, {2, 0, 3}}),
                                    SelfScope::AllFaces);
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

TEST(NeighbourProof, FindsTheLineInWhichASmoothSheetComesBackThroughTheFloor) {
  const auto found = self_intersect(floor_and_sheet({{4, 0, 0}, {9, 0, 0}, {7, 0, 6}, {2, 0, -3}}),
                                    SelfScope::AllFaces);
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_EQ(found.pairs[0].found.curves.size(), 1u);
  EXPECT_NEAR(found.pairs[0].found.curves[0].length, 2, 1e-6);
}

TEST(NeighbourProof, FindsALineThatIsNearTheEdge) {
  const auto found = self_intersect(
      floor_and_sheet({{4, 0, 0}, {4.0003, 0, 1e-4}, {3.9997, 0, 3e-4}, {3.9998, 0, -3e-4}}),
      SelfScope::AllFaces);
  ASSERT_EQ(found.pairs.size(), 1u);
  ASSERT_EQ(found.pairs[0].found.curves.size(), 1u);
  EXPECT_NEAR(found.pairs[0].found.curves[0].length, 2, 1e-6);
}

// The name of a failing solid has its seed.
TEST(NeighbourProof, LeavesNothingOfOrdinarySolids) {
  const int solids = std::getenv("BLOSSOM_TRIALS") != nullptr ? 120 : 10;
  for (int seed = 0; seed < solids; ++seed) {
    const testing::OrdinarySolid solid = testing::ordinary_solid(seed);
    if (solid.shape.IsNull()) continue;
    SCOPED_TRACE(std::to_string(seed) + ", " + solid.what);
    const auto found = self_intersect(faces_of(solid.shape), SelfScope::AllFaces);
    EXPECT_EQ(found.status, Status::Complete);
    EXPECT_TRUE(found.pairs.empty());
  }
}

TEST(NeighbourProof, FindsABarThatIsPushedThroughAnOrdinarySolid) {
  for (int seed = 0; seed < 4; ++seed) {
    const testing::OrdinarySolid solid = testing::ordinary_solid(seed);
    if (solid.shape.IsNull()) continue;
    SCOPED_TRACE(std::to_string(seed) + ", " + solid.what);
    Bnd_Box box;
    BRepBndLib::Add(solid.shape, box);
    const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
    const gp_Pnt start(0.6 * low.X() + 0.4 * high.X(), low.Y() - 1, 0.5 * (low.Z() + high.Z()));
    std::vector<TopoDS_Face> faces = faces_of(solid.shape);
    const double length = high.Y() - low.Y() + 2;
    for (const TopoDS_Face& face :
         faces_of(BRepPrimAPI_MakeCylinder(gp_Ax2(start, gp_Dir(0, 1, 0)), 0.1, length).Shape()))
      faces.push_back(face);
    const auto found = self_intersect(faces, SelfScope::AllFaces);
    std::size_t curves = 0;
    for (const FaceIntersection& pair : found.pairs) curves += pair.found.curves.size();
    EXPECT_GE(curves, 2u);
  }
}

}  // namespace
}  // namespace blossom::occt
