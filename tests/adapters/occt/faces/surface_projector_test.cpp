// SPDX-License-Identifier: LGPL-2.1-or-later
// Feet of points on surfaces: the same with and without a place near them.
#include "adapters/occt/faces/surface_projector.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include <BRep_Builder.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Ax3.hxx>

namespace blossom::occt {
namespace {

TopoDS_Face bare(const Handle(Geom_Surface) & surface) {
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, surface, Precision::Confusion());
  return face;
}

// A bicubic wave over the unit square.
Handle(Geom_Surface) wave_surface() {
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 1; i <= 4; ++i)
    for (int k = 1; k <= 4; ++k)
      poles(i, k) = {(i - 1) / 3.0, (k - 1) / 3.0, (i + k) % 2 == 0 ? 0.2 : -0.2};
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(4);
  return new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3);
}

Vec3 on(const SurfaceProjector& feet, const Vec2& uv) { return frame_at(feet.surface(), uv).point; }

TEST(SurfaceProjector, FindsAPointOfTheSurfaceFromAPlaceNearIt) {
  const SurfaceProjector feet(bare(wave_surface()), Precision::Confusion());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.05, 0.95), aside(-0.05, 0.05);
  for (int i = 0; i < 200; ++i) {
    const Vec2 uv{part(random), part(random)};
    const Vec2 found = feet.foot(on(feet, uv), uv + Vec2{aside(random), aside(random)});
    EXPECT_LT(norm(found - uv), 1e-12) << uv[0] << " " << uv[1];
  }
}

TEST(SurfaceProjector, FindsThePointWhateverPlaceIsGiven) {
  const SurfaceProjector feet(bare(wave_surface()), Precision::Confusion());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(0, 1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 point = on(feet, {part(random), part(random)});
    EXPECT_LT(feet.gap(point, feet.foot(point, Vec2{part(random), part(random)})), 1e-9);
  }
}

// A point off the surface has one nearest point, not the next one by.
TEST(SurfaceProjector, SearchesAllOfTheSurfaceForPointsThatAreNotOnIt) {
  const SurfaceProjector feet(bare(wave_surface()), Precision::Confusion());
  const Vec3 above{0.3, 0.6, 0.7};
  const Vec2 wanted = feet.foot(above, {});
  for (const Vec2& near : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}})
    EXPECT_LT(norm(feet.foot(above, near) - wanted), 1e-9);
}

TEST(SurfaceProjector, KeepsToThePeriodOfThePlaceNearIt) {
  const Handle(Geom_Surface) torus = new Geom_ToroidalSurface(gp_Ax3(), 5, 1);
  const SurfaceProjector feet(bare(torus), Precision::Confusion());
  const double turn = 2 * std::numbers::pi;
  for (const double u : {-1.0, 0.5, 3.0})
    for (const double shift : {-turn, 0.0, turn}) {
      const Vec2 uv{u + shift, 0.7};
      EXPECT_LT(norm(feet.foot(on(feet, uv), uv + Vec2{0.2, -0.1}) - uv), 1e-12);
    }
}

}  // namespace
}  // namespace blossom::occt
