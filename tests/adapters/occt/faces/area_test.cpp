// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/area.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeHalfSpace.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "core/math/functions/quadrature.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::kPi;

// A bicubic wave of 5 x 3 spans with simple knots.
TopoDS_Face wave() {
  TColgp_Array2OfPnt poles(1, 8, 1, 6);
  for (int i = 1; i <= 8; ++i)
    for (int j = 1; j <= 6; ++j) poles(i, j) = gp_Pnt(i, j, std::sin(1.3 * i * j));
  TColStd_Array1OfReal u(1, 6), v(1, 4);
  TColStd_Array1OfInteger mu(1, 6), mv(1, 4);
  for (int i = 1; i <= 6; ++i) u(i) = i * i, mu(i) = i == 1 || i == 6 ? 4 : 1;
  for (int i = 1; i <= 4; ++i) v(i) = i, mv(i) = i == 1 || i == 4 ? 4 : 1;
  return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(poles, u, v, mu, mv, 3, 3), 1e-7);
}

TEST(Area, OfElementaryFacesIsExactTo1e13) {
  const TopoDS_Face sphere = BRepBuilderAPI_MakeFace(new Geom_SphericalSurface(gp_Ax3(), 2), 1e-7);
  EXPECT_NEAR(area(sphere), 16 * kPi, 1e-13 * 16 * kPi);
  const TopoDS_Face torus = BRepBuilderAPI_MakeFace(new Geom_ToroidalSurface(gp_Ax3(), 3, 1), 1e-7);
  EXPECT_NEAR(area(torus), 12 * kPi * kPi, 1e-13 * 12 * kPi * kPi);
  const TopoDS_Face cone = BRepBuilderAPI_MakeFace(new Geom_ConicalSurface(gp_Ax3(), kPi / 6, 0), 0,
                                                   2 * kPi, 0, 2, 1e-7);
  EXPECT_NEAR(area(cone), 2 * kPi, 1e-12);  // slant 2, radius 1
}

// The top of a box is lifted by so much beside its edges, which keep their curves.
TEST(Area, OfConesOverFacesThatEndBesideTheirEdgesCountsWhatIsBetween) {
  const double lift = 0.003;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-1, -2, 0), gp_Pnt(9, 8, 10)).Shape();
  const BRep_Builder builder;
  for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (std::abs(surface->Value(0, 0).Z() - 10) > 1e-9 ||
        std::abs(surface->Value(1, 1).Z() - 10) > 1e-9)
      continue;
    const Handle(Geom_Geometry) lifted = surface->Translated(gp_Vec(0, 0, lift));
    builder.UpdateFace(face, Handle(Geom_Surface)::DownCast(lifted), TopLoc_Location(), 1e-7);
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
      builder.UpdateEdge(TopoDS::Edge(edge.Current()), 1.1 * lift);
  }
  for (const Vec3& apex : {Vec3{4, 3, 5}, Vec3{900, -300, 500}}) {
    double sum = 0, moment = 0;
    for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next()) {
      sum += cone_volume(TopoDS::Face(it.Current()), apex) +
             cone_volume_beside(TopoDS::Face(it.Current()), apex);
      moment += cone_moments(TopoDS::Face(it.Current()), apex).first[2];
    }
    EXPECT_NEAR(sum, 100 * (10 + lift), 1e-8);
    EXPECT_NEAR(moment, 100 * (10 + lift) * (0.5 * (10 + lift) - apex[2]), 1e-5);
  }
}

// Even lines (planes, cylinders, extrusions) and turning ones (cones, spheres, tori), cut across.
TEST(Area, OfConesOverTheFacesOfASolidIsItsVolume) {
  const auto volume = [](const TopoDS_Shape& solid) {
    double sum = 0;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
      sum += cone_volume(TopoDS::Face(it.Current()), {3, -2, 7});
    return sum;
  };
  const gp_Ax2 axes(gp_Pnt(0.3, -0.2, 0.1), gp_Dir(1, 2, 3));
  EXPECT_NEAR(volume(BRepPrimAPI_MakeBox(axes, 1, 2, 3).Shape()), 6, 1e-12);
  EXPECT_NEAR(volume(BRepPrimAPI_MakeCylinder(axes, 1, 2).Shape()), 2 * kPi, 1e-12);
  EXPECT_NEAR(volume(BRepPrimAPI_MakeCylinder(axes, 1, 2, 1.2).Shape()), 1.2, 1e-12);
  EXPECT_NEAR(volume(BRepPrimAPI_MakeCone(axes, 1, 2, 3).Shape()), 7 * kPi, 1e-12);
  EXPECT_NEAR(volume(BRepPrimAPI_MakeCone(axes, 1, 0, 3, 2.5).Shape()), 1.25, 1e-12);
  EXPECT_NEAR(volume(BRepPrimAPI_MakeSphere(axes, 1.5).Shape()), 4.5 * kPi, 1e-12);
  EXPECT_NEAR(volume(BRepPrimAPI_MakeTorus(axes, 2, 0.5).Shape()), kPi * kPi, 1e-12);
  EXPECT_NEAR(volume(BRepPrimAPI_MakeTorus(axes, 2, 0.5, 2.0).Shape()), kPi, 1e-12);
  // A cylinder with an oblique end is as large as one that ends at the height of its axis.
  const gp_Pln oblique(gp_Pnt(0, 0, 2), gp_Dir(0.3, 0.2, 1));
  const TopoDS_Shape above =
      BRepPrimAPI_MakeHalfSpace(BRepBuilderAPI_MakeFace(oblique), gp_Pnt(0, 0, 9)).Solid();
  EXPECT_NEAR(volume(BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(1, 5).Shape(), above).Shape()),
              2 * kPi, 1e-7);  // the oblique edge is within 1e-7 of an ellipse
}

TEST(Area, OfAFaceWithAHoleLeavesTheHoleOut) {
  const gp_Circ circle(gp_Ax2(gp_Pnt(2, 2, 0), gp_Dir(0, 0, -1)), 1);
  BRepBuilderAPI_MakeFace maker(gp_Pln(), 0, 4, 0, 4);
  maker.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)));
  EXPECT_NEAR(area(maker.Face()), 16 - kPi, 1e-13);
}

TEST(Area, DoesNotDependOnTheOrientation) {
  const TopoDS_Face face = wave();
  EXPECT_DOUBLE_EQ(area(face), area(TopoDS::Face(face.Reversed())));
}

TEST(Area, ChangesByLessThan1e10WhenCellsAreDivided) {
  const TopoDS_Face face = wave();
  const double found = area(face);
  for (const int cells : {2, 3, 5}) EXPECT_NEAR(area(face, cells), found, 1e-10 * found);
}

// A square that begins with a span as short as rounding, which would take its points far away if it
// went on. Between its sides its border in the chart is a parabola that leaves the surface.
TopoDS_Face strayed_square(double dip) {
  TColgp_Array2OfPnt poles(1, 2, 1, 7);
  const std::array along{0.0, 0.0, 0.0, 0.0, 0.3, 0.7, 1.0},
      above{0.0, 1e-3, -1e-3, 0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 7; ++j)
      poles(i + 1, j + 1) =
          gp_Pnt(i, along[static_cast<std::size_t>(j)], above[static_cast<std::size_t>(j)]);
  TColStd_Array1OfReal u(1, 2), v(1, 3);
  TColStd_Array1OfInteger mu(1, 2), mv(1, 3);
  u(1) = 0, u(2) = 1, mu(1) = mu(2) = 2;
  v(1) = -1e-8, v(2) = 0, v(3) = 1, mv(1) = mv(3) = 4, mv(2) = 3;
  const Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(poles, u, v, mu, mv, 1, 3);
  TColgp_Array1OfPnt2d border(1, 3);
  border(1) = gp_Pnt2d(0, -1e-8), border(2) = gp_Pnt2d(0.5, -1e-8 - dip),
  border(3) = gp_Pnt2d(1, -1e-8);
  BRepBuilderAPI_MakeWire wire(
      BRepBuilderAPI_MakeEdge(new Geom2d_BezierCurve(border), surface).Edge());
  const std::array corners{gp_Pnt2d(1, -1e-8), gp_Pnt2d(1, 1), gp_Pnt2d(0, 1), gp_Pnt2d(0, -1e-8)};
  for (std::size_t i = 0; i < 3; ++i)
    wire.Add(
        BRepBuilderAPI_MakeEdge(GCE2d_MakeSegment(corners[i], corners[i + 1]).Value(), surface));
  return BRepBuilderAPI_MakeFace(surface, wire.Wire());
}

TEST(Area, IsNoneBeyondTheBorderOfTheSurface) {
  EXPECT_NEAR(area(strayed_square(4e-7)), area(strayed_square(0)), 1e-9);
}

// The integral over the cells between knots, taken with Open CASCADE's derivatives.
double area_by_cells(const Geom_BSplineSurface& surface) {
  double sum = 0;
  const auto density = [&](double u, double v) {
    gp_Pnt point;
    gp_Vec du, dv;
    surface.D1(u, v, point, du, dv);
    return du.Crossed(dv).Magnitude();
  };
  for (int i = 1; i < surface.NbUKnots(); ++i)
    for (int j = 1; j < surface.NbVKnots(); ++j)
      sum += integral(
                 [&](double v) {
                   return integral([&](double u) { return density(u, v); }, surface.UKnot(i),
                                   surface.UKnot(i + 1), 1e-11)
                       .value;
                 },
                 surface.VKnot(j), surface.VKnot(j + 1), 1e-11)
                 .value;
  return sum;
}

TEST(Area, OfASplineIsTheSumOverItsCells) {
  const TopoDS_Face face = wave();
  const double expected =
      area_by_cells(*Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face)));
  EXPECT_NEAR(area(face), expected, 1e-10 * expected);
}

// The patches of a periodic spline go on over its seam.
TEST(Area, OfAPeriodicSplineDoesNotDependOnTheSeam) {
  Handle(Geom_BSplineSurface) tube =
      GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(
          new Geom_ToroidalSurface(gp_Ax3(), 3, 1), 0, 2 * kPi, 0, 2 * kPi));
  tube->SetUPeriodic();
  tube->SetVPeriodic();
  double u0, u1, v0, v1;
  tube->Bounds(u0, u1, v0, v1);
  const TopoDS_Face face =
      BRepBuilderAPI_MakeFace(tube, u0 + 0.3 * (u1 - u0), u0 + 1.3 * (u1 - u0), v0, v1, 1e-7);
  EXPECT_NEAR(area(face), 12 * kPi * kPi, 1e-11 * 12 * kPi * kPi);
}

// A value that is nothing but rounding has no digits to halve cells for.
TEST(ConeVolume, OfAFaceThroughTheApexIsNothing) {
  const gp_Pln plane(gp_Ax3(gp_Pnt(0.3, -0.2, 0.7), gp_Dir(1, 2, 3)));
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(plane, -1, 2, -1, 3);
  const gp_Pnt apex = plane.Location().Translated(0.7 * gp_Vec(plane.XAxis().Direction()));
  EXPECT_NEAR(cone_volume(face, {apex.X(), apex.Y(), apex.Z()}), 0, 1e-14);
}

// In the apex both the integrand and what its rounding is relative to are 0: no size may be taken
// from there alone, or cells are halved without end.
TEST(ConeVolume, FromTheMiddleOfATurnedDiscIsNone) {
  const gp_Ax2 axes(gp_Pnt(0.3, -0.7, 1.1), gp_Dir(0.2, 0.5, 1));
  const TopoDS_Face disc = BRepBuilderAPI_MakeFace(
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, 2)).Edge()).Wire(), true);
  EXPECT_NEAR(cone_volume(disc, {0.3, -0.7, 1.1}), 0, 1e-14);
}

}  // namespace
}  // namespace blossom::occt
