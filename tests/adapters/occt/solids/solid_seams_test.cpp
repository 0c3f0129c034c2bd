// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids cut along edges that they have already.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_Ax2.hxx>

#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

// Of real models, where these are at hand.
class SolidSeamsOfModels : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* const folder = blossom::testing::test_data();
    if (folder == nullptr) GTEST_SKIP() << blossom::testing::kNoTestData;
    models_ = std::filesystem::path(folder) / "models";
  }

  Model read(const char* name) const { return testing::repaired_model(models_ / name); }

 private:
  std::filesystem::path models_;
};

// All of a box beyond a plane y = const.
TrimTool box_beyond(double y, const gp_Pnt& low, const gp_Pnt& high) {
  return trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(low.X(), y, low.Z()), high));
}

// The plane goes through the seam of each face. That of a spline surface is 2e-12 away, without
// crossing the plane, and at both ends of the line on the far side of a cylinder are circles that
// lie in the plane as far as tolerances go.
TEST_F(SolidSeamsOfModels, HalveAModelThatIsItsOwnMirrorImage) {
  const Model model = read("elliptiplane.brep");
  for (const double y : {0.0, 1e-8}) {
    const SolidTrimResult made = trim_solids(
        trim_tool(model.shape()), {box_beyond(y, {-5, 0, -2}, {2.5, 6, 9})}, SolidOperation::Split);
    ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
    ASSERT_EQ(made.solids.size(), 2u);
    const SolidVolumes& volumes = made.volumes.back();
    EXPECT_NEAR(volumes.cut, 0.5 * volumes.part, 2e-7 * volumes.part);
    EXPECT_NEAR(volumes.common, 0.5 * volumes.part, 2e-7 * volumes.part);
    for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  }
}

TEST(SolidSeams, HalveAThinDisc) {
  const TopoDS_Shape disc = BRepPrimAPI_MakeCylinder(1.5, 0.05);
  const SolidTrimResult made =
      trim_solids(trim_tool(disc), {box_beyond(0, {-2, 0, -1}, {2, 2, 1})}, SolidOperation::Cut);
  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  EXPECT_NEAR(made.volumes.back().cut, 0.5 * std::numbers::pi * 1.5 * 1.5 * 0.05, 1e-9);
}

SolidTrimResult cut_near_loose_edges(const Model& model, double y) {
  return trim_solids(trim_tool(model.shape()), {box_beyond(y, {-200, 0, -100}, {200, 100, 100})},
                     SolidOperation::Split);
}

// Edges are up to 1.5e-3 off the plane y = 0 and 2.2e-3 off their faces: where they keep so near to
// a cut they are the cut. Cuts of faces beside them end in vertices of that tolerance, 5e-4 beside
// other edges or in gaps of wires.
TEST_F(SolidSeamsOfModels, MayBeOffByTheirTolerances) {
  const Model model = read("s1_mainbody_back.stp");
  for (const double y : {-5e-4, -3e-4, 0.0, 5e-4}) {
    const SolidTrimResult made = cut_near_loose_edges(model, y);
    ASSERT_TRUE(made.obstacles.empty()) << y << ' ' << made.obstacles.front();
    EXPECT_EQ(made.status, Status::Tolerance);
    EXPECT_FALSE(made.merged.empty());
    ASSERT_EQ(made.solids.size(), 2u);
    const SolidVolumes& volumes = made.volumes.back();
    EXPECT_LE(volumes.cut_error(), 1e-6);
    EXPECT_NEAR(volumes.cut / volumes.part, 0.5, 1e-4);
    for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  }
}

// The plane leaves the tolerance of edges that it crosses.
TEST_F(SolidSeamsOfModels, TellWhereACutAlongALooseEdgeBreaksOff) {
  const Model model = read("s1_mainbody_back.stp");
  const SolidTrimResult made = cut_near_loose_edges(model, 1e-3);
  ASSERT_FALSE(made.obstacles.empty());
  EXPECT_TRUE(made.solids.empty());
  const std::string& first = made.obstacles.front();
  EXPECT_NE(first.find("face 13 of the part"), std::string::npos) << first;
  EXPECT_NE(first.find("edge of tolerance 0.0022"), std::string::npos) << first;
  EXPECT_NE(first.find("goes on in no other face"), std::string::npos) << first;
}

double common_volume(const TopoDS_Shape& part, const TopoDS_Shape& tool) {
  const SolidTrimResult made =
      trim_solids(trim_tool(part), {trim_tool(tool)}, SolidOperation::Common);
  EXPECT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  if (made.volumes.empty()) return 0;
  EXPECT_LE(made.volumes.back().cut_error(), 1e-9);
  EXPECT_LE(made.volumes.back().fuse_error(), 1e-9);
  return made.volumes.back().common;
}

// Where its seam begins is no matter of a ball: for 1e-3 of its length it lies in the ring's
// intersection, as far as tolerances go. What stays within tolerance beside a stretch that both
// share is the same contact, also where a piece between the two is proven not to meet the seam.
TEST(SolidSeams, MayTouchTheIntersection) {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(gp_Ax2({0, -0.5, 0}, gp::DX()), 1, 0.5).Shape();
  for (const double x : {-0.5, 0.5})
    for (const double y : {-1.5, 0.5})
      for (const double z : {-0.5, 0.5}) {
        const gp_Ax2 frame({x, y, z}, gp::DZ(), gp_Dir(0, y < 0 ? 1 : -1, 0));
        const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(frame, 1).Shape();
        const SolidTrimResult cut =
            trim_solids(trim_tool(ring), {trim_tool(ball)}, SolidOperation::Common);
        ASSERT_TRUE(cut.obstacles.empty()) << x << ' ' << y << ' ' << z << cut.obstacles.front();
        EXPECT_LE(cut.volumes.back().cut_error(), 1e-9);
        EXPECT_LE(cut.volumes.back().fuse_error(), 1e-9);
        EXPECT_NEAR(cut.volumes.back().common, 1.152371735, 1e-7);  // as with seams elsewhere
      }
}

// A plane that touches a ring inside crosses itself there in its edge, in a corner of patches: that
// is told as a cusp, and decided when the pieces are put together.
TEST(SolidSeams, MayMeetWhereFacesTouch) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-0.5, -0.5, -0.5), gp_Pnt(1.5, 0, 0.5));
  const auto ring = [](const gp_Dir& seam) {
    return BRepPrimAPI_MakeTorus(gp_Ax2({0, 0, 0.5}, gp::DZ(), seam), 1, 0.5).Shape();
  };
  EXPECT_NEAR(common_volume(ring(gp_Dir(0, -1, 0)), block),
              common_volume(ring(gp_Dir(0.3, -1, 0)), block), 1e-7);
}

// As splines a ring is closed but has no period, and the cone's edge lies along its seam: as what
// ends a piece on one side of it, and as what begins one on the other.
TEST(SolidSeams, MayLieAlongAnEdgeOfTheOtherSolid) {
  using std::numbers::pi;
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(3, 1, -pi, pi).Shape();
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(2, 4, 3, pi).Shape();
  const TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(ring, true).Shape();
  const double common = common_volume(cone, ring);
  EXPECT_NEAR(common_volume(cone, splines), common, 1e-6);
  EXPECT_NEAR(common_volume(splines, cone), common, 1e-6);
}

// Curves of their intersection cross where each half of a ring ends, in corners of patches and on
// the seam: two of them lead there in patches beside the one in which the contact is told.
TEST(SolidSeams, MayLieWhereCurvesCross) {
  const auto half_ring = [](const gp_Dir& axis, const gp_Dir& x) {
    return BRepPrimAPI_MakeTorus(gp_Ax2(gp::Origin(), axis, x), 2, 0.5, std::numbers::pi).Shape();
  };
  const gp_Dir turned(0, -std::sin(0.7), std::cos(0.7));
  EXPECT_NEAR(common_volume(half_ring(gp::DZ(), gp::DX()), half_ring(turned, gp::DX())), 0.947193,
              1e-6);
}

}  // namespace
}  // namespace blossom::occt
