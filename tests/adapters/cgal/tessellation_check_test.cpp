// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL judges the facets of solids: closed, turned outwards, nothing crosses, volume.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <numbers>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Trsf.hxx>

#include "adapters/cgal/gpl/mesh_check.h"
#include "adapters/occt/tessellation.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom {
namespace {

constexpr double kPi = std::numbers::pi;

struct Judged {
  cgal::MeshCheck check;
  double distance = 0;
  std::size_t triangles = 0;
};

Judged judged(const TopoDS_Shape& shape, const FacetOptions& options) {
  const occt::ShapeTessellation made = occt::tessellation(shape, options);
  for (const MeshedFace& face : made.facets.faces) {
    EXPECT_EQ(face.obstacle, "");
    EXPECT_EQ(face.folded, 0);
  }
  const auto triangles = occt::triangles_of(made);
  return {cgal::check_mesh(made.facets.points, triangles), made.facets.distance, triangles.size()};
}

void expect_sound(const TopoDS_Shape& shape, double volume, double area) {
  for (const double deviation : {0.5, 0.05, 0.005}) {
    const Judged mesh = judged(shape, {.deviation = deviation});
    EXPECT_TRUE(mesh.check.closed) << deviation;
    EXPECT_EQ(mesh.check.self_intersections, 0) << deviation;
    EXPECT_EQ(mesh.check.degenerate_triangles, 0) << deviation;
    EXPECT_LE(mesh.distance, deviation * (1 + 1e-9));
    EXPECT_NEAR(mesh.check.volume, volume, area * mesh.distance + 1e-9 * volume);
  }
}

TEST(TessellationByCgal, OfABoxHasTwelveTriangles) {
  const Judged mesh = judged(BRepPrimAPI_MakeBox(3, 4, 5), {});
  EXPECT_TRUE(mesh.check.closed);
  EXPECT_EQ(mesh.triangles, 12u);
  EXPECT_DOUBLE_EQ(mesh.check.volume, 60);
  EXPECT_NEAR(mesh.distance, 0, 1e-12);
}

TEST(TessellationByCgal, OfElementarySolidsIsSound) {
  expect_sound(BRepPrimAPI_MakeCylinder(5, 12), 25 * kPi * 12, 2 * kPi * 5 * 17);
  expect_sound(BRepPrimAPI_MakeSphere(5), 4.0 / 3 * kPi * 125, 4 * kPi * 25);
  expect_sound(BRepPrimAPI_MakeCone(5, 0, 12), kPi * 25 * 12 / 3, kPi * 5 * 18);
  expect_sound(BRepPrimAPI_MakeCone(5, 2, 12), kPi * 12 / 3 * 39, kPi * (7 * 12.4 + 29));
  expect_sound(BRepPrimAPI_MakeTorus(8, 2), 2 * kPi * kPi * 8 * 4, 4 * kPi * kPi * 16);
}

TEST(TessellationByCgal, OfAMirroredSolidIsTurnedOutwards) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)));
  const TopoDS_Shape mirrored =
      BRepBuilderAPI_Transform(BRepPrimAPI_MakeCylinder(5, 12), mirror, true).Shape();
  const Judged mesh = judged(mirrored, {.deviation = 0.05});
  EXPECT_TRUE(mesh.check.closed);
  EXPECT_NEAR(mesh.check.volume, 25 * kPi * 12, 20);
}

TEST(TessellationByCgal, OfADrilledAndRoundedBlockIsSound) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(20, 20, 10);
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(10, 10, -1), gp_Dir(0.2, 0, 1)), 4, 14);
  const TopoDS_Shape drilled = BRepAlgoAPI_Cut(block, drill);
  BRepFilletAPI_MakeFillet fillet(drilled);
  int count = 0;
  for (TopExp_Explorer it(drilled, TopAbs_EDGE); it.More() && count < 4; it.Next(), ++count)
    fillet.Add(1.5, TopoDS::Edge(it.Current()));
  const TopoDS_Shape rounded = fillet.Shape();
  for (const double deviation : {0.2, 0.02, 0.002}) {
    const Judged mesh = judged(rounded, {.deviation = deviation});
    EXPECT_TRUE(mesh.check.closed) << deviation;
    EXPECT_EQ(mesh.check.self_intersections, 0) << deviation;
    EXPECT_LE(mesh.distance, deviation * 1.01);
  }
}

// Closed models are closed meshes in which nothing crosses.
TEST(TessellationByCgal, OfClosedModelsIsSound) {
  const char* const data = blossom::testing::test_data();
  if (!data) GTEST_SKIP() << blossom::testing::kNoTestData;
  for (const char* name : {"ball.brep", "boxed_sphere.step", "crankarm.brep",
                           "s1_mainbody_back.stp", "d150_wing.brep", "d150_fused.brep"}) {
    const occt::Model model =
        testing::repaired_model(std::filesystem::path(data) / "models" / name);
    const occt::ShapeTessellation made = occt::tessellation(model.shape(), {.deviation = 0.05});
    const cgal::MeshCheck check = cgal::check_mesh(made.facets.points, occt::triangles_of(made));
    EXPECT_TRUE(check.closed) << name;
    EXPECT_EQ(check.self_intersections, 0) << name;
  }
}

// Asked once for each face and round, and once for some thousand points: a bound that does not fall
// as facets get smaller would make more and more of them.
TEST(TessellationByCgal, OfNarrowFacesComesToAnEnd) {
  const char* const data = blossom::testing::test_data();
  if (!data) GTEST_SKIP() << blossom::testing::kNoTestData;
  constexpr int kMaxAsked = 3000;
  const occt::Model model =
      testing::repaired_model(std::filesystem::path(data) / "models" / "d150_fused.brep");
  for (const double deviation : {0.2, 0.05, 0.01}) {
    int asked = 0;
    const occt::ShapeTessellation made = occt::tessellation(model.shape(), {.deviation = deviation},
                                                            [&] { return ++asked < kMaxAsked; });
    EXPECT_FALSE(made.facets.stopped) << deviation;
    EXPECT_LE(made.facets.distance, deviation * 1.01);
  }
}

}  // namespace
}  // namespace blossom
