// SPDX-License-Identifier: LGPL-2.1-or-later
// Pipes of one radius that touch along a section of both, and cross in curves through it.
#include <gtest/gtest.h>

#include <string>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/solid_trim.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

constexpr double kPipeRadius = 10;
const gp_Ax1 kAlong({0, 0, 0}, {0, 0, 1});

TopoDS_Shape bent_by(double degrees, const TopoDS_Shape& shape) {
  gp_Trsf turn;
  turn.SetRotation(kAlong, degrees * testing::kPi / 180);
  return BRepBuilderAPI_Transform(shape, turn, true).Shape();
}

// A quarter of a turn from the plane z = 0 on, towards a direction in it. Its curved face is turned
// from an arc of a whole turn, which closes but for rounding, or it is a torus.
TopoDS_Shape elbow(double bend, double towards, bool of_arc) {
  const gp_Pnt centre(bend, 0, 0);
  if (!of_arc)
    return bent_by(towards, BRepPrimAPI_MakeTorus(gp_Ax2(centre, {0, 1, 0}, {-1, 0, 0}), bend,
                                                  kPipeRadius, testing::kPi / 2)
                                .Shape());
  const Handle(Geom_Curve) circle = new Geom_Circle(gp_Ax2({0, 0, 0}, {0, 0, 1}), kPipeRadius);
  const Handle(Geom_Curve) section = new Geom_TrimmedCurve(circle, 0, 2 * testing::kPi);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(section).Edge()).Wire());
  return bent_by(towards,
                 BRepPrimAPI_MakeRevol(face, gp_Ax1(centre, {0, 1, 0}), testing::kPi / 2).Shape());
}

TopoDS_Shape straight(double from, double to) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, from}, {0, 0, 1}), kPipeRadius, to - from).Shape();
}

double volume_of(SolidOperation operation, const TopoDS_Shape& a, const TopoDS_Shape& b) {
  IntersectionOptions options;
  options.time_limit = 60;
  const SolidTrimResult made = trim_solids(trim_tool(a), {trim_tool(b)}, operation, options);
  EXPECT_EQ(made.obstacles.empty() ? std::string() : made.obstacles.front(), "");
  EXPECT_EQ(made.status, Status::Complete);
  for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  return made.total.result;
}

// Returns what they have in common.
double expect_sums(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  IntersectionOptions options;
  const SolidTrimResult whole =
      trim_solids(trim_tool(a), {trim_tool(b)}, SolidOperation::Common, options);
  const double of_a = whole.total.part, of_b = whole.total.tools;
  const double common = volume_of(SolidOperation::Common, a, b), near = 1e-9 * (of_a + of_b);
  EXPECT_NEAR(volume_of(SolidOperation::Fuse, a, b), of_a + of_b - common, near);
  EXPECT_NEAR(volume_of(SolidOperation::Cut, a, b), of_a - common, near);
  EXPECT_NEAR(volume_of(SolidOperation::Cut, b, a), of_b - common, near);
  return common;
}

TEST(PipeJoints, AnElbowAndAStraightPipeAreProven) {
  for (const bool of_arc : {false, true}) {
    const TopoDS_Shape bent = elbow(30, 0, of_arc);
    // Where the pipe begins at the joint, or passes it.
    const double part = expect_sums(bent, straight(0, 40));
    EXPECT_NEAR(part, volume_of(SolidOperation::Common, bent, straight(-20, 40)), 1e-5);
    EXPECT_NEAR(part, 7010.3028788, 1e-5);
    EXPECT_NEAR(volume_of(SolidOperation::Common, bent, straight(-20, 0)), 0, 1e-9);
  }
}

TEST(PipeJoints, ElbowsThatGoApartAreProven) {
  const TopoDS_Shape torus = elbow(30, 0, false), turned = elbow(30, 0, true);
  expect_sums(torus, elbow(30, 5, false));
  expect_sums(turned, elbow(30, 180, true));
  expect_sums(turned, elbow(45, 0, true));
  expect_sums(torus, elbow(45, 40, true));
}

// Beside a node of the joint, where the seam of the pipe leaves an edge of 0.8 between both, they
// leave it in one direction for longer than such an edge tells by steps into its faces.
TEST(PipeJoints, FacesThatTouchAlongAShortEdgeAreToldApartByHowTheyBend) {
  const TopoDS_Shape bent = elbow(40, 0, true), pipe = bent_by(92.1916, straight(-25, 5));
  const double whole = testing::kPi * kPipeRadius * kPipeRadius * 30;
  const double common = volume_of(SolidOperation::Common, pipe, bent);
  EXPECT_NEAR(volume_of(SolidOperation::Cut, pipe, bent), whole - common, 1e-6);
}

TEST(PipeJoints, ABallOfTheTubeEndsAnElbow) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(kPipeRadius).Shape();
  const double half = 2 * testing::kPi / 3 * kPipeRadius * kPipeRadius * kPipeRadius;
  for (const bool of_arc : {false, true})
    EXPECT_NEAR(expect_sums(elbow(30, 20, of_arc), ball), half, 1e-6);
}

}  // namespace
}  // namespace blossom::occt
