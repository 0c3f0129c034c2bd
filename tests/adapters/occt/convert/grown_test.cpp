// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/convert/grown.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax3.hxx>

namespace blossom::occt {
namespace {

constexpr double kClose = 1e-12;

// (2 + t^2, 0, t) over [0, 1], in two spans: one polynomial, wherever it ends.
Handle(Geom_BSplineCurve) parabola() {
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = gp_Pnt(2, 0, 0);
  poles(2) = gp_Pnt(2, 0, 0.5);
  poles(3) = gp_Pnt(3, 0, 1);
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger counts(1, 2);
  counts.Init(3);
  const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(poles, knots, counts, 2);
  curve->InsertKnot(0.25);
  return curve;
}

gp_Pnt on_parabola(double t) { return gp_Pnt(2 + t * t, 0, t); }

TEST(GrownSurface, OfAnExtrusionGoesOnAsItsCurveDoes) {
  const Handle(Geom_Surface) surface =
      grown(new Geom_SurfaceOfLinearExtrusion(parabola(), gp::DY()), {{-1, 3}, {-5, 5}});
  for (const double t : {-1.0, -0.5, 0.1, 0.6, 2.0, 3.0})
    EXPECT_LT(surface->Value(t, 4).Distance(on_parabola(t).Translated(gp_Vec(0, 4, 0))), kClose);
}

TEST(GrownSurface, OfRevolutionGoesOnAlongItsMeridian) {
  const Handle(Geom_Surface) surface =
      grown(new Geom_SurfaceOfRevolution(parabola(), gp::OZ()), {{0, 1}, {-0.5, 1.5}});
  for (const double t : {-0.5, 0.3, 1.5})
    EXPECT_LT(surface->Value(1.2, t).Distance(on_parabola(t).Rotated(gp::OZ(), 1.2)), kClose);
}

// The offset of the extrusion of a parabola, by its normal.
TEST(GrownSurface, OfAnOffsetIsThatOfWhatIsLonger) {
  const Handle(Geom_Surface) basis = new Geom_SurfaceOfLinearExtrusion(parabola(), gp::DY());
  const Handle(Geom_Surface) surface =
      grown(new Geom_OffsetSurface(basis, 0.2), {{-0.5, 2}, {0, 1}});
  for (const double t : {-0.5, 0.3, 2.0}) {
    const gp_Vec normal = gp_Vec(2 * t, 0, 1).Crossed(gp_Vec(0, 1, 0)).Normalized();
    const gp_Pnt wanted = on_parabola(t).Translated(gp_Vec(0, 0.5, 0) + 0.2 * normal);
    EXPECT_LT(surface->Value(t, 0.5).Distance(wanted), kClose);
  }
}

TEST(GrownSurface, OfBezierFormAndTrimmedOnesKeepTheirParameters) {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (const int i : {1, 2})
    for (const int j : {1, 2}) poles(i, j) = gp_Pnt(i, j, i * j);
  const Handle(Geom_Surface) saddle = new Geom_BezierSurface(poles);
  const Handle(Geom_Surface) part = new Geom_RectangularTrimmedSurface(saddle, 0.2, 0.4, 0.2, 0.4);
  const Handle(Geom_Surface) surface = grown(part, {{-1, 2}, {-2, 1}});
  for (const auto& [u, v] : {std::array{-1.0, -2.0}, std::array{0.3, 0.3}, std::array{2.0, 1.0}})
    EXPECT_LT(surface->Value(u, v).Distance(gp_Pnt(1 + u, 1 + v, (1 + u) * (1 + v))), kClose);
}

TEST(GrownSurface, OfAnArcGoesOnAlongItsCircle) {
  const Handle(Geom_Curve) arc = new Geom_TrimmedCurve(new Geom_Circle(gp::XOY(), 3), 0.5, 1);
  const Handle(Geom_Surface) surface =
      grown(new Geom_SurfaceOfLinearExtrusion(arc, gp::DZ()), {{0.2, 2}, {0, 1}});
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  EXPECT_NEAR(u0, 0.2, kClose);
  EXPECT_NEAR(u1, 2, kClose);
  EXPECT_LT(surface->Value(2, 0).Distance(gp_Pnt(3 * std::cos(2), 3 * std::sin(2), 0)), kClose);
}

TEST(GrownSurface, StaysAsItIsWhereItHasAllOrHasNoBorders) {
  const Handle(Geom_Surface) extrusion = new Geom_SurfaceOfLinearExtrusion(parabola(), gp::DY());
  const std::vector<Handle(Geom_Surface)> all{extrusion, new Geom_Plane(gp::XOY()),
                                              new Geom_SphericalSurface(gp_Ax3(), 1)};
  for (const Handle(Geom_Surface) & each : all) EXPECT_EQ(grown(each, {{0, 1}, {0, 1}}), each);
  EXPECT_EQ(grown(all[2], {{0, 1}, {-3, 3}}), all[2]) << "it ends in poles";
}

}  // namespace
}  // namespace blossom::occt
