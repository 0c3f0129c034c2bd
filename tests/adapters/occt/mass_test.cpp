// SPDX-License-Identifier: LGPL-2.1-or-later
// Masses of bodies against closed forms.
#include "adapters/occt/mass.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BSplCLib.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAPI.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <gp.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/faces/area.h"

namespace blossom::occt {
namespace {

using std::numbers::pi;

gp_Trsf moved(double x, double y, double z) {
  gp_Trsf placement;
  placement.SetTranslation(gp_Vec(x, y, z));
  return placement;
}

gp_Trsf turned(const gp_Dir& axis, double angle) {
  gp_Trsf placement;
  placement.SetRotation(gp_Ax1(gp::Origin(), axis), angle);
  return placement;
}

TopoDS_Shape placed(const TopoDS_Shape& shape, const gp_Trsf& placement) {
  return BRepBuilderAPI_Transform(shape, placement, Standard_True).Shape();
}

void expect_mass(const TopoDS_Shape& body, double area, double volume, const Vec3& centre,
                 const Vec<double, 6>& inertia) {
  const Mass mass = mass_of(body);
  EXPECT_NEAR(mass.area, area, 1e-9 * area);
  EXPECT_NEAR(mass.volume, volume, 1e-9 * volume);
  EXPECT_LT(norm(mass.centre - centre), 1e-9 * (norm(centre) + std::cbrt(volume)));
  const double largest = std::abs(inertia[0]) + std::abs(inertia[1]) + std::abs(inertia[2]);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(mass.inertia[k], inertia[k], 1e-9 * largest) << k;
}

TEST(Mass, OfABoxIsThatOfTheTextbook) {
  expect_mass(BRepPrimAPI_MakeBox(gp_Pnt(1, 2, 3), 2, 3, 4).Shape(), 52, 24, {2, 3.5, 5},
              {24 * (9 + 16) / 12., 24 * (4 + 16) / 12., 24 * (4 + 9) / 12., 0, 0, 0});
}

TEST(Mass, OfACylinderABallAConeAndATorusIsThatOfTheTextbook) {
  const double v = pi * 4 * 6;
  expect_mass(placed(BRepPrimAPI_MakeCylinder(2, 6).Shape(), moved(5, 0, -1)), 2 * pi * 2 * (2 + 6),
              v, {5, 0, 2}, {v * (3 * 4 + 36) / 12, v * (3 * 4 + 36) / 12, v * 4 / 2, 0, 0, 0});
  const double ball = 4 * pi / 3 * 27;
  expect_mass(placed(BRepPrimAPI_MakeSphere(3).Shape(), moved(-4, 7, 1)), 36 * pi, ball, {-4, 7, 1},
              {ball * 3.6, ball * 3.6, ball * 3.6, 0, 0, 0});
  const double cone = pi * 4 * 5 / 3;
  expect_mass(BRepPrimAPI_MakeCone(2, 0, 5).Shape(), pi * 2 * (2 + std::sqrt(29.0)), cone,
              {0, 0, 1.25},
              {cone * (0.15 * 4 + 25 * 3 / 80.), cone * (0.15 * 4 + 25 * 3 / 80.), cone * 0.3 * 4,
               0, 0, 0});
  const double torus = 2 * pi * pi * 5;
  expect_mass(
      BRepPrimAPI_MakeTorus(5, 1).Shape(), 4 * pi * pi * 5, torus, {0, 0, 0},
      {torus * (25 / 2. + 5 / 8.), torus * (25 / 2. + 5 / 8.), torus * (25 + 3 / 4.), 0, 0, 0});
}

TEST(Mass, OfSplinesIsThatOfWhatTheyStandFor) {
  const double v = pi * 4 * 6;
  BRepBuilderAPI_NurbsConvert splines(BRepPrimAPI_MakeCylinder(2, 6).Shape());
  expect_mass(splines.Shape(), 2 * pi * 2 * (2 + 6), v, {0, 0, 3},
              {v * (3 * 4 + 36) / 12, v * (3 * 4 + 36) / 12, v * 4 / 2, 0, 0, 0});
}

// Booleans leave parts of such edges. Open CASCADE finds no spans of them there, and no length;
// strips beside edges are measured where these state to be off their faces.
TEST(Mass, OfAPeriodicSplineInAnyPeriodIsTheSame) {
  const auto circle = GeomConvert::CurveToBSplineCurve(new Geom_Circle(gp::XOY(), 2));
  const std::array ends{-3.0, -2.6, -0.6, 1.5, 2 * pi - 3};
  const BRep_Builder builder;
  BRepBuilderAPI_MakeWire wire;
  std::vector<TopoDS_Edge> edges;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    wire.Add(BRepBuilderAPI_MakeEdge(circle, ends[i], ends[i + 1]));
    edges.push_back(wire.Edge());  // of the first period
  }
  const TopoDS_Face disc = BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire()).Face();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    builder.Range(edges[i], ends[i], ends[i + 1]);
    const gp_Pnt from = circle->Value(ends[i]), to = circle->Value(ends[i + 1]);
    const double length = 2 * gp_Vec(gp_Pnt(), from).Angle(gp_Vec(gp_Pnt(), to));
    EXPECT_NEAR(edge_length(edges[i]), length, 1e-9) << i;
    const Handle(Geom2d_BSplineCurve) image = Geom2dConvert::CurveToBSplineCurve(
        new Geom2d_TrimmedCurve(GeomAPI::To2d(circle, gp_Pln()), ends[i], ends[i + 1]));
    TColStd_Array1OfReal knots(1, image->NbKnots());
    image->Knots(knots);
    BSplCLib::Reparametrize(ends[i], ends[i + 1], knots);
    image->SetKnots(knots);  // without a period
    builder.UpdateEdge(edges[i], image, disc, 2e-5);
  }
  EXPECT_NEAR(cone_volume(disc, {0, 0, 3}), -4 * pi, 1e-9);
  EXPECT_NEAR(cone_volume_beside(disc, {0, 0, 3}), 0, 1e-9);
}

TEST(Mass, ATurnedBoxHasProductsOfInertia) {
  // Turned by 45 degrees about z, the moments a and b about x and y become their mean, and the
  // product is minus the integral of x y = (b - a) / 2.
  const double a = 24 * (9 + 16) / 12., b = 24 * (4 + 16) / 12., c = 24 * (4 + 9) / 12.;
  const TopoDS_Shape box =
      placed(BRepPrimAPI_MakeBox(gp_Pnt(-1, -1.5, -2), 2, 3, 4).Shape(), turned(gp::DZ(), pi / 4));
  const double product = (a - b) / 2;
  expect_mass(placed(box, moved(100, 200, -300)), 52, 24, {100, 200, -300},
              {(a + b) / 2, (a + b) / 2, c, product, 0, 0});
}

TEST(Mass, OfAHollowBodyIsTheDifferenceAndOfTwoBodiesTheSum) {
  const TopoDS_Shape outer = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 4, 4, 4).Shape();
  const TopoDS_Shape inner = BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 1), 1, 2, 2).Shape();
  TopoDS_Solid hollow;
  BRep_Builder builder;
  builder.MakeSolid(hollow);
  builder.Add(hollow, TopExp_Explorer(outer, TopAbs_SHELL).Current());
  builder.Add(hollow, TopExp_Explorer(inner, TopAbs_SHELL).Current().Reversed());
  const Mass whole = mass_of(hollow);
  EXPECT_NEAR(whole.volume, 60, 1e-10);
  EXPECT_NEAR(whole.area, 96 + 16, 1e-10);

  Mass sum = whole;
  sum += mass_of(inner);
  const Mass full = mass_of(outer);
  EXPECT_NEAR(sum.volume, full.volume, 1e-10);
  EXPECT_LT(norm(sum.centre - full.centre), 1e-12);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(sum.inertia[k], full.inertia[k], 1e-9) << k;
}

TEST(Mass, OfASurfaceIsItsAreaAndItsCentre) {
  const TopoDS_Face rectangle = BRepBuilderAPI_MakeFace(gp_Pln(), 1, 3, 0, 6).Face();
  const TopoDS_Shape shell =
      TopExp_Explorer(BRepPrimAPI_MakeSphere(2).Shape(), TopAbs_FACE).Current();
  const Mass flat = mass_of(rectangle), round = mass_of(shell);
  EXPECT_FALSE(flat.is_solid);
  EXPECT_EQ(flat.volume, 0);
  EXPECT_NEAR(flat.area, 12, 1e-12);
  EXPECT_LT(norm(flat.centre - Vec3{2, 3, 0}), 1e-12);
  EXPECT_FALSE(round.is_solid);
  EXPECT_NEAR(round.area, 16 * pi, 1e-10);
  EXPECT_LT(norm(round.centre), 1e-10);
}

TEST(Mass, OfAFaceTurnedInwardsIsNegative) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  EXPECT_NEAR(mass_of(box.Reversed()).volume, -6, 1e-12);
}

TEST(Mass, EndsWithItsLimit) {
  const std::function<bool()> cancelled = [] { return true; };
  const WorkLimit limit(0, cancelled);
  EXPECT_THROW(mass_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), &limit), LimitFailure);
}

}  // namespace
}  // namespace blossom::occt
