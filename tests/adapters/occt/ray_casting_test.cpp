// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/ray_casting.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BSplineSurface.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "tests/support/shapes.h"

namespace blossom::occt {
namespace {

using testing::random_point;
using testing::seeded;

TopoDS_Face plate_with_hole() {
  const gp_Circ circle(gp_Ax2(gp_Pnt(2, 2, 0), gp_Dir(0, 0, -1)), 1);
  BRepBuilderAPI_MakeFace maker(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4).Face());
  maker.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)));
  return maker.Face();
}

TopoDS_Shape drilled_box() {
  return BRepAlgoAPI_Cut(
             BRepPrimAPI_MakeBox(4, 4, 4).Shape(),
             BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(2, 2, -1), gp_Dir(0, 0, 1)), 1, 6).Shape())
      .Shape();
}

Ray down(double x, double y) { return {{x, y, 3}, {0, 0, -1}}; }

TEST(ShapeRays, HitsATrimmedFaceOnlyInsideItsTrims) {
  const ShapeRays rays(plate_with_hole());
  EXPECT_EQ(rays.all_hits(down(0.5, 0.5)).size(), 1u);
  EXPECT_EQ(rays.all_hits(down(2, 2)).size(), 0u);
  EXPECT_EQ(rays.all_hits(down(2.9, 2.3)).size(), 0u);
  EXPECT_EQ(rays.all_hits(down(2.95, 2.5)).size(), 1u);
  EXPECT_EQ(rays.all_hits(down(4.1, 2)).size(), 0u);
}

TEST(ShapeRays, DecidesCloseToACurvedTrim) {
  const ShapeRays rays(plate_with_hole());
  auto random = seeded(1);
  for (int i = 0; i < 200; ++i) {
    const double angle = testing::uniform(random, 0, 7);
    for (const double off : {-1e-3, -1e-6, 1e-6, 1e-3}) {
      const Ray ray = down(2 + (1 + off) * std::cos(angle), 2 + (1 + off) * std::sin(angle));
      EXPECT_EQ(rays.all_hits(ray).size(), off > 0 ? 1u : 0u) << angle << " " << off;
    }
    const std::vector<ShapeHit> on = rays.all_hits(down(2 + std::cos(angle), 2 + std::sin(angle)));
    ASSERT_EQ(on.size(), 1u);
    ASSERT_FALSE(on[0].on.IsNull());
    EXPECT_EQ(on[0].on.ShapeType(), TopAbs_EDGE);
    EXPECT_EQ(on[0].hit.status, Status::Complete);
  }
}

TEST(ShapeRays, TurnsNormalsWithTheirFaces) {
  const TopoDS_Face plate = plate_with_hole();
  const Vec3 normal = ShapeRays(plate).all_hits(down(0.5, 0.5))[0].hit.normal;
  const Vec3 turned = ShapeRays(plate.Reversed()).all_hits(down(0.5, 0.5))[0].hit.normal;
  EXPECT_EQ(turned, -normal);
}

TEST(ShapeRays, HitsEdgesAndVerticesOnceAndNamesThem) {
  const ShapeRays rays(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  const Vec3 inside{0.4, 0.3, 0.2};
  for (const Vec3& target : {Vec3{1, 1, 0.5}, Vec3{0, 0.25, 1}, Vec3{1, 1, 1}, Vec3{0, 1, 0}}) {
    const std::vector<ShapeHit> hits = rays.all_hits({inside, target - inside});
    ASSERT_EQ(hits.size(), 1u);
    const bool corner = target[0] == std::round(target[0]) && target[1] == std::round(target[1]) &&
                        target[2] == std::round(target[2]);
    ASSERT_FALSE(hits[0].on.IsNull());
    EXPECT_EQ(hits[0].on.ShapeType(), corner ? TopAbs_VERTEX : TopAbs_EDGE);
    EXPECT_EQ(hits[0].hit.status, Status::Complete);
    EXPECT_LE(distance(hits[0].hit.point, target), 1e-12);
  }
  EXPECT_TRUE(rays.all_hits({inside, {1, 0, 0}})[0].on.IsNull());
}

TEST(ShapeRays, ClipsAStretchInAFaceToItsTrims) {
  const std::vector<ShapeHit> hits = ShapeRays(plate_with_hole()).all_hits({{-1, 2, 0}, {1, 0, 0}});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].hit.first, 1, 1e-6);
  EXPECT_NEAR(hits[0].hit.last, 2, 1e-6);
  EXPECT_NEAR(hits[1].hit.first, 4, 1e-6);
  EXPECT_NEAR(hits[1].hit.last, 5, 1e-6);
  EXPECT_EQ(hits[0].hit.status, Status::Tolerance);
}

// Two spans of degree 2 that meet at x = 1, bent there.
TopoDS_Face two_spans() {
  TColgp_Array2OfPnt poles(1, 5, 1, 2);
  const std::array<double, 5> heights{0, 0.5, 0, 0.5, 0};
  for (int i = 1; i <= 5; ++i)
    for (int j = 1; j <= 2; ++j)
      poles(i, j) = {0.5 * (i - 1), j - 1.0, heights.at(static_cast<std::size_t>(i - 1))};
  TColStd_Array1OfReal u(1, 3), v(1, 2);
  TColStd_Array1OfInteger mu(1, 3), mv(1, 2);
  for (int i = 1; i <= 3; ++i) u(i) = i, mu(i) = i == 2 ? 2 : 3;
  for (int i = 1; i <= 2; ++i) v(i) = i, mv(i) = 2;
  return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(poles, u, v, mu, mv, 2, 1), 1e-7).Face();
}

TEST(ShapeRays, HitsTheJointOfPatchesOnce) {
  const ShapeRays rays(two_spans());
  for (const double y : {0.25, 0.5, 0.7}) {
    const std::vector<ShapeHit> hits = rays.all_hits(Ray{{0.9, y, 3}, {0.1, 0, -3}});
    ASSERT_EQ(hits.size(), 1u) << y;
    EXPECT_EQ(hits[0].hit.status, Status::Complete);
    EXPECT_TRUE(hits[0].on.IsNull());
    EXPECT_EQ(rays.all_hits(down(1, y)).size(), 1u) << y;
  }
}

TEST(ShapeRays, HitsTheJointOfPatchesOnceBesideAWideEdge) {
  const TopoDS_Face face = two_spans();
  ShapeFix_ShapeTolerance().SetTolerance(face, 1e-2, TopAbs_EDGE);
  const std::vector<ShapeHit> hits = ShapeRays(face).all_hits(down(1, 5e-3));
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].hit.status, Status::Complete);
  EXPECT_TRUE(hits[0].on.IsNull());
}

TEST(ShapeRays, ClosesTheGapsThatToleranceOfEdgesCovers) {
  // A table whose edges have a tolerance of 1e-3.
  const TopoDS_Face table = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1);
  ShapeFix_ShapeTolerance().SetTolerance(table, 1e-3, TopAbs_EDGE);
  const ShapeRays rays(table);
  const std::vector<ShapeHit> hits = rays.all_hits(down(1 + 5e-4, 0.5));
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].hit.status, Status::Tolerance);
  EXPECT_EQ(hits[0].on.ShapeType(), TopAbs_EDGE);
  EXPECT_TRUE(rays.all_hits(down(1 + 2e-3, 0.5)).empty());
}

TEST(ShapeRays, EntersAndLeavesSolidsInTurn) {
  const std::array<TopoDS_Shape, 6> solids{BRepPrimAPI_MakeBox(gp_Pnt(-2, -1, -1), 4, 2, 2).Shape(),
                                           BRepPrimAPI_MakeSphere(2).Shape(),
                                           BRepPrimAPI_MakeTorus(2, 0.75).Shape(),
                                           BRepPrimAPI_MakeCone(2, 0, 3).Shape(),
                                           BRepPrimAPI_MakeCylinder(1, 3).Shape(),
                                           drilled_box()};
  auto random = seeded(7);
  for (const TopoDS_Shape& solid : solids) {
    const ShapeRays rays(solid);
    std::vector<Ray> lines;
    for (int i = 0; i < 1000; ++i)
      lines.push_back({3 * random_point(random), random_point(random), -kInfinity, kInfinity});
    std::size_t total = 0;
    for (const std::vector<ShapeHit>& hits : rays.all_hits(lines)) {
      ASSERT_EQ(hits.size() % 2, 0u);
      total += hits.size();
    }
    EXPECT_GT(total, 300u);
    for (const Ray& line : lines) {
      const std::vector<ShapeHit> hits = rays.all_hits(line);
      for (std::size_t k = 0; k < hits.size(); ++k) {
        EXPECT_EQ(hits[k].hit.status, Status::Complete);
        EXPECT_LT(dot(hits[k].hit.normal, line.direction) * (k % 2 == 0 ? 1 : -1), 0);
      }
      const std::vector<ShapeHit> first = rays.first_hits(line);
      ASSERT_EQ(first.size(), std::min<std::size_t>(hits.size(), 1));
      if (!hits.empty()) {
        EXPECT_EQ(first[0].hit.parameter, hits[0].hit.parameter);
      }
    }
  }
}

TEST(ShapeRays, NamesTheFaceThatCannotBeUsed) {
  try {
    const ShapeRays rays(std::vector{plate_with_hole(), TopoDS_Face()});
    FAIL() << "a face without a surface was taken";
  } catch (const BadModel& error) {
    EXPECT_EQ(std::string(error.what()).rfind("face 2: ", 0), 0u) << error.what();
  }
}

TEST(ShapeRays, RefusesShapesWithoutFaces) {
  EXPECT_THROW(ShapeRays{TopoDS_Shape()}, BadModel);
  EXPECT_THROW(ShapeRays(std::vector<TopoDS_Face>{}), BadModel);
  EXPECT_THROW(ShapeRays(plate_with_hole(), 0), InvalidInput);
  EXPECT_THROW(ShapeRays(plate_with_hole()).all_hits({{0, 0, 0}, {0, 0, 0}}), InvalidInput);
}

TEST(ShapeRays, StretchInAFaceIsKnownByWhereItBegins) {
  const ShapeRays rays(BRepPrimAPI_MakeBox(10, 10, 10).Shape());
  const Ray along_top{{-5, 5, 10}, {1, 0, 0}};
  const auto all = rays.all_hits(along_top), first = rays.first_hits(along_top);
  ASSERT_EQ(all.size(), 1u);
  ASSERT_FALSE(first.empty());
  EXPECT_NEAR(all.front().hit.parameter, 5, 1e-7);
  EXPECT_EQ(all.front().hit.surface, first.front().hit.surface);
}

}  // namespace
}  // namespace blossom::occt
