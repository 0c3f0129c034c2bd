// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces that go on smoothly into a plane, against other faces in that plane.

#include "adapters/occt/faces/pairs/touched_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

constexpr double kRough = 2e-9;  // how far the border of the curved face is off the plane
constexpr int kAlong = 6;        // control points along that border

// Rises from the plane z = 0 beyond a wavy border next to y = 0, to which it is tangent but for
// what its control points are off by.
TopoDS_Face rising() {
  TColgp_Array2OfPnt poles(1, kAlong, 1, 4);
  for (int i = 0; i < kAlong; ++i)
    for (int j = 0; j < 4; ++j) {
      const double off = j < 2 ? (i % 2 == j ? kRough : -kRough) : 0;
      poles(i + 1, j + 1) =
          gp_Pnt(i, j + 0.3 * std::sin(2.0 * i), (j < 2 ? 0 : 0.4 * (j - 1)) + off);
    }
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7);
}

TopoDS_Edge border_of(const TopoDS_Face& face) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const auto edge = TopoDS::Edge(it.Current());
    const gp_Pnt from = BRep_Tool::Pnt(TopExp::FirstVertex(edge)),
                 to = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if (std::abs(from.X() - to.X()) > kAlong - 2 && std::abs(from.Z()) < 0.1) return edge;
  }
  ADD_FAILURE() << "no border in the plane";
  return {};
}

// In the plane, between the border and y = -3.
TopoDS_Face level(const TopoDS_Edge& border) {
  const TopoDS_Vertex from = TopExp::FirstVertex(border, true),
                      to = TopExp::LastVertex(border, true);
  const auto below = [](const TopoDS_Vertex& v) {
    return BRepBuilderAPI_MakeVertex(gp_Pnt(BRep_Tool::Pnt(v).X(), -3, 0)).Vertex();
  };
  const TopoDS_Vertex low_from = below(from), low_to = below(to);
  BRepBuilderAPI_MakeWire wire(border, BRepBuilderAPI_MakeEdge(to, low_to),
                               BRepBuilderAPI_MakeEdge(low_to, low_from),
                               BRepBuilderAPI_MakeEdge(low_from, from));
  return BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), wire.Wire());
}

// In a plane, with axes of its own.
TopoDS_Face rectangle(double from, double to, double height = 0) {
  const gp_Pln plane(gp_Ax3(gp_Pnt(from, 3, height), -gp::DZ(), -gp::DY()));
  return BRepBuilderAPI_MakeFace(plane, 0, 6, from - to, 0);
}

struct Body {
  TopoDS_Face curved = rising();
  TopoDS_Edge border = border_of(curved);
  std::vector<TopoDS_Face> faces{curved, level(border)};
};

double length_of(const TopoDS_Edge& edge) {
  GProp_GProps properties;
  BRepGProp::LinearProperties(edge, properties);
  return properties.Mass();
}

double length_with(const ShapeIntersection& found, int face_a, int face_b) {
  double sum = 0;
  for (const FaceIntersection& pair : found.pairs)
    if (pair.face_a == face_a && pair.face_b == face_b)
      for (const IntersectionCurve& curve : pair.found.curves) sum += curve.length;
  return sum;
}

bool is_open(const ShapeIntersection& found) {
  return found.status == Status::Stopped ||
         std::ranges::any_of(found.pairs, [](const FaceIntersection& pair) {
           return std::ranges::any_of(
               pair.found.places, [](const Place& place) { return place.kind == PlaceKind::Open; });
         });
}

TEST(TouchedPlanes, HoldTheEdgesOfSmoothNeighboursInThem) {
  const Body body;
  const TopoDS_Face wide = rectangle(-2, 8);
  const ShapeIntersection found = intersect(body.faces, {wide});
  EXPECT_FALSE(is_open(found));
  EXPECT_NEAR(length_with(found, 0, 0), length_of(body.border), 1e-6);
  const ShapeIntersection exchanged = intersect({wide}, body.faces);
  EXPECT_FALSE(is_open(exchanged));
  EXPECT_NEAR(length_with(exchanged, 0, 0), length_of(body.border), 1e-6);
}

TEST(TouchedPlanes, HoldOfEdgesWhatTheirTrimsLeave) {
  const Body body;
  const double middle = 2.25;
  const ShapeIntersection left = intersect(body.faces, {rectangle(-2, middle)});
  const ShapeIntersection right = intersect({rectangle(middle, 8)}, body.faces);
  EXPECT_FALSE(is_open(left));
  EXPECT_FALSE(is_open(right));
  EXPECT_GT(length_with(left, 0, 0), 2);
  EXPECT_GT(length_with(right, 0, 0), 2);
  EXPECT_NEAR(length_with(left, 0, 0) + length_with(right, 0, 0), length_of(body.border), 1e-6);
}

TEST(TouchedPlanes, AreNoneBeyondTheTrimsNorAboveThePlane) {
  const Body body;
  EXPECT_EQ(length_with(intersect(body.faces, {rectangle(6, 8)}), 0, 0), 0);
  const ShapeIntersection above = intersect(body.faces, {rectangle(-2, 8, 0.1)});
  EXPECT_EQ(above.status, Status::Complete);
  EXPECT_GT(length_with(above, 0, 0), 4);
}

}  // namespace
}  // namespace blossom::occt
