// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips between faces of Open CASCADE.

#include "adapters/occt/strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;

/// [x, x + 1] x [0, 1] at z = 0.
TopoDS_Face square(double x) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3(gp_Pnt(x, 0, 0), gp::DZ(), gp::DX())), 0, 1, 0, 1);
}

/// Round the x axis, with its parameter v running down from x = `start`.
gp_Cylinder tube(double start, double radius) {
  return gp_Cylinder(gp_Ax3(gp_Pnt(start, 0, 0), gp_Dir(-1, 0, 0), gp_Dir(0, 1, 0)), radius);
}

/// The cylinder of radius 2 round the x axis, -6 <= x <= -4, over a range of its angle.
TopoDS_Face cylinder(double from, double to) {
  return BRepBuilderAPI_MakeFace(tube(-4, 2), from, to, 0, 2);
}

/// A wavy B-spline surface through 8 x 9 points, 0 <= x <= 3, -2 <= y <= 2.
Handle(Geom_BSplineSurface) waves() {
  TColgp_Array2OfPnt points(1, 8, 1, 9);
  for (int i = 1; i <= 8; ++i)
    for (int j = 1; j <= 9; ++j) {
      const double x = 3.0 * (i - 1) / 7, y = -2 + 4.0 * (j - 1) / 8;
      points(i, j) = gp_Pnt(x, y, 2 + 0.3 * std::sin(x) * std::cos(2 * y));
    }
  return GeomAPI_PointsToBSplineSurface(points, 3, 5, GeomAbs_C2, 1e-6).Surface();
}

TopoDS_Face face_on(const Handle(Geom_Surface) & surface) {
  return BRepBuilderAPI_MakeFace(surface, 1e-7);
}

gp_Dir normal_at(const Handle(Geom_Surface) & surface, double u, double v) {
  return GeomLProp_SLProps(surface, u, v, 1, 1e-12).Normal();
}

/// The angle between the tangent planes of a strip's border point and of the surface below it.
double angle_between(const Handle(Geom_Surface) & strip, double x, double y,
                     const Handle(Geom_Surface) & surface) {
  const GeomAPI_ProjectPointOnSurf foot(strip->Value(x, y), surface, 1e-12);
  double u = 0, v = 0;
  foot.LowerDistanceParameters(u, v);
  const double angle = normal_at(strip, x, y).Angle(normal_at(surface, u, v));
  return std::min(angle, kPi - angle);
}

FaceStripOptions between_sides(SurfaceSide a, SurfaceSide b) {
  return {.start_a = {.side = a}, .start_b = {.side = b}};
}

/// The disc of radius 1 round the x axis at x = 0, the outline starting at an angle to y.
TopoDS_Face disc(double start) {
  const gp_Ax2 frame(gp_Pnt(0, 0, 0), gp::DX(), gp_Dir(0, std::cos(start), std::sin(start)));
  return BRepBuilderAPI_MakeFace(
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(frame, 1)).Edge()).Wire(), true);
}

TopoDS_Edge edge_on(const Handle(Geom_Surface) & surface, const Handle(Geom2d_Curve) & curve,
                    double from, double to) {
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(curve, surface, from, to);
  BRepLib::BuildCurve3d(edge);
  return edge;
}

/// The waves on the side of small parameters of an arc from the middle of vmin to the middle of
/// umin, which is the first edge.
TopoDS_Face corner_of_waves() {
  const Handle(Geom_BSplineSurface) spline = waves();
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  spline->Bounds(u0, u1, v0, v1);
  const double r = std::min(u1 - u0, v1 - v0) / 2;
  const gp_Pnt2d corner(u0, v0), right(u0 + r, v0), up(u0, v0 + r);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(edge_on(spline, new Geom2d_Circle(gp_Ax2d(corner, gp::DX2d()), r), 0, kPi / 2));
  wire.Add(edge_on(spline, new Geom2d_Line(up, gp_Dir2d(0, -1)), 0, r));
  wire.Add(edge_on(spline, new Geom2d_Line(corner, gp_Dir2d(1, 0)), 0, r));
  return BRepBuilderAPI_MakeFace(spline, wire.Wire());
}

TopoDS_Edge first_edge(const TopoDS_Face& face) {
  return TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current());
}

TEST(FaceStrip, BetweenTwoSquaresInOnePlaneIsFlatAndValid) {
  const FaceStrip made = strip_between(square(0), square(3));

  EXPECT_EQ(made.ends[0].start.side, SurfaceSide::UMax);
  EXPECT_EQ(made.ends[1].start.side, SurfaceSide::UMin);
  EXPECT_TRUE(BRepCheck_Analyzer(made.face).IsValid());
  const gp_Pnt middle = made.surface->Value(0.5, 0.5);
  EXPECT_NEAR(middle.X(), 2, 1e-15);
  EXPECT_NEAR(middle.Z(), 0, 1e-15);
}

TEST(FaceStrip, JoinsARationalCylinderToABSpline) {
  const Handle(Geom_BSplineSurface) spline = waves();

  const FaceStrip made = strip_between(cylinder(0.4, 2.7), face_on(spline),
                                       between_sides(SurfaceSide::VMin, SurfaceSide::UMin));

  EXPECT_TRUE(BRepCheck_Analyzer(made.face).IsValid());
  EXPECT_TRUE(made.surface->IsURational());
  const Handle(Geom_Surface) round = new Geom_CylindricalSurface(tube(-4, 2));
  for (int k = 0; k <= 40; ++k) {
    const gp_Pnt first = made.surface->Value(k / 40.0, 0), last = made.surface->Value(k / 40.0, 1);
    EXPECT_NEAR(first.X(), -4, 1e-13);
    EXPECT_NEAR(std::hypot(first.Y(), first.Z()), 2, 1e-13);
    EXPECT_LE(angle_between(made.surface, k / 40.0, 0, round), 1e-9);
    EXPECT_LE(GeomAPI_ProjectPointOnSurf(last, spline, 1e-12).LowerDistance(), 1e-9);
    EXPECT_LE(angle_between(made.surface, k / 40.0, 1, spline), 1e-7);
  }
  for (const StripContact& contact : made.strip.contacts) {
    EXPECT_LE(contact.gap, 1e-13);
    EXPECT_LE(contact.normal_angle, 1e-12);
  }
}

TEST(FaceStrip, KeepsFewKnots) {
  const Handle(Geom_BSplineSurface) spline = waves();

  const FaceStrip made = strip_between(square(-3), face_on(spline),
                                       between_sides(SurfaceSide::UMax, SurfaceSide::UMin));

  ASSERT_EQ(made.surface->NbUKnots(), spline->NbVKnots());
  for (int k = 2; k < made.surface->NbUKnots(); ++k)
    EXPECT_LE(made.surface->UMultiplicity(k), spline->VMultiplicity(k)) << "knot " << k;
}

TEST(FaceStrip, FollowsTheFacesLocation) {
  gp_Trsf up;
  up.SetTranslation(gp_Vec(0, 0, 5));
  const TopoDS_Face moved = TopoDS::Face(square(3).Moved(TopLoc_Location(up)));

  const FaceStrip made = strip_between(square(0), moved);

  EXPECT_NEAR(made.surface->Value(0.3, 1).Z(), 5, 1e-14);
  EXPECT_LE(made.strip.contacts[1].normal_angle, 1e-12);
}

TEST(FaceStrip, TakesTheBordersOfTheTrimNotOfTheSurface) {
  const Handle(Geom_BSplineSurface) spline = waves();
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  spline->Bounds(u0, u1, v0, v1);
  const double cut = u0 + 0.4 * (u1 - u0);
  const TopoDS_Face part = BRepBuilderAPI_MakeFace(spline, u0, cut, v0, v1, 1e-7);

  const FaceStrip made = strip_between(part, square(8), {.start_a = {.side = SurfaceSide::UMax}});

  EXPECT_LE(made.surface->Value(0, 0).Distance(spline->Value(cut, v0)), 1e-12);
  EXPECT_LE(made.surface->Value(1, 0).Distance(spline->Value(cut, v1)), 1e-12);
}

TEST(FaceStrip, ASeamAndAPoleAreNoBorders) {
  EXPECT_EQ(open_sides(cylinder(0, 2 * kPi)), (std::vector{SurfaceSide::VMin, SurfaceSide::VMax}));
  const Handle(Geom_SphericalSurface) sphere = new Geom_SphericalSurface(gp_Ax3(), 1);
  const TopoDS_Face cap = BRepBuilderAPI_MakeFace(sphere, 0, 2 * kPi, 0.5, kPi / 2, 1e-7);
  EXPECT_EQ(open_sides(cap), std::vector{SurfaceSide::VMin});
}

TEST(FaceStrip, BetweenFullCylindersIsAClosedTube) {
  const TopoDS_Face wide = BRepBuilderAPI_MakeFace(tube(8, 3), 0, 2 * kPi, 0, 2);

  const FaceStrip made = strip_between(cylinder(0, 2 * kPi), wide);

  EXPECT_EQ(made.ends[0].start.side, SurfaceSide::VMin);
  EXPECT_EQ(made.ends[1].start.side, SurfaceSide::VMax);
  EXPECT_TRUE(made.surface->IsUClosed());
  EXPECT_TRUE(BRepCheck_Analyzer(made.face).IsValid());
}

TEST(FaceStrip, SaysWhyThereIsNone) {
  const auto message = [](const TopoDS_Face& a, const TopoDS_Face& b,
                          const FaceStripOptions& options) -> std::string {
    try {
      strip_between(a, b, options);
    } catch (const BadModel& error) {
      return error.what();
    }
    return "nothing was thrown";
  };

  EXPECT_EQ(message(cylinder(0, 2 * kPi), square(0), {.start_a = {.side = SurfaceSide::UMin}}),
            "face a has no edge along umin, it has vmin, vmax");
  EXPECT_EQ(message(square(0), square(4), {.start_a = {.edge = first_edge(square(4))}}),
            "the edge does not bound face a: a strip starts from one of the edges of its face");
  EXPECT_THROW(strip_between(square(0), square(1), {}), InvalidInput);
}

// A round pipe onto the rim of a disc: both ends are exact, and the outline's start does not twist
// it.
TEST(FaceStrip, StartsFromTheRimOfAPlaneExactly) {
  for (const double start : {0.0, 1.0, 4.0}) {
    for (const int order : {1, 2, 3}) {
      const TopoDS_Face rim = disc(start);

      const FaceStrip made = strip_between(cylinder(0, 2 * kPi), rim, {.strip = {.order = order}});

      EXPECT_EQ(made.ends[0].start.side, SurfaceSide::VMin);
      EXPECT_TRUE(made.ends[1].start.edge.IsSame(first_edge(rim)));
      EXPECT_TRUE(made.ends[1].exact);
      EXPECT_EQ(made.surface->VDegree(), 2 * order + 1);
      EXPECT_TRUE(made.surface->IsUClosed());
      EXPECT_TRUE(BRepCheck_Analyzer(made.face).IsValid());
      for (const StripContact& contact : made.strip.contacts) {
        EXPECT_LE(contact.gap, 1e-13);
        EXPECT_LE(contact.normal_angle, 1e-10);
        EXPECT_LE(contact.curvature, order == 1 ? HUGE_VAL : 1e-8);
      }
      for (int k = 0; k < 20; ++k) {
        const gp_Pnt a = made.surface->Value(k / 20.0, 0), b = made.surface->Value(k / 20.0, 1);
        EXPECT_GT((a.Y() * b.Y() + a.Z() * b.Z()) / 2, 0.99) << "twisted at " << k;
      }
    }
  }
}

TEST(FaceStrip, FollowsAnEdgeAcrossASurface) {
  const TopoDS_Face part = corner_of_waves();
  const TopoDS_Edge arc = first_edge(part);
  for (const TopoDS_Face& a : {part, TopoDS::Face(part.Reversed())}) {
    const FaceStrip made =
        strip_between(a, square(4), {.start_a = {.edge = arc}, .strip = {.order = 2}});

    EXPECT_FALSE(made.ends[0].exact);
    EXPECT_GT(made.ends[0].fit_error, 0);
    EXPECT_LE(made.ends[0].fit_error, 1e-10);
    EXPECT_TRUE(BRepCheck_Analyzer(made.face).IsValid());
    const StripContact& contact = made.strip.contacts[0];
    EXPECT_LE(contact.gap, 1e-10);
    EXPECT_LE(contact.normal_angle, 1e-7);
    EXPECT_LE(contact.curvature, 1e-4);
    // It leads away from the face: over the corner of the surface lies the face.
    const gp_Pnt inner = made.surface->Value(0.5, 0.02), edge = made.surface->Value(0.5, 0);
    const gp_Pnt corner = waves()->Pole(1, 1);
    EXPECT_GT(inner.Distance(corner), edge.Distance(corner));
  }
}

TEST(FaceStrip, RefusesAnEdgeWithACorner) {
  TColgp_Array1OfPnt points(1, 3);
  points(1) = gp_Pnt(0, 0, 0);
  points(2) = gp_Pnt(0.5, 1, 0);
  points(3) = gp_Pnt(1, 0, 0);
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger multiplicities(1, 3);
  for (int i = 1; i <= 3; ++i) {
    knots(i) = i;
    multiplicities(i) = i == 2 ? 1 : 2;
  }
  const Handle(Geom_Curve) roof = new Geom_BSplineCurve(points, knots, multiplicities, 1);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(roof).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(points(3), points(1)).Edge());
  const TopoDS_Face gable = BRepBuilderAPI_MakeFace(wire.Wire(), true);

  EXPECT_THROW(strip_between(gable, square(4), {.start_a = {.edge = first_edge(gable)}}), BadModel);
}

}  // namespace
}  // namespace blossom::occt
