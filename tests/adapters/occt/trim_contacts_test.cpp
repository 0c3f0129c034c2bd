// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves that meet the trims of a face in a single point, or run along them.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;
const gp_Pnt O(0, 0, 0);
const gp_Dir X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);

TopoDS_Face disc(const gp_Ax2& place, double r) {
  return BRepBuilderAPI_MakeFace(
      gp_Pln(gp_Ax3(place)), BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(place, r))));
}

TopoDS_Face square_across(const gp_Pnt& at, const gp_Dir& normal) {
  return BRepBuilderAPI_MakeFace(gp_Pln(at, normal), -3, 3, -3, 3);
}

TopoDS_Face triangle() {
  return BRepBuilderAPI_MakeFace(
      BRepBuilderAPI_MakePolygon(gp_Pnt(0, 0, 0), gp_Pnt(2, 0, 0), gp_Pnt(0.7, 1, 0), true).Wire(),
      true);
}

TopoDS_Face wall(const gp_Ax3& place, double r, double from, double to) {
  return BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(place, r), 0, 2 * kPi, from, to, 1e-7);
}

TopoDS_Face ball(const gp_Ax3& place, double r) {
  return BRepBuilderAPI_MakeFace(new Geom_SphericalSurface(place, r), 1e-7);
}

enum class On { Face, Edge, Vertex };

On kind_of(const TopoDS_Shape& on) {
  if (on.IsNull()) return On::Face;
  return on.ShapeType() == TopAbs_VERTEX ? On::Vertex : On::Edge;
}

struct Touch {
  const char* name;
  TopoDS_Face a, b;
  gp_Pnt at;
  On on_a, on_b;
};

std::vector<Touch> touches() {
  // The start of a circle is a vertex, so discs are turned.
  const auto turned = [](const gp_Pnt& at, const gp_Dir& axis, double angle) {
    return gp_Ax2(at, axis).Rotated(gp_Ax1(at, axis), angle);
  };
  const TopoDS_Face rim = disc(turned(O, Z, 0.4), 1);
  const TopoDS_Face square = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4);
  return {
      {"a plane at a rim", rim, square_across({0, 1, 0}, Y), {0, 1, 0}, On::Edge, On::Face},
      {"a plane at the tip of a triangle",
       triangle(),
       square_across({0.7, 1, 0}, Y),
       {0.7, 1, 0},
       On::Vertex,
       On::Face},
      {"an oblique plane at a corner",
       triangle(),
       square_across({2, 0, 0}, {1, 0.1, 0}),
       {2, 0, 0},
       On::Vertex,
       On::Face},
      {"a plane at the corner of a square",
       square,
       square_across({4, 4, 0}, {1, 0.3, 0.2}),
       {4, 4, 0},
       On::Vertex,
       On::Face},
      {"rims of discs across each other",
       rim,
       disc(turned({0, 2, 0}, X, 0.3), 1),
       {0, 1, 0},
       On::Edge,
       On::Edge},
      {"tangent rims across each other",
       rim,
       disc(turned({1, 1, 0}, X, 0.3), 1),
       {1, 0, 0},
       On::Edge,
       On::Edge},
      {"a ball beside a rim",
       rim,
       ball(gp_Ax3({2, 0, 0}, {0, 1, 0.3}), 1),
       {1, 0, 0},
       On::Edge,
       On::Face},
      {"a rim inside of a wall",
       disc(turned({0.5, 0, 1}, Z, 1), 0.5),
       wall(gp_Ax3(O, Z, {-1, 0.2, 0}), 1, 0, 2),
       {1, 0, 1},
       On::Edge,
       On::Face},
      {"a rim outside of a wall",
       disc(turned({2, 0, 1}, Z, 1), 1),
       wall(gp_Ax3(O, Z, {-1, 0.2, 0}), 1, 0, 2),
       {1, 0, 1},
       On::Edge,
       On::Face},
  };
}

// Decided exactly where planes cross; surfaces that touch are within tolerance.
TEST(TrimContacts, ASinglePointOfTheTrimsIsAContact) {
  for (const Touch& row : touches())
    for (const bool swapped : {false, true}) {
      SCOPED_TRACE(std::string(row.name) + (swapped ? ", swapped" : ""));
      const ShapeIntersection all =
          swapped ? intersect({row.b}, {row.a}) : intersect({row.a}, {row.b});

      EXPECT_EQ(all.status, Status::Complete);
      ASSERT_EQ(all.pairs.size(), 1u);
      const FaceIntersection& pair = all.pairs[0];
      EXPECT_TRUE(pair.found.curves.empty());
      ASSERT_EQ(pair.found.points.size(), 1u);
      ASSERT_EQ(pair.borders.size(), 1u);
      EXPECT_FALSE(pair.found.places.empty());
      const Vec3 wanted{row.at.X(), row.at.Y(), row.at.Z()};
      EXPECT_LE(distance(pair.found.points[0].point, wanted), 1e-6);
      EXPECT_EQ(kind_of(pair.borders[0].on_a), swapped ? row.on_b : row.on_a);
      EXPECT_EQ(kind_of(pair.borders[0].on_b), swapped ? row.on_a : row.on_b);
    }
}

TEST(TrimContacts, TheParametersOfAContactGiveItsPoint) {
  for (const Touch& row : touches()) {
    const ShapeIntersection all = intersect({row.a}, {row.b});
    ASSERT_EQ(all.pairs.size(), 1u) << row.name;
    for (const SurfacePoint& x : all.pairs[0].found.points)
      for (const auto& [face, uv] : {std::pair{row.a, x.uv_a}, std::pair{row.b, x.uv_b}}) {
        const gp_Pnt p = BRep_Tool::Surface(face)->Value(uv[0], uv[1]);
        EXPECT_LE(distance(Vec3{p.X(), p.Y(), p.Z()}, x.point), 1e-7) << row.name;
      }
  }
}

// The chord at a distance h from a rim of radius 1 is about 2 sqrt(2 h) long.
TEST(TrimContacts, TellATouchFromAMissAndAChord) {
  const TopoDS_Face rim = disc(gp_Ax2(O, Z), 1);
  for (const double y : {1 + 1e-6, 1 + 5e-8, 1 + 1e-12, 1.0, 1 - 1e-12, 1 - 5e-8, 1 - 1e-6}) {
    const ShapeIntersection all = intersect({rim}, {square_across({0, y, 0}, Y)});
    EXPECT_EQ(all.status,
              std::abs(std::abs(y - 1) - 5e-8) < 1e-8 ? Status::Tolerance : Status::Complete)
        << y;
    const SurfaceIntersection found =
        all.pairs.empty() ? SurfaceIntersection{} : all.pairs[0].found;
    EXPECT_EQ(found.curves.size(), y == 1 - 1e-6 ? 1u : 0u) << y;
    EXPECT_EQ(found.points.size(), std::abs(y - 1) < 1e-7 ? 1u : 0u) << y;
    for (const IntersectionCurve& chord : found.curves)
      EXPECT_NEAR(chord.length, 2 * std::sqrt(1 - y * y), 1e-7);
  }
}

// Through a corner into the face: there is a curve, and no contact beside it.
TEST(TrimContacts, AnEndOfACurveIsNoContact) {
  const ShapeIntersection all = intersect({triangle()}, {square_across({0.7, 1, 0}, {1, 0.1, 0})});
  EXPECT_EQ(all.status, Status::Complete);
  ASSERT_EQ(all.pairs.size(), 1u);
  EXPECT_EQ(all.pairs[0].found.curves.size(), 1u);
  EXPECT_TRUE(all.pairs[0].found.points.empty());
}

double total_length(const SurfaceIntersection& found) {
  double sum = 0;
  for (const IntersectionCurve& curve : found.curves) sum += curve.length;
  return sum;
}

struct AlongTrims {
  const char* name;
  TopoDS_Face a, b;
  double length;
};

TopoDS_Face ellipse(const gp_Ax2& place, double major, double minor) {
  return BRepBuilderAPI_MakeFace(
      gp_Pln(gp_Ax3(place)),
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Elips(place, major, minor))));
}

TopoDS_Face plate_with_hole() {
  BRepBuilderAPI_MakeFace maker(gp_Pln(), -4, 4, -4, 4);
  maker.Add(
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(O, gp_Dir(0, 0, -1)), 1))));
  return maker.Face();
}

std::vector<AlongTrims> runs() {
  const gp_Ax2 oblique(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 2));
  const gp_Dir turned(std::cos(1.0), std::sin(1.0), 0);
  const gp_Ax2 slanted(gp_Pnt(0, 0, 1), gp_Dir(-1, 0, 1), gp_Dir(1, 0, 1));
  return {
      {"a cap", disc(gp_Ax2(O, Z), 1), wall(gp_Ax3(O, Z), 1, 0, 2), 2 * kPi},
      {"a turned cap", disc(gp_Ax2(O, Z, turned), 1), wall(gp_Ax3(O, Z), 1, 0, 2), 2 * kPi},
      {"a cap of a turned wall", disc(gp_Ax2(O, Z), 1), wall(gp_Ax3(O, Z, turned), 1, 0, 2),
       2 * kPi},
      {"an oblique cap", disc(oblique, 10), wall(gp_Ax3(oblique), 10, 0, 20), 20 * kPi},
      {"a disc inside", disc(gp_Ax2(gp_Pnt(0, 0, 1), Z), 1), wall(gp_Ax3(O, Z), 1, 0, 2), 2 * kPi},
      {"a plate round the end", plate_with_hole(), wall(gp_Ax3(O, Z), 1, 0, 2), 2 * kPi},
      {"an ellipse", ellipse(slanted, std::sqrt(2.0), 1), wall(gp_Ax3(O, Z), 1, -1, 3),
       7.640395578055425},
      {"a disc in a ball", disc(gp_Ax2(gp_Pnt(0, 0, 0.6), Z), 0.8), ball(gp_Ax3(O, Z), 1),
       1.6 * kPi},
      {"a side of a triangle", triangle(), square_across(O, Y), 2},
  };
}

// Faces of one plane whose outlines meet in a point: no curve of the surfaces leads there.
TEST(TrimContacts, FacesInOnePlaneThatMeetInAPointHaveAContact) {
  const auto square = [](double low, double high) {
    return TopoDS_Face(BRepBuilderAPI_MakeFace(gp_Pln(), low, high, low, high));
  };
  const auto tip_at = [](double x) {
    return TopoDS_Face(BRepBuilderAPI_MakeFace(
        BRepBuilderAPI_MakePolygon(gp_Pnt(x, 0.4, 0), gp_Pnt(2, 0.1, 0), gp_Pnt(2, 0.9, 0), true)
            .Wire(),
        true));
  };
  const gp_Ax2 beside(gp_Pnt(1.5, 0.4, 0), Z, gp_Dir(std::cos(1.0), std::sin(1.0), 0));
  const auto round = [](const gp_Pnt& at) { return disc(gp_Ax2(at, Z), 1); };
  const struct {
    const char* name;
    TopoDS_Face a, b;
    Vec3 at;
    bool meet;
    Status status = Status::Complete;
  } rows[] = {
      {"corners", square(0, 1), square(1, 2), {1, 1, 0}, true},
      {"corners hardly apart", square(0, 1), square(1 + 1e-12, 2), {1, 1, 0}, true},
      {"corners hardly past", square(0, 1), square(1 - 1e-12, 2), {1, 1, 0}, true},
      {"corners nearly apart",
       square(0, 1),
       square(1 + 4e-8, 2),
       {1, 1, 0},
       true,
       Status::Tolerance},
      {"corners nearly past",
       square(0, 1),
       square(1 - 4e-8, 2),
       {1, 1, 0},
       true,
       Status::Tolerance},
      {"a tip at a side", square(0, 1), tip_at(1), {1, 0.4, 0}, true},
      {"a tip nearly at a side",
       square(0, 1),
       tip_at(1 + 5e-8),
       {1, 0.4, 0},
       true,
       Status::Tolerance},
      {"a tip nearly past a side",
       square(0, 1),
       tip_at(1 - 5e-8),
       {1, 0.4, 0},
       true,
       Status::Tolerance},
      {"a disc at a side", square(0, 1), disc(beside, 0.5), {1, 0.4, 0}, true},
      {"discs", round(O), round({2, 0, 0}), {1, 0, 0}, true},
      {"discs nearly apart", round(O), round({2 + 5e-8, 0, 0}), {1, 0, 0}, true, Status::Tolerance},
      {"discs apart", round(O), round({1.9, 0.9, 0}), {}, false},
      {"corners apart", square(0, 1), square(1.1, 2), {}, false},
  };
  for (const auto& row : rows)
    for (const bool swapped : {false, true}) {
      SCOPED_TRACE(std::string(row.name) + (swapped ? ", swapped" : ""));
      const ShapeIntersection all =
          swapped ? intersect({row.b}, {row.a}) : intersect({row.a}, {row.b});
      EXPECT_EQ(all.status, row.status);
      const SurfaceIntersection found =
          all.pairs.empty() ? SurfaceIntersection{} : all.pairs[0].found;
      EXPECT_TRUE(found.curves.empty() && found.overlaps.empty());
      ASSERT_EQ(found.points.size(), row.meet ? 1u : 0u);
      if (!row.meet) continue;
      EXPECT_LE(distance(found.points[0].point, row.at), 1e-6);
      for (const Place& place : found.places) EXPECT_EQ(place.gap_low, 0);
    }
}

// Edges of their own that are one with the common curve.
TEST(TrimContacts, ACurveAlongTheTrimsIsWhole) {
  for (const AlongTrims& row : runs())
    for (const bool swapped : {false, true}) {
      SCOPED_TRACE(std::string(row.name) + (swapped ? ", swapped" : ""));
      const ShapeIntersection all =
          swapped ? intersect({row.b}, {row.a}) : intersect({row.a}, {row.b});
      ASSERT_EQ(all.pairs.size(), 1u);
      const SurfaceIntersection& found = all.pairs[0].found;
      EXPECT_EQ(found.status, Status::Complete)
          << ::testing::PrintToString(found.certificate.reasons);
      EXPECT_GT(found.certificate.identified, 0);
      EXPECT_TRUE(found.points.empty() && found.nodes.empty());
      EXPECT_EQ(found.curves.size(), 1u);
      EXPECT_NEAR(total_length(found), row.length, 1e-6 * row.length);
    }
}

TEST(TrimContacts, ACurveBesideTheTrimsIsKnownWithinTolerance) {
  const TopoDS_Face round = wall(gp_Ax3(O, Z), 1, 0, 2);
  for (const double off : {-5e-8, 5e-8})
    for (const double z : {0.0, 1.0}) {
      const ShapeIntersection all = intersect({disc(gp_Ax2(gp_Pnt(0, 0, z), Z), 1 + off)}, {round});
      EXPECT_EQ(all.status, Status::Tolerance) << off << ' ' << z;
      ASSERT_EQ(all.pairs.size(), 1u);
      EXPECT_NEAR(total_length(all.pairs[0].found), 2 * kPi, 1e-6) << off << ' ' << z;
    }
}

// The first face of a shape that is not plane.
TopoDS_Face curved_face(const TopoDS_Shape& shape) {
  for (TopExp_Explorer part(shape, TopAbs_FACE); part.More(); part.Next())
    if (BRepAdaptor_Surface(TopoDS::Face(part.Current())).GetType() != GeomAbs_Plane)
      return TopoDS::Face(part.Current());
  return {};
}

TopoDS_Face bump() {
  TColgp_Array2OfPnt points(1, 5, 1, 5);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      points(i + 1, j + 1) = gp_Pnt(i - 2, j - 2, 0.3 * std::sin(i + 0.7 * j));
  return BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points).Surface(), 1e-7);
}

// A sheet swept along y.
TopoDS_Face swept() {
  TColgp_Array1OfPnt points(1, 4);
  points(1) = gp_Pnt(-2, -2, 0);
  points(2) = gp_Pnt(-0.5, -2, 1);
  points(3) = gp_Pnt(0.5, -2, -0.5);
  points(4) = gp_Pnt(2, -2, 0.3);
  return BRepBuilderAPI_MakeFace(
      new Geom_SurfaceOfLinearExtrusion(GeomAPI_PointsToBSpline(points).Curve(), gp_Dir(0, 1, 0.1)),
      0, 1, 0, 4, 1e-7);
}

// Cut out by a cylinder a face has an outline that touches its own box of parameters four times; on
// the cylinder's wall it is one curve.
TEST(TrimContacts, TheOutlineOfACurvedFaceIsWholeOnTheWallThatCutIt) {
  const gp_Ax2 place(gp_Pnt(0.1, 0.05, -6), Z, gp_Dir(std::cos(1.0), std::sin(1.0), 0));
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(place, 0.8, 20);
  const TopoDS_Face cone = BRepBuilderAPI_MakeFace(
      new Geom_ConicalSurface(gp_Ax3(gp_Pnt(-2, 0, -3), gp_Dir(1, 0, 0.1)), 0.4, 3), -1, 4, 0, 6,
      1e-7);
  for (const TopoDS_Face& whole : {bump(), swept(), cone}) {
    const TopoDS_Face face = curved_face(BRepAlgoAPI_Common(whole, drill).Shape());
    ASSERT_FALSE(face.IsNull());
    double length = 0;
    for (TopExp_Explorer part(face, TopAbs_EDGE); part.More(); part.Next())
      length += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(TopoDS::Edge(part.Current())), 1e-9);
    for (const bool swapped : {false, true}) {
      const TopoDS_Face round = wall(gp_Ax3(gp_Pnt(0.1, 0.05, -6), Z), 0.8, 0, 20);
      const ShapeIntersection all =
          swapped ? intersect({round}, {face}) : intersect({face}, {round});
      ASSERT_EQ(all.pairs.size(), 1u);
      EXPECT_EQ(all.pairs[0].chains.size(), 1u);
      EXPECT_TRUE(all.pairs[0].found.points.empty());
      EXPECT_NEAR(total_length(all.pairs[0].found), length, 1e-6 * length);
    }
  }
}

}  // namespace
}  // namespace blossom::occt
