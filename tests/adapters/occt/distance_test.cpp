// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "tests/support/shapes.h"

namespace blossom::occt {
namespace {

using testing::random_point;
using testing::seeded;

MeasuredShape at(const TopoDS_Shape& shape, const Vec3& by) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(by[0], by[1], by[2]));
  return MeasuredShape(shape.Moved(move));
}

TopoDS_Face plate_with_hole() {
  const gp_Circ circle(gp_Ax2(gp_Pnt(2, 2, 0), gp_Dir(0, 0, -1)), 1);
  BRepBuilderAPI_MakeFace maker(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4).Face());
  maker.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)));
  return maker.Face();
}

void expect_distance(const ShapeDistance& found, double expected) {
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_LE(found.lower, expected * (1 + 1e-14) + 1e-13);
  EXPECT_GE(found.upper, expected * (1 - 1e-14) - 1e-13);
  // All coordinates here sum to less than 10.
  EXPECT_LE(found.upper - found.lower,
            std::max(kDistanceAccuracy * expected, 10 * kDistanceResolution));
}

TEST(ShapeDistance, OfBoxesIsTakenAtFacesEdgesAndVertices) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  const MeasuredShape first(box);
  expect_distance(least_distance(first, at(box, {1.5, 0.2, 0.3})), 0.5);
  expect_distance(least_distance(first, at(box, {1.3, 1.4, 0.3})), 0.5);
  const ShapeDistance corners = least_distance(first, at(box, {2, 2, 2}));
  expect_distance(corners, std::sqrt(3));
  EXPECT_EQ(corners.a.on.ShapeType(), TopAbs_VERTEX);
  EXPECT_EQ(corners.b.on.ShapeType(), TopAbs_VERTEX);
  EXPECT_EQ(corners.a.point, (Vec3{1, 1, 1}));
}

TEST(ShapeDistance, RespectsTrims) {
  const MeasuredShape plate(plate_with_hole());
  expect_distance(nearest_point(plate, {0.5, 0.5, 2}), 2);
  const ShapeDistance hole = nearest_point(plate, {2, 2.25, 1});
  expect_distance(hole, std::hypot(0.75, 1.0));
  EXPECT_EQ(hole.b.on.ShapeType(), TopAbs_EDGE);
  // A ball through the hole does not touch the plate.
  expect_distance(least_distance(plate, at(BRepPrimAPI_MakeSphere(0.75).Shape(), {2.1, 2, 0})),
                  0.15);
}

TEST(ShapeDistance, NamesTheFaceAndItsParameters) {
  const ShapeDistance found =
      nearest_point(MeasuredShape(BRepPrimAPI_MakeSphere(2).Shape()), {3, 3, 3});
  expect_distance(found, 3 * std::sqrt(3) - 2);
  ASSERT_EQ(found.b.on.ShapeType(), TopAbs_FACE);
  EXPECT_NEAR(found.b.uv[0], std::atan2(1, 1), 1e-8);
  EXPECT_NEAR(found.b.uv[1], std::asin(1 / std::sqrt(3)), 1e-8);
}

TEST(ShapeDistance, IsNoMoreThanThatOfOpenCascade) {
  auto random = seeded(11);
  const std::vector<TopoDS_Shape> shapes{
      BRepPrimAPI_MakeBox(1, 2, 0.5).Shape(),   BRepPrimAPI_MakeSphere(0.7).Shape(),
      BRepPrimAPI_MakeTorus(1, 0.3).Shape(),    BRepPrimAPI_MakeCone(0.8, 0.2, 1).Shape(),
      BRepPrimAPI_MakeCylinder(0.5, 1).Shape(), plate_with_hole()};
  for (const TopoDS_Shape& a : shapes)
    for (const TopoDS_Shape& b : shapes) {
      gp_Trsf turn, move;
      const Vec3 axis = random_point(random), by = 3 * unit(random_point(random));
      turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(axis[0], axis[1], axis[2])), 1);
      move.SetTranslation(gp_Vec(by[0], by[1], by[2]));
      const TopoDS_Shape moved = BRepBuilderAPI_Transform(b, move * turn, true).Shape();
      const MeasuredShape first(a), second(moved);
      const ShapeDistance found = least_distance(first, second);
      const ShapeDistance turned = least_distance(second, first);
      BRepExtrema_DistShapeShape theirs(a, moved);
      ASSERT_TRUE(theirs.IsDone());
      EXPECT_EQ(found.status, Status::Complete);
      EXPECT_LE(found.upper, theirs.Value() * (1 + 1e-9) + 1e-9);
      EXPECT_LE(found.lower, turned.upper);
      EXPECT_LE(turned.lower, found.upper);
    }
}

// As Open CASCADE reads faces of IGES files: where a place mirrors, it wants to make no more.
TEST(ShapeDistance, TakesPlacesThatMirror) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
  const TopoDS_Shape bore = BRepPrimAPI_MakeCylinder(gp_Ax2({5, 0, 0}, {0, 0, 1}), 1, 2).Shape();
  const MeasuredShape there(bore.Moved(TopLoc_Location(mirror), false));
  expect_distance(nearest_point(there, {-9, 0, 1}), 3);
}

TEST(ShapeDistance, TakesPartsWhereTheyArePlaced) {
  // The same box twice in a compound that is turned and placed itself.
  gp_Trsf turn, apart, away;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 2, 3)), 1);
  apart.SetTranslation(gp_Vec(5, 0, 0));
  away.SetTranslation(gp_Vec(0, 7, 0));
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  BRep_Builder builder;
  TopoDS_Compound inner, outer;
  builder.MakeCompound(inner);
  builder.Add(inner, box);
  builder.Add(inner, box.Moved(apart));
  builder.MakeCompound(outer);
  builder.Add(outer, inner);
  builder.Add(outer, inner.Moved(away));
  const TopoDS_Shape turned = outer.Moved(turn);
  const MeasuredShape measured(turned);
  EXPECT_EQ(measured.faces().size(), 24u);
  const gp_Pnt p = gp_Pnt(5.3, 8.9, 0.4).Transformed(turn);
  const ShapeDistance found = nearest_point(measured, {p.X(), p.Y(), p.Z()});
  expect_distance(found, 0.9);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(turned, TopAbs_FACE, faces);
  EXPECT_GT(faces.FindIndex(found.b.on), 0);
}

TEST(ShapeDistance, FromAHyperbolaIsExactAndKnowsItsParameter) {
  // 0.3 beside the place at 0.7 of x = 2 cosh t, y = sinh t, where it curves away.
  const double t = 0.7;
  const Vec3 on{2 * std::cosh(t), std::sinh(t), 0};
  const Vec3 normal = unit(Vec3{-std::cosh(t), 2 * std::sinh(t), 0});
  const TopoDS_Edge edge =
      BRepBuilderAPI_MakeEdge(new Geom_Hyperbola(gp_Ax2(), 2, 1), -1.0, 3.0).Edge();
  const ShapeDistance found = nearest_point(MeasuredShape(edge), on + 0.3 * normal);
  expect_distance(found, 0.3);
  EXPECT_NEAR(found.b.uv[0], t, 1e-7);
}

TEST(ShapeDistance, ConvertsFormsWithoutControlPointsAtOnce) {
  // An offset surface is approximated; its bound is part of every answer.
  const Handle(Geom_Surface) ball = new Geom_SphericalSurface(gp_Ax3(), 1);
  const Handle(Geom_Surface) bezier = GeomConvert::SurfaceToBSplineSurface(
      new Geom_RectangularTrimmedSurface(ball, 0.0, 1.0, 0.0, 1.0));
  const Handle(Geom_Surface) offset = new Geom_OffsetSurface(bezier, 0.5);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(offset, 1e-7).Face();
  const MeasuredShape measured(face);
  EXPECT_GT(measured.error(), 0);
  const ShapeDistance found = nearest_point(measured, {2 * std::cos(0.5), 2 * std::sin(0.5), 0.5});
  EXPECT_EQ(found.status, Status::Tolerance);
  EXPECT_LE(found.lower, std::sqrt(4.25) - 1.5);
  EXPECT_NEAR(found.upper, std::sqrt(4.25) - 1.5, 1e-6);
}

TEST(ShapeFeet, AreOnFacesWithinTrimsAndOnEdges) {
  // Over the hole of the plate: none on the face, four on the sides, two on the circle.
  const std::vector<ShapeFoot> feet = foot_points(MeasuredShape(plate_with_hole()), {2.25, 2, 1});
  ASSERT_EQ(feet.size(), 6u);
  for (const ShapeFoot& foot : feet) EXPECT_EQ(foot.at.on.ShapeType(), TopAbs_EDGE);
  EXPECT_NEAR(feet[0].foot.distance, std::hypot(0.75, 1.0), 1e-12);
  EXPECT_EQ(foot_points(MeasuredShape(plate_with_hole()), {0.5, 0.5, 1})[0].at.on.ShapeType(),
            TopAbs_FACE);
}

TEST(ShapeMeeting, SaysNoYesOrWithin) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(1).Shape();
  const MeasuredShape first(ball);
  const ShapeMeeting apart = meeting(first, at(ball, {2.001, 0, 0}));
  EXPECT_EQ(apart.answer, Meeting::No);
  EXPECT_GT(apart.lower, 0);
  const ShapeMeeting crossing = meeting(first, at(ball, {1.2, 0.3, 0.1}));
  EXPECT_EQ(crossing.answer, Meeting::Yes);
  EXPECT_NEAR(norm(crossing.a.point), 1, 1e-9);
  EXPECT_EQ(meeting(first, at(ball, {2, 0, 0})).answer, Meeting::Within);
  // Inside of each other without a common point: solids are their boundaries.
  EXPECT_EQ(meeting(first, MeasuredShape(BRepPrimAPI_MakeSphere(0.5).Shape())).answer, Meeting::No);
  EXPECT_THROW(meeting(first, first, 0), InvalidInput);
}

// z = sin x sin y over a square of n x n spans, turned a little about its middle.
TopoDS_Face waves(int n, double angle) {
  TColgp_Array2OfPnt points(1, n + 1, 1, n + 1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = 10.0 * i / n, y = 10.0 * j / n;
      points.SetValue(i + 1, j + 1, gp_Pnt(x, y, std::sin(x) * std::sin(y)));
    }
  const TopoDS_Face face =
      BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points).Surface(), 1e-7).Face();
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(5, 5, 0), gp_Dir(0.3, 0.5, 0.8)), angle);
  return TopoDS::Face(BRepBuilderAPI_Transform(face, turn, true).Shape());
}

// Everywhere near each other, so that pairs of cells are halved without end where they do not
// cross.
TEST(ShapeMeeting, OfNearlyEqualSurfacesIsProvenAtOnce) {
  const MeasuredShape still(waves(40, 0));
  for (const double angle : {0.4, 0.03, 1e-3}) {
    const ShapeMeeting found = meeting(still, MeasuredShape(waves(40, angle)));
    EXPECT_EQ(found.answer, Meeting::Yes) << angle;
    EXPECT_LE(found.pairs, 2000) << angle;
  }
}

TEST(ShapeMeeting, OfFormsThatAreApproximatedIsKnown) {
  const Handle(Geom_Surface) ball = new Geom_SphericalSurface(gp_Ax3(), 1);
  const Handle(Geom_Surface) patch = new Geom_RectangularTrimmedSurface(ball, 0., 1., 0., 1.);
  const Handle(Geom_Surface) offset =
      new Geom_OffsetSurface(GeomConvert::SurfaceToBSplineSurface(patch), 0.5);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(offset, 1e-7).Face();
  EXPECT_EQ(meeting(MeasuredShape(face), at(face, {})).answer, Meeting::Within);
}

TEST(ShapeMeeting, OfWhatPassesThroughAHoleIsNo) {
  const MeasuredShape plate(plate_with_hole());
  const MeasuredShape pin(
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(2, 2, -1), gp_Dir(0, 0, 1)), 0.5, 2).Shape());
  EXPECT_EQ(meeting(plate, pin).answer, Meeting::No);
  EXPECT_EQ(meeting(plate, at(BRepPrimAPI_MakeCylinder(0.5, 2).Shape(), {2.7, 2, -1})).answer,
            Meeting::Yes);
}

TEST(MeasuredShape, RefusesNothing) { EXPECT_THROW(MeasuredShape{TopoDS_Shape()}, BadModel); }

TEST(MeasuredShape, MayBeAVertexOrAnEdge) {
  const MeasuredShape vertex(BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 1)).Vertex());
  const MeasuredShape edge(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(), 2)).Edge());
  expect_distance(least_distance(vertex, edge), std::sqrt(5));
}

}  // namespace
}  // namespace blossom::occt
