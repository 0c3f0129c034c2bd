// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/solid_rays.h"
#include "adapters/occt/intersection_edges.h"

#include <gtest/gtest.h>

#include <optional>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace blossom::occt {
namespace {

TEST(SolidRays, TellInsideFromOutside) {
  SolidRays box(faces_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape()), 1e-7);
  for (const Vec3& direction : kRayDirections) {
    EXPECT_EQ(box.is_inside({0.3, 0.4, 0.5}, direction), true);
    EXPECT_EQ(box.is_inside({-4, 0.4, 0.5}, direction), false);
  }
  SolidRays ball(faces_of(BRepPrimAPI_MakeSphere(2).Shape()), 1e-7);
  EXPECT_EQ(ball.is_inside({0.1, -0.2, 1.7}, kRayDirections[1]), true);
  EXPECT_EQ(ball.is_inside({0.1, -0.2, 2.1}, kRayDirections[1]), false);
}

TEST(SolidRays, SayNothingAtEdgesAndWhereTheyAreTangent) {
  SolidRays box(faces_of(BRepPrimAPI_MakeBox(1, 1, 1).Shape()), 1e-7);
  EXPECT_EQ(box.is_inside({0.5, 0.5, 0.25}, {1, 1, 0}), std::nullopt);
  EXPECT_EQ(box.is_inside({-1, 0.5, 1}, {1, 0, 0}), std::nullopt);
  SolidRays ball(faces_of(BRepPrimAPI_MakeSphere(1).Shape()), 1e-7);
  EXPECT_EQ(ball.is_inside({-3, 1, 0.3}, {1, 0, -0.1}), std::nullopt);  // touches in (0, 1, 0)
}

// An offset of a spline has no exact form: one within the tolerance stands for it.
TEST(SolidRays, PassThroughSurfacesThatAreApproximated) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 3; ++j) poles(i, j) = {i - 2.0, j - 2.0, i == 2 && j == 2 ? 1.0 : 0.0};
  const Handle(Geom_Surface) wave = new Geom_BezierSurface(poles);
  SolidRays rays({BRepBuilderAPI_MakeFace(new Geom_OffsetSurface(wave, 0.25), 1e-7).Face()}, 1e-7);
  EXPECT_EQ(rays.is_inside({0.2, 0.1, 0}, {0.1, 0.2, 1}), true);
  EXPECT_EQ(rays.is_inside({0.2, 0.1, 0}, {0.1, 0.2, -1}), false);
  EXPECT_EQ(rays.is_inside({-3, 0, 0.5}, {1, 0, 0}), std::nullopt);  // touches the top
}

TEST(SolidRays, SayNothingOfPointsOnFaces) {
  SolidRays box(faces_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape()), 1e-7);
  for (const Vec3& direction : kRayDirections)
    for (const double z : {3 - 1e-8, 3.0, 3 + 1e-8})
      EXPECT_EQ(box.is_inside({0.3, 0.4, z}, direction), std::nullopt);
  EXPECT_EQ(box.is_inside({0.3, 0.4, 3 - 1e-6}, kRayDirections[0]), true);
  EXPECT_EQ(box.is_inside({0.3, 0.4, 3 + 1e-6}, kRayDirections[0]), false);
}

TEST(SolidRays, TellWhichWayFacesAreTurned) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  const Vec3 inside{0.3, 0.4, 0.5};
  EXPECT_EQ(SolidRays(faces_of(box), 1e-7).leaves(inside, kRayDirections[0]), true);
  EXPECT_EQ(SolidRays(faces_of(box.Reversed()), 1e-7).leaves(inside, kRayDirections[0]), false);
  EXPECT_EQ(SolidRays(faces_of(box), 1e-7).leaves({9, 0, 0}, {0, 0, 1}), std::nullopt);
}

}  // namespace
}  // namespace blossom::occt
