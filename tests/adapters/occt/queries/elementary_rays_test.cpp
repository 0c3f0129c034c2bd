// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/elementary_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/ray_casting.h"

namespace blossom::occt {
namespace {

constexpr double kTolerance = 1e-7;

// A face on a surface that ends after one turn, or before, and has no period.
TopoDS_Face trimmed(const Handle(Geom_Surface) & surface, double v_from, double v_to) {
  constexpr double kPi = std::numbers::pi;
  const Handle(Geom_Surface) part =
      new Geom_RectangularTrimmedSurface(surface, kPi, 3 * kPi, v_from, v_to);
  EXPECT_FALSE(part->IsUPeriodic());
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(part, kTolerance).Face();
  EXPECT_EQ(BRep_Tool::Surface(face), part);
  return face;
}

// All kinds of faces, whole and in parts, with seams, poles and holes.
std::vector<TopoDS_Face> all_kinds() {
  const gp_Ax2 axes(gp_Pnt(0.3, -0.2, 0.1), gp_Dir(1, 2, 3));
  std::vector<TopoDS_Face> all;
  for (const TopoDS_Shape& shape :
       {BRepPrimAPI_MakeBox(1, 2, 3).Shape(), BRepPrimAPI_MakeCylinder(axes, 1, 2).Shape(),
        BRepPrimAPI_MakeCylinder(axes, 1, 2, 4).Shape(), BRepPrimAPI_MakeSphere(axes, 1.5).Shape(),
        BRepPrimAPI_MakeSphere(axes, 1.5, -0.5, 1, 5).Shape(),
        BRepPrimAPI_MakeTorus(axes, 2, 0.5).Shape(),
        BRepPrimAPI_MakeTorus(axes, 2, 0.5, 2.0).Shape(),
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, -1), gp_Pnt(2, 2, 1)).Shape(),
                        BRepPrimAPI_MakeCylinder(1, 1).Shape())
            .Shape()})
    for (const TopoDS_Face& face : faces_of(shape)) {
      all.push_back(face);
      all.push_back(TopoDS::Face(face.Reversed()));
    }
  const gp_Ax3 place(axes);
  all.push_back(trimmed(new Geom_CylindricalSurface(place, 1), -1, 1.5));
  all.push_back(trimmed(new Geom_SphericalSurface(place, 1.5), -0.5, 1));
  all.push_back(
      trimmed(new Geom_ToroidalSurface(place, 2, 0.5), std::numbers::pi, 3 * std::numbers::pi));
  return all;
}

TEST(ElementaryRays, AgreeWithTheSearchForAllHits) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-3, 3), direction(-1, 1);
  int asked = 0, answered = 0, met = 0;
  for (const TopoDS_Face& face : all_kinds()) {
    const auto quick = ElementaryFace::of(face, kTolerance);
    if (!quick) continue;
    const ShapeRays slow(std::vector{face}, kTolerance);
    for (int i = 0; i < 100; ++i) {
      const Ray ray{{place(random), place(random), place(random)},
                    {direction(random), direction(random), direction(random)},
                    i % 2 == 0 ? 0 : -std::numeric_limits<double>::infinity()};
      ++asked;
      auto hits = quick->hits(ray);
      if (!hits) continue;
      ++answered;
      std::ranges::sort(*hits, {}, &ElementaryFace::Hit::parameter);
      const std::vector<ShapeHit> expected = slow.all_hits(ray);
      ASSERT_EQ(hits->size(), expected.size());
      for (std::size_t k = 0; k < expected.size(); ++k, ++met) {
        EXPECT_NEAR((*hits)[k].parameter, expected[k].hit.parameter, 1e-9);
        EXPECT_LE(norm((*hits)[k].normal - expected[k].hit.normal), 1e-8);
      }
    }
  }
  EXPECT_GE(answered, 0.98 * asked);
  EXPECT_GE(met, 0.05 * asked);
}

TEST(ElementaryRays, SayNothingNearWiresAndWhereTheyAreTangent) {
  const auto top = [](const TopoDS_Shape& shape, int number) {
    return ElementaryFace::of(faces_of(shape)[static_cast<std::size_t>(number)], kTolerance);
  };
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  const auto side = top(cylinder, 0), disc = top(cylinder, 1);
  EXPECT_EQ(disc->hits({{1 - 1e-8, 0, 9}, {0, 0, -1}}), std::nullopt);
  EXPECT_EQ(disc->hits({{1 + 1e-8, 0, 9}, {0, 0, -1}}), std::nullopt);
  EXPECT_EQ(disc->hits({{1 - 1e-6, 0, 9}, {0, 0, -1}})->size(), 1U);
  EXPECT_EQ(disc->hits({{1 + 1e-6, 0, 9}, {0, 0, -1}})->size(), 0U);
  EXPECT_EQ(side->hits({{9, 0, 1}, {-1, 0, 0}}), std::nullopt);  // through the seam
  for (const double y : {1e-8, -1e-8}) EXPECT_EQ(side->hits({{9, y, 1}, {-1, 0, 0}}), std::nullopt);
  EXPECT_EQ(side->hits({{9, 1e-5, 1}, {-1, 0, 0}})->size(), 2U);
  for (const double y : {1 - 1e-9, 1.0, 1 + 1e-9})
    EXPECT_EQ(side->hits({{9, y, 1}, {-1, 0, 0.01}}), std::nullopt);
  EXPECT_EQ(side->hits({{9, 1.01, 1}, {-1, 0, 0.01}})->size(), 0U);
  EXPECT_EQ(side->hits({{0.5, 0, 1}, {0, 0, 1}}), std::nullopt);  // parallel to the axis
  EXPECT_EQ(disc->hits({{5, 0, 2}, {-1, 0, 1e-4}}), std::nullopt);
  const auto ball = top(BRepPrimAPI_MakeSphere(1).Shape(), 0);
  EXPECT_EQ(ball->hits({{0, 0, 9}, {0, 0, -1}}), std::nullopt);  // through the poles
  const auto ring = top(BRepPrimAPI_MakeTorus(2, 0.5).Shape(), 0);
  EXPECT_EQ(ring->hits({{2.3, -9, 0.1}, {0, 1, 0}})->size(), 2U);
  EXPECT_EQ(ring->hits({{2.5, -9, 0}, {0, 1, 0}}), std::nullopt);
  EXPECT_EQ(ring->hits({{0.1, -9, 0.1}, {0, 1, 0}})->size(), 4U);
}

TEST(ElementaryRays, AreForPlanesCylindersSpheresAndToriAlone) {
  for (const TopoDS_Face& face : faces_of(BRepPrimAPI_MakeCone(1, 2, 3).Shape()))
    EXPECT_EQ(ElementaryFace::of(face, kTolerance) == nullptr,
              BRep_Tool::Surface(face)->IsKind(STANDARD_TYPE(Geom_ConicalSurface)));
  EXPECT_EQ(ElementaryFace::of(faces_of(BRepPrimAPI_MakeTorus(1, 1).Shape())[0], kTolerance)
                ->hits({{5, 5, 5}, {-1, -1.1, -0.9}}),
            std::nullopt);
}

}  // namespace
}  // namespace blossom::occt
