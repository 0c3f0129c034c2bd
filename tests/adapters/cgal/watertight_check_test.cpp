// SPDX-License-Identifier: GPL-3.0-or-later
// Watertight shapes are closed surfaces without self-intersections, by CGAL: meshed by Open
// CASCADE, and by samples that neighbours share.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include "adapters/cgal/gpl/mesh_check.h"
#include "adapters/occt/base/compounds.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "adapters/occt/watertight.h"
#include "tests/support/incremental_mesh.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"
#include "tests/support/watertight_mesh.h"

namespace blossom {
namespace {

using testing::Mesh;
using testing::WatertightSampler;

Mesh sampled(const occt::WatertightShape& shape) {
  std::vector<bool> reversed;
  for (const auto& pieces : shape.faces)
    reversed.push_back(pieces.front().Orientation() == TopAbs_REVERSED);
  return WatertightSampler(shape.pieces, reversed, 4).mesh();
}

void expect_closed(const Mesh& mesh, double volume, double error) {
  const cgal::MeshCheck check = cgal::check_mesh(mesh.points, mesh.triangles);
  EXPECT_TRUE(check.manifold);
  EXPECT_TRUE(check.closed);
  EXPECT_EQ(check.self_intersections, 0);
  EXPECT_EQ(check.degenerate_triangles, 0);
  EXPECT_NEAR(check.volume, volume, error * volume);
}

void expect_watertight(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  const occt::SolidTrimResult fused =
      occt::trim_solids(occt::trim_tool(a), {occt::trim_tool(b)}, occt::SolidOperation::Fuse);
  ASSERT_EQ(fused.solids.size(), 1u);
  const occt::WatertightShape made = occt::watertight(fused.solids.front());
  ASSERT_TRUE(made.pieces.obstacle.empty()) << made.pieces.obstacle;

  {
    SCOPED_TRACE("meshed by Open CASCADE");
    expect_closed(testing::incremental_mesh(made.shape, 1e-2), fused.volumes.back().fuse, 0.05);
  }
  SCOPED_TRACE("meshed by samples");
  expect_closed(sampled(made), fused.volumes.back().fuse, 0.01);
}

TEST(WatertightMesh, OfTwoSpheresIsClosed) {
  expect_watertight(BRepPrimAPI_MakeSphere(1), BRepPrimAPI_MakeSphere(gp_Pnt(0.7, 0.2, 0.3), 0.8));
}

TEST(WatertightMesh, OfTwoBoxesIsClosed) {
  expect_watertight(BRepPrimAPI_MakeBox(2, 2, 2),
                    BRepPrimAPI_MakeBox(gp_Pnt(1, 0.5, 0.7), 3, 1, 1));
}

TEST(WatertightMesh, OfABoxAndACylinderIsClosed) {
  const gp_Ax2 axis(gp_Pnt(1, 1, 1), gp_Dir(0.2, 0.1, 1));
  expect_watertight(BRepPrimAPI_MakeBox(2, 2, 2), BRepPrimAPI_MakeCylinder(axis, 0.6, 3));
}

// A solid with poles without a box, which leaves this volume.
void expect_cut_closed(const TopoDS_Shape& part, const gp_Pnt& low, const gp_Pnt& high,
                       double volume) {
  const occt::SolidTrimResult cut =
      occt::trim_solids(occt::trim_tool(part), {occt::trim_tool(BRepPrimAPI_MakeBox(low, high))},
                        occt::SolidOperation::Cut);
  ASSERT_TRUE(cut.obstacles.empty()) << cut.obstacles.front();
  ASSERT_EQ(cut.solids.size(), 1u);
  const occt::WatertightShape made = occt::watertight(cut.solids.front());
  ASSERT_EQ(made.pieces.obstacle, "");
  EXPECT_LE(made.pieces.deviation, 1e-6);
  expect_closed(sampled(made), volume, 2e-3);
}

constexpr double kPi = 3.14159265358979323846;

TEST(WatertightMesh, OfBallsCutAtTheirPolesIsClosed) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(1);
  const double beyond = kPi * 0.95 * 0.95 * 2.05 / 3;  // the cap of a plane at -0.05
  {
    SCOPED_TRACE("a plane beside the pole");
    expect_cut_closed(ball, {0.05, -2, -2}, {2, 2, 2}, 4 * kPi / 3 - beyond);
  }
  {
    SCOPED_TRACE("a plane through the pole");
    expect_cut_closed(ball, {0, -2, -2}, {2, 2, 2}, 2 * kPi / 3);
  }
  {
    // Its cut along a meridian winds round a line between patches, by rounding.
    SCOPED_TRACE("a corner at the pole");
    const double quarter_of_cap = kPi * 0.7 * 0.7 * 2.3 / 12;
    expect_cut_closed(ball, {0, 0, 0.3}, {2, 2, 2}, 4 * kPi / 3 - quarter_of_cap);
  }
}

TEST(WatertightMesh, OfConesCutAtTheirApexIsClosed) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(1, 0, 1);
  {
    SCOPED_TRACE("a plane through the apex");
    expect_cut_closed(cone, {0, -2, -2}, {2, 2, 2}, kPi / 6);
  }
  {
    SCOPED_TRACE("a corner at the apex");
    expect_cut_closed(cone, {0, 0, -2}, {2, 2, 2}, kPi / 4);
  }
}

// By samples, and by Open CASCADE with that deflection, where flat pieces have no nodes inside.
void expect_closed_model(const std::string& name, double volume, double error, double deflection) {
  const char* folder = blossom::testing::test_data();
  if (!folder) GTEST_SKIP() << blossom::testing::kNoTestData;
  const occt::Model model = testing::repaired_model(std::string(folder) + "/models/" + name);
  const occt::WatertightShape made = occt::watertight(model.shape());
  ASSERT_EQ(made.pieces.obstacle, "");
  expect_closed(sampled(made), volume, error);
  SCOPED_TRACE("meshed by Open CASCADE");
  expect_closed(testing::incremental_mesh(made.shape, deflection), volume, error);
}

// Its blends join their neighbours smoothly along edges of many short pieces: a facet of three
// points of such an edge may lie on the other side of it.
TEST(WatertightMesh, OfACrankArmDoesNotCrossItself) {
  expect_closed_model("crankarm.brep", 54074, 1e-3, 0.05);
}

// 213 faces of an IGES file without common edges, whose curves in space are up to 2e-3 off.
TEST(WatertightMesh, OfLooseFacesDoesNotCrossItself) {
  const char* folder = blossom::testing::test_data();
  if (!folder) GTEST_SKIP() << blossom::testing::kNoTestData;
  const occt::Model model = testing::repaired_model(std::string(folder) + "/models/bearing.iges");
  const occt::WatertightShape made = occt::watertight(model.shape());
  ASSERT_EQ(made.pieces.obstacle, "");
  EXPECT_LE(made.pieces.deviation, 3e-4);
  const Mesh mesh = sampled(made);
  const cgal::MeshCheck check = cgal::check_mesh(mesh.points, mesh.triangles);
  EXPECT_TRUE(check.manifold);
  EXPECT_EQ(check.self_intersections, 0);
}

// Trims pass the outermost line of a surface within 5e-5 of its range, on edges that are 2e-3 off.
// Facets of both sides of its thin walls add to the volume.
TEST(WatertightMesh, OfABodyWithLooseEdgesDoesNotCrossItself) {
  expect_closed_model("s1_mainbody_back.stp", 72799, 0.12, 0.2);
}

// The plane of the cut nearly touches a face, so that both sides of the cut have triangles with
// corners on it alone: facets of these lay in the plane over each other.
TEST(WatertightMesh, OfAPlaneCutInHalfIsClosed) {
  const char* folder = blossom::testing::test_data();
  if (!folder) GTEST_SKIP() << blossom::testing::kNoTestData;
  const occt::Model model =
      testing::repaired_model(std::string(folder) + "/models/d150_fused.brep");
  const TopoDS_Shape beyond =
      BRepPrimAPI_MakeBox(gp_Pnt(18.885, -100, -100), gp_Pnt(100, 100, 100));
  const occt::SolidTrimResult cut = occt::trim_solids(
      occt::trim_tool(model.shape()), {occt::trim_tool(beyond)}, occt::SolidOperation::Cut);
  ASSERT_TRUE(cut.obstacles.empty()) << cut.obstacles.front();
  const occt::WatertightShape made = occt::watertight(occt::compound_of(cut.solids));
  ASSERT_EQ(made.pieces.obstacle, "");
  expect_closed(sampled(made), cut.volumes.back().cut, 1e-3);
  SCOPED_TRACE("meshed by Open CASCADE");
  expect_closed(testing::incremental_mesh(made.shape, 8e-3), cut.volumes.back().cut, 5e-3);
}

}  // namespace
}  // namespace blossom
