// SPDX-License-Identifier: LGPL-2.1-or-later
// Cones and balls cut close by their apex and poles, where charts bend sharply.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include "adapters/occt/solid_trim.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::kPi;

TrimTool cone(double low, double high) {
  return trim_tool(BRepPrimAPI_MakeCone(low, high, 1).Shape());
}

TrimTool box_beyond(double x) {
  return trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(x, -2, -2), gp_Pnt(2, 2, 2)).Shape());
}

SolidTrimResult cut_beyond(double x, const TrimTool& part) {
  return trim_solids(part, {box_beyond(x)}, SolidOperation::Cut);
}

// A plane beside the axis of a cone of radius and height 1 leaves half of it and, to first order,
// its distance times the triangle in between, of area 1.
void expect_half_cone(const SolidTrimResult& made, double x) {
  ASSERT_TRUE(made.obstacles.empty()) << x << ": " << made.obstacles.front();
  ASSERT_EQ(made.solids.size(), 1u);
  EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front()).IsValid());
  EXPECT_NEAR(made.volumes.back().cut, kPi / 6 + x, 2e-9 + 10 * x * x);
}

// The hyperbolas bend within x of the corner that a plane through the axis would cut, and their
// fits have some thousand spans there.
TEST(SolidApex, PlanesBesideTheApexOfAConeHalveIt) {
  for (const double x : {1e-3, 1e-5, 1e-6}) {
    expect_half_cone(cut_beyond(x, cone(1, 0)), x);
    expect_half_cone(cut_beyond(x, cone(0, 1)), x);
  }
}

// So near that the hyperbola cannot be told from the lines through the apex: right, or refused in
// words that name the faces.
TEST(SolidApex, PlanesAsNearAsTheToleranceHalveItOrAreRefusedByName) {
  for (const double x : {1e-7, 1e-8, 1e-9}) {
    const SolidTrimResult made = cut_beyond(x, cone(1, 0));
    if (made.obstacles.empty()) {
      expect_half_cone(made, x);
      continue;
    }
    EXPECT_TRUE(made.solids.empty());
    std::vector<std::string> causes = made.obstacles;
    for (const std::string& cause : causes) EXPECT_EQ(cause.rfind("face 1 of the part", 0), 0u);
    std::sort(causes.begin(), causes.end());
    EXPECT_EQ(std::adjacent_find(causes.begin(), causes.end()), causes.end());
  }
}

TEST(SolidApex, PlanesCloseByThePoleOfABallCutItsCap) {
  const TrimTool ball = trim_tool(BRepPrimAPI_MakeSphere(1).Shape());
  for (const double height : {1e-3, 1e-5}) {
    const TrimTool above =
        trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, 1 - height), gp_Pnt(2, 2, 4)).Shape());
    const SolidTrimResult made = trim_solids(ball, {above}, SolidOperation::Cut);
    ASSERT_TRUE(made.obstacles.empty()) << height << ": " << made.obstacles.front();
    EXPECT_NEAR(made.volumes.back().common, kPi * height * height * (1 - height / 3), 1e-13);
  }
}

// The cap lies within a few tolerances of the disc that closes it, and is no part of it.
TEST(SolidApex, ThinCapsAreCutOff) {
  const TrimTool ball = trim_tool(BRepPrimAPI_MakeSphere(1).Shape());
  for (const double height : {1e-6, 5e-7, 3e-7}) {
    const TrimTool above =
        trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, 1 - height), gp_Pnt(2, 2, 2)).Shape());
    const SolidTrimResult made = trim_solids(ball, {above}, SolidOperation::Common);
    ASSERT_TRUE(made.obstacles.empty()) << height << ": " << made.obstacles.front();
    ASSERT_EQ(made.solids.size(), 1u) << height;
    EXPECT_NEAR(made.volumes.back().common, kPi * height * height, 0.01 * kPi * height * height);
  }
}

// What is less than two tolerances high counts as the disc, and that is told.
TEST(SolidApex, CapsThatVanishAreTold) {
  constexpr double kHeight = 1.5e-7;
  const TrimTool ball = trim_tool(BRepPrimAPI_MakeSphere(1).Shape());
  const TrimTool above =
      trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, 1 - kHeight), gp_Pnt(2, 2, 2)).Shape());
  const SolidTrimResult made = trim_solids(ball, {above}, SolidOperation::Cut);
  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  ASSERT_EQ(made.merged.size(), 1u);
  EXPECT_EQ(made.merged.front().rfind("a piece of face 1 of the part and a piece of face ", 0), 0u)
      << made.merged.front();
  EXPECT_NE(made.status, Status::Complete);
  EXPECT_TRUE(trim_solids(ball, {box_beyond(0.5)}, SolidOperation::Cut).merged.empty());
}

// Near the poles arcs get so short that their ends count as one: curves end up to 1e-6 away. The
// pose is one that rounds.
TEST(SolidApex, PlanesThroughThePolesOfALargeBallHalveIt) {
  const gp_Ax2 axis({0, 0, 0}, gp_Dir(0.34, -0.28, -0.9));
  const gp_Dir across(gp_Vec(axis.XDirection()) * 0.6 + gp_Vec(axis.YDirection()) * 0.8);
  constexpr double r = 400;
  gp_Ax2 frame({0, 0, 0}, across);
  const gp_Vec diagonal = gp_Vec(frame.XDirection()) + gp_Vec(frame.YDirection());
  frame.SetLocation(gp_Pnt(0, 0, 0).Translated(diagonal * (-1.5 * r)));
  const SolidTrimResult made = trim_solids(
      trim_tool(BRepPrimAPI_MakeSphere(axis, r).Shape()),
      {trim_tool(BRepPrimAPI_MakeBox(frame, 3 * r, 3 * r, 2 * r).Shape())}, SolidOperation::Split);
  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  EXPECT_NEAR(made.volumes.back().common / (r * r * r), 2 * kPi / 3, 1e-9);
  for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
}

// A cone lies half in a plate, its tip a little above or below the surface: its ruling that comes
// nearest to the tip turns there by nearly a half of its chart.
TEST(SolidApex, ConesWithTheirTipNearlyInAPlateAreCut) {
  const TrimTool plate =
      trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(-4, -5, -2), gp_Pnt(4, 3, 0)).Shape());
  const gp_Dir along(0.6438747318933178, -0.7651228020715961, 0.003525248844770457);
  for (const double up : {0.0, 1e-9, -1e-9, 3.9e-9, -3.9e-9, 2.1e-8, -2.1e-8}) {
    const gp_Pnt foot = gp_Pnt(0, 0, up).Translated(-2.79902 * gp_Vec(along));
    const TrimTool cone =
        trim_tool(BRepPrimAPI_MakeCone(gp_Ax2(foot, along), 1, 0, 2.79902).Shape());
    for (const SolidOperation operation : {SolidOperation::Split, SolidOperation::Fuse}) {
      const SolidTrimResult made = trim_solids(plate, {cone}, operation);
      ASSERT_TRUE(made.obstacles.empty()) << up << ": " << made.obstacles.front();
      for (const TopoDS_Solid& solid : made.solids)
        EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid()) << up;
    }
  }
}

}  // namespace
}  // namespace blossom::occt
