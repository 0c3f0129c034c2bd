// SPDX-License-Identifier: LGPL-2.1-or-later
// Models against copies of themselves: every face coincides with its copy and meets those of its
// neighbours in the edges they share.

#include "adapters/occt/faces/pairs/equal_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <vector>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/shapes.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

TopoDS_Shape copy_of(const TopoDS_Shape& shape) { return BRepBuilderAPI_Copy(shape).Shape(); }

gp_Trsf motion() {
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 0.3, -0.7)), 0.7);
  move.SetTranslation(gp_Vec(0.1, -5, 2.5));
  return move * turn;
}

Handle(Geom_BezierSurface) hill() {
  TColgp_Array2OfPnt poles(1, 4, 1, 3);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      poles(i + 1, j + 1) = gp_Pnt(i, 1.4 * j, 0.5 * std::sin(1.3 * i) * std::cos(0.9 * j));
  return new Geom_BezierSurface(poles);
}

TopoDS_Face face_on(const Handle(Geom_Surface) & surface) {
  return BRepBuilderAPI_MakeFace(surface, 1e-7);
}

// Edges that bound two different faces.
std::size_t shared_edges_of(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  std::size_t count = 0;
  for (int i = 1; i <= faces.Extent(); ++i)
    if (faces(i).Extent() == 2 && !BRep_Tool::Degenerated(TopoDS::Edge(faces.FindKey(i)))) ++count;
  return count;
}

// Each face has one region, with its copy alone, and each edge is a curve of either face with the
// copy of the other.
void expect_copies(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  const ShapeIntersection found = intersect(faces_of(a), faces_of(b));
  EXPECT_NE(found.status, Status::Stopped);
  std::size_t regions = 0, curves = 0;
  for (const FaceIntersection& pair : found.pairs) {
    curves += pair.chains.size();
    for (const Overlap& region : pair.found.overlaps) {
      EXPECT_EQ(pair.face_a, pair.face_b);
      EXPECT_LE(region.gap_high, 1e-10);
      EXPECT_FALSE(pair.equal_edges.empty());
      ++regions;
    }
    for (const Place& place : pair.found.places) EXPECT_NE(place.kind, PlaceKind::Open);
  }
  EXPECT_EQ(regions, faces_of(a).size());
  EXPECT_EQ(curves, 2 * shared_edges_of(a));
}

struct Solid {
  const char* name;
  TopoDS_Shape shape;
};

std::vector<Solid> solids() {
  return {{"box", BRepPrimAPI_MakeBox(1, 2, 3).Shape()},
          {"cylinder", BRepPrimAPI_MakeCylinder(1, 2).Shape()},
          {"half a cylinder", BRepPrimAPI_MakeCylinder(1, 2, std::numbers::pi).Shape()},
          {"sphere", BRepPrimAPI_MakeSphere(1.5).Shape()},
          {"torus", BRepPrimAPI_MakeTorus(3, 1).Shape()},
          {"hill", face_on(hill())}};
}

TEST(EqualFaces, OfSolidsCoincide) {
  for (const Solid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    expect_copies(solid.shape, solid.shape);
    expect_copies(solid.shape, copy_of(solid.shape));
    expect_copies(solid.shape, copy_of(solid.shape).Reversed());
  }
}

// One moved in its place, the numbers of the other: they differ by roundings.
TEST(EqualFaces, OfMovedSolidsCoincide) {
  for (const Solid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    expect_copies(solid.shape.Moved(motion()),
                  BRepBuilderAPI_Transform(solid.shape, motion(), true).Shape());
  }
}

// Offsets are approximated: what both are off is more than rounding, and less than the tolerance.
TEST(EqualFaces, OfOffsetsCoincideWithinWhatTheyAreApproximated) {
  const TopoDS_Shape face = face_on(new Geom_OffsetSurface(hill(), 0.4));
  const ShapeIntersection found = intersect(faces_of(face), faces_of(copy_of(face)));
  EXPECT_NE(found.status, Status::Stopped);
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_EQ(found.pairs[0].equal_edges.size(), 4u);
  ASSERT_EQ(found.pairs[0].found.overlaps.size(), 1u);
  const double gap = found.pairs[0].found.overlaps[0].gap_high;
  EXPECT_GT(gap, 1e-10);
  EXPECT_LE(gap, 1e-7);
}

TEST(EqualFaces, HaveTheirBordersAndPlacesInBothCharts) {
  for (const bool exchanged : {false, true})
    for (const bool reversed : {false, true}) {
      const Handle(Geom_BezierSurface) other = hill();
      if (reversed) other->UReverse();
      if (exchanged) other->ExchangeUV();
      const TopoDS_Face a = face_on(hill()), b = face_on(other);
      const ShapeIntersection found = intersect({a}, {b});
      EXPECT_EQ(found.status, Status::Complete);
      ASSERT_EQ(found.pairs.size(), 1u);
      EXPECT_EQ(found.pairs[0].equal_edges.size(), 4u);
      ASSERT_EQ(found.pairs[0].found.overlaps.size(), 1u);
      for (const SurfacePoint& x : found.pairs[0].found.overlaps[0].boundary) {
        const gp_Pnt p = BRep_Tool::Surface(b)->Value(x.uv_b[0], x.uv_b[1]);
        EXPECT_LE(distance(Vec3{p.X(), p.Y(), p.Z()}, x.point), 1e-13);
      }
    }
}

// What is shared runs along an edge of the copy, whatever its parameters are.
TEST(EqualFaces, SharedEdgesHaveTheParametersOfTheCopy) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  const std::vector<TopoDS_Face> a = faces_of(box), b = faces_of(copy_of(box));
  const ShapeIntersection found = intersect(a, b);
  std::size_t curves = 0;
  for (const FaceIntersection& pair : found.pairs)
    for (const IntersectionCurve& curve : pair.found.curves)
      for (const SurfacePoint& x : curve.samples) {
        ++curves;
        const auto& on = b[static_cast<std::size_t>(pair.face_b)];
        const gp_Pnt p = BRep_Tool::Surface(on)->Value(x.uv_b[0], x.uv_b[1]);
        EXPECT_LE(distance(Vec3{p.X(), p.Y(), p.Z()}, x.point), 1e-13);
      }
  EXPECT_GT(curves, 0u);
}

// A face moved by far more than rounding, or with another border, is none.
double length_of(const FaceIntersection& pair) {
  double length = 0;
  for (const IntersectionCurve& curve : pair.found.curves) length += curve.length;
  return length;
}

TEST(EqualFaces, MeetTheCopiesOfOthersAlikeInBothOrders) {
  for (const TopoDS_Shape& solid :
       {BRepPrimAPI_MakeCylinder(1, 2).Shape(), BRepPrimAPI_MakeBox(1, 2, 3).Shape()}) {
    const auto faces = faces_of(solid), copies = faces_of(copy_of(solid));
    const ShapeIntersection found = intersect(faces, copies);
    int compared = 0;
    for (const FaceIntersection& pair : found.pairs) {
      if (pair.face_a <= pair.face_b) continue;
      const auto other = std::ranges::find_if(found.pairs, [&](const FaceIntersection& each) {
        return each.face_a == pair.face_b && each.face_b == pair.face_a;
      });
      ASSERT_NE(other, found.pairs.end());
      EXPECT_EQ(pair.found.status, other->found.status);
      EXPECT_EQ(pair.edges.size(), pair.found.curves.size());
      EXPECT_EQ(pair.borders.size(), pair.found.points.size());
      EXPECT_NEAR(length_of(pair), length_of(*other), 1e-9);
      for (const IntersectionCurve& curve : pair.found.curves)
        for (const SurfacePoint& x : curve.samples) {
          const auto point_of = [](const TopoDS_Face& face, const Vec2& uv) {
            const gp_Pnt p = BRep_Tool::Surface(face)->Value(uv[0], uv[1]);
            return Vec3{p.X(), p.Y(), p.Z()};
          };
          const auto a = static_cast<std::size_t>(pair.face_a);
          const auto b = static_cast<std::size_t>(pair.face_b);
          EXPECT_LE(distance(point_of(faces[a], x.uv_a), x.point), 1e-7);
          EXPECT_LE(distance(point_of(copies[b], x.uv_b), x.point), 1e-7);
        }
      ++compared;
    }
    EXPECT_GT(compared, 0);
  }
}

TEST(EqualFaces, AreNoneOfFacesThatDiffer) {
  const auto data = [](const TopoDS_Face& face) { return face_data(face, 1e-7); };
  const FaceData whole = data(face_on(hill()));
  EXPECT_TRUE(match(whole, data(face_on(hill())), 1e-10));
  const Handle(Geom_BezierSurface) moved = hill();
  moved->Translate(gp_Vec(0, 0, 1e-9));
  EXPECT_FALSE(match(whole, data(face_on(moved)), 1e-10));
  const FaceData square = data(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1));
  EXPECT_FALSE(match(square, data(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1 + 1e-9)), 1e-10));
}

// Moved by less than the tolerance they are no copies; the search tells what they are, and ends.
TEST(EqualFaces, MovedALittleAreSearched) {
  gp_Trsf little;
  little.SetTranslation(gp_Vec(2e-8, -1e-8, 3e-8));
  for (const Solid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    const ShapeIntersection found =
        intersect(faces_of(solid.shape), faces_of(solid.shape.Moved(little)));
    for (const FaceIntersection& pair : found.pairs) EXPECT_TRUE(pair.equal_edges.empty());
    EXPECT_NE(found.status, Status::Stopped);
  }
}

TEST(EqualFaces, OfModelsCoincide) {
  const char* const models = blossom::testing::test_data();
  if (models == nullptr) GTEST_SKIP() << blossom::testing::kNoTestData;
  for (const char* const name : {"d150_wing.brep", "nacelle.stp", "ball.brep"}) {
    SCOPED_TRACE(name);
    const TopoDS_Shape shape = read_model(std::filesystem::path(models) / "models" / name).shape();
    expect_copies(shape, copy_of(shape));
  }
}

}  // namespace
}  // namespace blossom::occt
