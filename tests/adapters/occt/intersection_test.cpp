// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/intersection.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <exception>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection_edges.h"

namespace blossom::occt {
namespace {

TopoDS_Face square_with_hole() {
  BRepBuilderAPI_MakeFace maker(gp_Pln(), -4, 4, -4, 4);
  const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, -1)), 1);
  maker.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)));
  return maker.Face();
}

TopoDS_Face sphere_at(const gp_Pnt& centre, double radius) {
  return faces_of(BRepPrimAPI_MakeSphere(centre, radius).Shape()).front();
}

TEST(IntersectShapes, SeesNothingInAHole) {
  const ShapeIntersection found = intersect({square_with_hole()}, {sphere_at({0, 0, 0.3}, 0.5)});
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

// The contact lies in the hole: it is none, and does not weaken the answer.
TEST(IntersectShapes, DoesNotMindAContactOutsideOfTheTrims) {
  const TopoDS_Face sphere = sphere_at({0.2, 0.1, 0.5}, 0.5);
  const ShapeIntersection with_hole = intersect({square_with_hole()}, {sphere});
  EXPECT_EQ(with_hole.status, Status::Complete);
  EXPECT_TRUE(with_hole.pairs.empty());
  const ShapeIntersection without =
      intersect({BRepBuilderAPI_MakeFace(gp_Pln(), -4, 4, -4, 4)}, {sphere});
  EXPECT_EQ(without.status, Status::Complete);  // the contact is exact
  ASSERT_EQ(without.pairs.size(), 1u);
  EXPECT_EQ(without.pairs[0].found.points.size(), 1u);
}

TopoDS_Face polygon(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& corner : corners) wire.Add(corner);
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

// A strip ends in the wall along one of its short edges. So short a contact of curved faces would
// be a point of touch.
TEST(IntersectShapes, FindsAnEdgeThatEndsInAFaceHoweverShortItIs) {
  const TopoDS_Face wall = polygon({{0, -3, -3}, {0, 3, -3}, {0, 3, 3}, {0, -3, 3}});
  for (const double height : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 5e-7}) {
    const TopoDS_Face even = polygon({{0, 0, 0}, {2, 1, 0}, {2, 1, height}, {0, 0, height}});
    const TopoDS_Face wedge = polygon({{0, 0, 0}, {2, 1, -1}, {2, 1, 1}, {0, 0, height}});
    for (const TopoDS_Face& strip : {even, wedge}) {
      const ShapeIntersection found = intersect({wall}, {strip});
      EXPECT_EQ(found.status, Status::Complete) << height;
      ASSERT_EQ(found.pairs.size(), 1u) << height;
      ASSERT_EQ(found.pairs[0].found.curves.size(), 1u) << height;
      EXPECT_NEAR(found.pairs[0].found.curves[0].length, height, 1e-12);
      EXPECT_TRUE(found.pairs[0].found.points.empty()) << height;
    }
  }
}

TEST(IntersectShapes, CutsCurvesAtAHole) {
  const gp_Pln upright(gp_Pnt(0, 0.6, 0), gp_Dir(0, 1, 0));
  const ShapeIntersection found =
      intersect({square_with_hole()}, {BRepBuilderAPI_MakeFace(upright, -3, 3, -3, 3)});
  EXPECT_EQ(found.status, Status::Complete);
  ASSERT_EQ(found.pairs.size(), 1u);
  double sum = 0;
  for (const IntersectionCurve& curve : found.pairs[0].found.curves) sum += curve.length;
  EXPECT_EQ(found.pairs[0].found.curves.size(), 2u);
  EXPECT_NEAR(sum, 6 - 2 * 0.8, 1e-6);
}

// A wire that a cut keeps to may leave it for a bay: what runs across that is outside.
TEST(IntersectShapes, CutsCurvesAlongAWireAtItsBays) {
  for (const double width : {0.5, 4.0}) {
    BRepBuilderAPI_MakePolygon plate;
    for (const auto& [x, y] : {std::array{0.0, 0.0},
                               {45, 0},
                               {45, 10},
                               {45 + width, 10},
                               {45 + width, 0},
                               {100, 0},
                               {100, 50},
                               {0, 50}})
      plate.Add(gp_Pnt(x, y, 0));
    plate.Close();
    const gp_Pln upright(gp_Ax3(gp_Pnt(0, 0, 0), gp::DY(), gp::DX()));
    const ShapeIntersection found = intersect({BRepBuilderAPI_MakeFace(gp_Pln(), plate.Wire())},
                                              {BRepBuilderAPI_MakeFace(upright, 5, 95, -20, 20)});
    ASSERT_EQ(found.pairs.size(), 1u);
    double sum = 0;
    for (const IntersectionCurve& curve : found.pairs[0].found.curves) sum += curve.length;
    EXPECT_EQ(found.pairs[0].found.curves.size(), 2u);
    EXPECT_NEAR(sum, 90 - width, 1e-5);
  }
}

TEST(IntersectShapes, IsTheSameForAnyNumberOfThreads) {
  const auto box = faces_of(BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, -1), 2, 2, 2).Shape());
  const auto cylinder = faces_of(
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0.3, 0.2, -2), gp_Dir(0.1, 0.2, 1)), 0.4, 4).Shape());
  const ShapeIntersection alone = intersect(box, cylinder, {.threads = 1});
  for (const int threads : {0, 2, 5}) {
    const ShapeIntersection found = intersect(box, cylinder, {.threads = threads});
    EXPECT_EQ(found.status, alone.status);
    ASSERT_EQ(found.pairs.size(), alone.pairs.size());
    for (std::size_t i = 0; i < alone.pairs.size(); ++i) {
      EXPECT_EQ(found.pairs[i].face_a, alone.pairs[i].face_a);
      EXPECT_EQ(found.pairs[i].face_b, alone.pairs[i].face_b);
      ASSERT_EQ(found.pairs[i].found.curves.size(), alone.pairs[i].found.curves.size());
      for (std::size_t k = 0; k < alone.pairs[i].found.curves.size(); ++k)
        EXPECT_EQ(found.pairs[i].found.curves[k].curve.points,
                  alone.pairs[i].found.curves[k].curve.points);
    }
  }
}

std::size_t curves_of(const ShapeIntersection& found) {
  std::size_t count = 0;
  for (const FaceIntersection& pair : found.pairs) count += pair.found.curves.size();
  return count;
}

std::size_t points_of(const ShapeIntersection& found) {
  std::size_t count = 0;
  for (const FaceIntersection& pair : found.pairs) count += pair.found.points.size();
  return count;
}

TEST(IntersectShapes, ListPairsThatThereWasNoTimeFor) {
  const std::vector<TopoDS_Face> box = faces_of(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  const std::vector<TopoDS_Face> ball = faces_of(BRepPrimAPI_MakeSphere(1).Shape());
  const ShapeIntersection found = intersect(box, ball, {.cancelled = [] { return true; }});
  EXPECT_EQ(found.status, Status::Stopped);
  EXPECT_TRUE(found.certificate.limited);
  ASSERT_EQ(static_cast<long>(found.pairs.size()), found.face_pairs);
  for (const FaceIntersection& pair : found.pairs) {
    ASSERT_EQ(pair.found.places.size(), 1u);
    EXPECT_EQ(pair.found.places[0].kind, PlaceKind::Open);
    for (int k = 0; k < 3; ++k)
      EXPECT_LE(pair.found.places[0].box_low[k], pair.found.places[0].box_high[k]);
  }
}

// What the caller's question throws is no failure of the faces that were at work, wherever it is
// asked: while outlines are laid over each other, or regions of splines that coincide are clipped.
TEST(IntersectShapes, EndWithWhatTheQuestionThrows) {
  struct Ended : std::exception {};
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Pln());
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 3; ++j) poles(i, j) = gp_Pnt(i, j, 0.2 * i * j);
  const Handle(Geom_Surface) spline = new Geom_BezierSurface(poles);
  for (const Handle(Geom_Surface) & surface : {plane, spline}) {
    const TopoDS_Face left = BRepBuilderAPI_MakeFace(surface, 0, 0.7, 0, 1, 1e-7);
    const TopoDS_Face right = BRepBuilderAPI_MakeFace(surface, 0.4, 1, 0.2, 0.9, 1e-7);
    int asked = 0;
    for (int ending = 0; asked >= ending; ++ending) {
      asked = 0;
      const auto ask = [&] {
        if (++asked > ending) throw Ended();
        return false;
      };
      bool ended = false;
      try {
        intersect({left}, {right}, {.threads = 1, .cancelled = ask});
      } catch (const Ended&) {
        ended = true;
      }
      EXPECT_EQ(ended, asked > ending) << ending;
    }
  }
}

TEST(SelfIntersectShapes, LeaveOutWhatFacesShare) {
  // Opposite sides of the pyramid share their top only.
  for (const TopoDS_Shape& sound :
       {BRepPrimAPI_MakeBox(1, 2, 3).Shape(),
        BRepPrimAPI_MakeWedge(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)), 2, 1, 2, 1, 1, 1, 1)
            .Shape(),
        BRepPrimAPI_MakeCylinder(1, 2).Shape()}) {
    const auto faces = faces_of(sound);
    const ShapeIntersection found = self_intersect(faces, SelfScope::AllFaces);
    EXPECT_GT(found.face_pairs, static_cast<long>(faces.size()));
    EXPECT_EQ(curves_of(found), 0u);
    EXPECT_EQ(points_of(found), 0u);
    EXPECT_NE(found.status, Status::Stopped);
  }
}

// A plate through a box and out of it crosses two of the box's faces.
TEST(SelfIntersectShapes, FindWhereDifferentFacesCross) {
  auto faces = faces_of(BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, -1), 2, 2, 2).Shape());
  faces.push_back(BRepBuilderAPI_MakeFace(gp_Pln(), -3, 3, -0.5, 0.5));
  EXPECT_EQ(curves_of(self_intersect(faces, SelfScope::EachFace)), 0u);
  const ShapeIntersection found = self_intersect(faces, SelfScope::AllFaces);
  EXPECT_NE(found.status, Status::Stopped);
  EXPECT_EQ(curves_of(found), 2u);
  for (const FaceIntersection& pair : found.pairs) {
    EXPECT_LT(pair.face_a, pair.face_b);
    EXPECT_EQ(pair.face_b, 6);
    for (const IntersectionCurve& curve : pair.found.curves) EXPECT_NEAR(curve.length, 1, 1e-9);
  }
}

TEST(IntersectShapes, SeesNoContactOfFacesThatLieApartOnOneSurface) {
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 1; i <= 4; ++i)
    for (int j = 1; j <= 4; ++j) poles(i, j) = gp_Pnt(i, j, 0.3 * std::sin(2.0 * i) * j);
  const Handle(Geom_Surface) surface = new Geom_BezierSurface(poles);
  const auto disc = [&](double u, double v) -> TopoDS_Face {
    const Handle(Geom2d_Curve) circle =
        new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(u, v), gp_Dir2d(1, 0)), 0.25);
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle, surface);
    BRepLib::BuildCurve3d(edge);
    return BRepBuilderAPI_MakeFace(surface, BRepBuilderAPI_MakeWire(edge));
  };
  const ShapeIntersection found = intersect({disc(0.31, 0.31)}, {disc(0.69, 0.69)});
  for (const FaceIntersection& pair : found.pairs) {
    EXPECT_TRUE(pair.found.places.empty());
    EXPECT_TRUE(pair.found.overlaps.empty());
  }
}

}  // namespace
}  // namespace blossom::occt
