// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids that come near each other's edges by little more than the tolerance, or than they state.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Vec.hxx>

#include "adapters/occt/base/kept_tolerances.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/solid_trim.h"
#include "adapters/occt/solids/solid_shells.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::kPi;

void expect_sound_volume(const TopoDS_Shape& a, const TopoDS_Shape& b, SolidOperation operation,
                         double volume) {
  const SolidTrimResult made = trim_solids(trim_tool(a), {trim_tool(b)}, operation);
  ASSERT_EQ(made.obstacles.empty() ? std::string() : made.obstacles.front(), "");
  EXPECT_NEAR(made.total.result, volume, 1e-6 * volume);
  for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
}

// The volume in common of a cube round the origin with sides of 50 and of a cylinder of a radius
// less than 25 sqrt(1.5) along (1, 1, 0), whose axis is 25 / sqrt(2) from the diagonal, between
// planes through two edges of the cube. With w the height over the axis in the plane z = 0:
//   V = 62500 + 4 integral (75 / sqrt(2) - w) sqrt(r^2 - w^2) dw,  w from 25 / sqrt(2) to r.
double half_a_cube_and_a_segment(double r) {
  const double from = 25 / std::sqrt(2), rise = std::sqrt(r * r - from * from);
  const double segment = 0.5 * r * r * (kPi / 2 - std::asin(from / r)) - 0.5 * from * rise;
  return 62500 + 4 * (75 / std::sqrt(2) * segment - rise * rise * rise / 3);
}

// The cylinder passes all edges that it meets within a few tolerances of the cube's corners, where
// it leaves slivers of 1e-18: these edges cross it, and do not lie in it.
TEST(NearContacts, ACylinderThroughTheCornersOfACubeMayMissThemByALittle) {
  for (const double gap : {1e-6, 5e-6}) {
    const double r = 25 * std::sqrt(1.5) - gap, height = 50 * std::sqrt(2);
    const TopoDS_Shape cube =
        BRepPrimAPI_MakeBox(gp_Pnt(-25, -25, -25), gp_Pnt(25, 25, 25)).Shape();
    const TopoDS_Shape cylinder =
        BRepPrimAPI_MakeCylinder(gp_Ax2({-37.5, -12.5, 0}, {1, 1, 0}, {1, -1, 0}), r, height)
            .Shape();
    const double of_cube = 125000, of_cylinder = kPi * r * r * height;
    const double common = half_a_cube_and_a_segment(r);
    expect_sound_volume(cube, cylinder, SolidOperation::Common, common);
    expect_sound_volume(cylinder, cube, SolidOperation::Common, common);
    expect_sound_volume(cube, cylinder, SolidOperation::Cut, of_cube - common);
    expect_sound_volume(cylinder, cube, SolidOperation::Cut, of_cylinder - common);
    expect_sound_volume(cube, cylinder, SolidOperation::Fuse, of_cube + of_cylinder - common);
  }
}

// Its rim crosses each side of the bottom that both stand on twice, and keeps within ten tolerances
// of it between: the two run beside each other there, and are not one.
TEST(NearContacts, ARimThatCrossesSidesByAFewTolerancesDividesThem) {
  const TopoDS_Shape cube = BRepPrimAPI_MakeBox(5, 5, 5).Shape();
  for (const double past : {3e-7, 6e-7, 8.5e-7, 5e-6}) {
    const double r = 2.5 + past, height = 3;
    const TopoDS_Shape rod =
        BRepPrimAPI_MakeCylinder(gp_Ax2({2.5, 2.5, 0}, gp::DZ()), r, height).Shape();
    expect_sound_volume(cube, rod, SolidOperation::Cut, 125 - kPi * r * r * height);
    expect_sound_volume(cube, rod, SolidOperation::Common, kPi * r * r * height);
  }
}

// A ball as wide as the foot of a cone, beside it by so little that the two rims cross at an angle
// of 1e-5: what the curves are off takes their places along the rims a thousand times as far.
TEST(NearContacts, RimsMayCrossAtATinyAngle) {
  for (const gp_Dir& aside : {gp_Dir(1, -1, 0), gp_Dir(1, 0.3, 0), gp_Dir(1, 0, 0)})
    for (const double off : {1e-5, 4e-5}) {
      constexpr double kRadius = 1.3;
      const TopoDS_Shape cone = BRepPrimAPI_MakeCone(kRadius, 0, 1).Shape();
      const TopoDS_Shape ball =
          BRepPrimAPI_MakeSphere(gp_Pnt(gp_XYZ(off * aside.XYZ())), kRadius).Shape();
      const double of_cone = kPi / 3 * kRadius * kRadius;
      expect_sound_volume(cone, ball, SolidOperation::Common, of_cone);  // less 1e-10
      expect_sound_volume(ball, cone, SolidOperation::Cut,
                          4 * kPi / 3 * std::pow(kRadius, 3) - of_cone);
    }
}

// Faces that state no more than usual, between edges that do.
TEST(NearContacts, EdgesThatRunAlongEachOtherWithinWhatTheyStateAreOne) {
  constexpr double kStated = 1.5e-7, kShift = 1.4e-7;
  const TopoDS_Shape low = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  const TopoDS_Shape high =
      BRepPrimAPI_MakeBox(gp_Pnt(kShift, 0, 1), gp_Pnt(1 + kShift, 1, 2)).Shape();
  for (const TopoDS_Shape& shape : {low, high})
    for (const TopAbs_ShapeEnum kind : {TopAbs_EDGE, TopAbs_VERTEX})
      ShapeFix_ShapeTolerance().SetTolerance(shape, kStated, kind);
  expect_sound_volume(low, high, SolidOperation::Fuse, 2);
  expect_sound_volume(high, low, SolidOperation::Fuse, 2);
}

// A block of 60 by 75 round one edge with a radius of 12.5, 50 long; the round goes past the line
// in which it would be tangential to the top by so much that it is `rise` over it in between.
TopoDS_Face rounded_profile(const gp_Pnt& origin, const gp_Dir& y, double width, double rise) {
  constexpr double kTop = 75, kRound = 12.5;
  const auto point = [&](double at, double height) {
    return gp_Pnt(origin.X() + at * y.X(), origin.Y() + at * y.Y(), height);
  };
  const gp_Dir across = y.Crossed(gp_Dir(0, 0, 1));
  const gp_Circ circle(gp_Ax2(point(width - kRound, kTop - kRound + rise), across), kRound);
  const gp_Pnt foot = point(width, kTop - kRound + rise),
               end = point(width - kRound - std::sqrt(rise * (2 * kRound - rise)), kTop);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(point(0, 0), point(width, 0)));
  wire.Add(BRepBuilderAPI_MakeEdge(point(width, 0), foot));
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(circle, foot, end, true).Value()));
  wire.Add(BRepBuilderAPI_MakeEdge(end, point(0, kTop)));
  wire.Add(BRepBuilderAPI_MakeEdge(point(0, kTop), point(0, 0)));
  return BRepBuilderAPI_MakeFace(wire.Wire());
}

// Two such blocks in one place, round along x and along y. The rounds meet in a curve that ends in
// the corner of both tops, a thousandth away from where it crosses the edge; the widths over the
// plane z = 62.5 are 37.5 + s and 47.5 + s, with s^2 + (z - 62.5)^2 = 12.5^2.
TEST(NearContacts, RoundsThatGoALittlePastTheirTangentAreDividedAtTheirEdges) {
  constexpr double r = 12.5;
  const double common = 50 * 60 * 62.5 + 37.5 * 47.5 * r + 85 * kPi * r * r / 4 + 2 * r * r * r / 3;
  const double of_a = 50 * (60 * 75 - r * r * (1 - kPi / 4));
  const double of_b = 60 * (50 * 75 - r * r * (1 - kPi / 4));
  for (const double rise : {0.0, 3.7e-8}) {
    const TopoDS_Shape a =
        BRepPrimAPI_MakePrism(rounded_profile({0, 0, 0}, {0, 1, 0}, 60, rise), gp_Vec(50, 0, 0));
    const TopoDS_Shape b =
        BRepPrimAPI_MakePrism(rounded_profile({0, 0, 0}, {1, 0, 0}, 50, 0), gp_Vec(0, 60, 0));
    expect_sound_volume(a, b, SolidOperation::Common, common);
    expect_sound_volume(a, b, SolidOperation::Cut, of_a - common);
    expect_sound_volume(b, a, SolidOperation::Cut, of_b - common);
    expect_sound_volume(b, a, SolidOperation::Fuse, of_a + of_b - common);
  }
}

// The rims are farther apart than their edges and faces state, but not than their vertices do.
TEST(NearContacts, SolidsWhoseCornersStateThatTheyAreOneAreFusedToOne) {
  constexpr double kStated = 5e-5, kGap = 1e-5;
  const TopoDS_Shape low = BRepPrimAPI_MakeCylinder(2, 1).Shape();
  const TopoDS_Shape high =
      BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, 1 + kGap}, {0, 0, 1}, {0, 1, 0}), 2, 1).Shape();
  for (const TopoDS_Shape& shape : {low, high})
    ShapeFix_ShapeTolerance().SetTolerance(shape, kStated, TopAbs_VERTEX);
  const SolidTrimResult made = trim_solids(trim_tool(low), {trim_tool(high)}, SolidOperation::Fuse);
  ASSERT_EQ(made.obstacles.empty() ? std::string() : made.obstacles.front(), "");
  EXPECT_EQ(made.solids.size(), 1u);
  EXPECT_EQ(made.status, Status::Tolerance);
  EXPECT_NEAR(made.total.result, 8 * kPi, 2 * kGap * 4 * kPi);
}

// A cylinder reaches through two sides of a prism by a millionth less than its faces state, so that
// it touches them, in a corner of its seam as well: the two halves of the prism are not joined by
// necks a hundredth wide. The seam is turned to a side, to another one and past both.
TEST(NearContacts, ACylinderThatReachesThroughSidesWithinWhatTheyStateTouchesThem) {
  constexpr double kStated = 3e-3, r = 15;
  for (const double turn : {0.0, 0.5, 1.0, 1.5, 0.3}) {
    const TopoDS_Shape prism =
        BRepPrimAPI_MakeBox(gp_Pnt(-15, -30, -15), gp_Pnt(45, 30, 15)).Shape();
    ShapeFix_ShapeTolerance().SetTolerance(prism, kStated);
    const gp_Dir seam(std::cos(turn * kPi), 0, std::sin(turn * kPi));
    const TopoDS_Shape cylinder =
        BRepPrimAPI_MakeCylinder(gp_Ax2({0, -50, 0}, {0, 1, 0}, seam), r + 1.19e-6, 100).Shape();
    const SolidTrimResult made =
        trim_solids(trim_tool(prism), {trim_tool(cylinder)}, SolidOperation::Cut);
    ASSERT_EQ(made.obstacles.empty() ? std::string() : made.obstacles.front(), "") << turn;
    EXPECT_EQ(made.solids.size(), 3u) << turn;
    EXPECT_NEAR(made.total.result, 60 * 60 * 30 - kPi * r * r * 60, 0.1) << turn;
  }
}

// The line along which they touch is a millionth long: how they bend is seen far beside it only.
TEST(NearContacts, ABoxThatTouchesACylinderAlongAHairOfItIsOneWithIt) {
  const TopoDS_Shape cylinder =
      BRepPrimAPI_MakeCylinder(gp_Ax2({3, 1, 1}, {0, 0, -1}, {-1, 0, 0}), 1, 5).Shape();
  const TopoDS_Shape box =
      BRepPrimAPI_MakeBox(gp_Pnt(2.5, 2, -5), gp_Pnt(12.5, 4, -4 + 1e-6)).Shape();
  expect_sound_volume(cylinder, box, SolidOperation::Fuse, 5 * kPi + 20 * (1 + 1e-6));
  expect_sound_volume(box, cylinder, SolidOperation::Cut, 20 * (1 + 1e-6));
}

// As high as wide: where the curves in which they cross meet the rims they touch them, and each
// other's seams, from whichever side they are seen.
TEST(NearContacts, CrossedEqualCylindersThatTouchEachOthersRimsAreDividedInBothOrders) {
  constexpr double r = 25, of_each = kPi * r * r * 2 * r, common = 16 * r * r * r / 3;
  const TopoDS_Shape lying =
      BRepPrimAPI_MakeCylinder(gp_Ax2({r, 0, 0}, {-1, 0, 0}, {0, 0, 1}), r, 2 * r).Shape();
  const TopoDS_Shape upright =
      BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -r}, {0, 0, 1}, {1, 0, 0}), r, 2 * r).Shape();
  expect_sound_volume(lying, upright, SolidOperation::Cut, of_each - common);
  expect_sound_volume(upright, lying, SolidOperation::Cut, of_each - common);
  expect_sound_volume(lying, upright, SolidOperation::Common, common);
  expect_sound_volume(upright, lying, SolidOperation::Fuse, 2 * of_each - common);
}

// The cone's base rim passes the pole of a ball, in which a curve of a millionth closes round it.
TEST(NearContacts, ACurveThatIsOnePointDividesNothing) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, {0, -1, 0}), 1).Shape();
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(gp_Ax2({-2, -1, 0}, {0, 1, 0}), 2, 0.5, 1).Shape();
  const SolidTrimResult fused =
      trim_solids(trim_tool(ball), {trim_tool(cone)}, SolidOperation::Fuse);
  const SolidTrimResult common =
      trim_solids(trim_tool(cone), {trim_tool(ball)}, SolidOperation::Common);
  ASSERT_EQ(fused.obstacles.size() + common.obstacles.size(), 0u);
  EXPECT_NEAR(fused.total.result + common.total.result, kPi * (4.0 / 3 + 7.0 / 4), 1e-7);
}

TEST(NearContacts, AnAttemptThatFailsLeavesTolerancesAsTheyWere) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  const TrimTool solid = trim_tool(box);
  const TopoDS_Vertex vertex = TopoDS::Vertex(TopExp_Explorer(box, TopAbs_VERTEX).Current());
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current());
  const auto widen = [&](bool leave) {
    KeptTolerances kept(solid.faces);
    BRep_Builder().UpdateVertex(vertex, 1e-3);
    BRep_Builder().UpdateEdge(edge, 1e-4);
    if (leave) kept.leave();
  };
  widen(false);
  EXPECT_EQ(BRep_Tool::Tolerance(vertex), 1e-7);
  EXPECT_EQ(BRep_Tool::Tolerance(edge), 1e-7);
  widen(true);
  EXPECT_EQ(BRep_Tool::Tolerance(vertex), 1e-3);
  EXPECT_EQ(BRep_Tool::Tolerance(edge), 1e-4);
}

// Two boxes with a common edge, one turned about a line across it: their top sides cross at an
// angle at which they are apart by many tolerances at the ends, and within one of them for long.
TEST(NearContacts, SidesThatCrossAtATinyAngleDivideEachOtherInALine) {
  for (const double angle : {8e-8, 3e-7, 2e-6, 5e-5}) {
    SCOPED_TRACE(angle);
    const TopoDS_Shape a = BRepPrimAPI_MakeBox(gp_Pnt(-100, 0, -100), gp_Pnt(100, 200, 0));
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1({0, 0, 0}, gp::DY()), angle);
    const TopoDS_Shape b =
        BRepBuilderAPI_Transform(
            BRepPrimAPI_MakeBox(gp_Pnt(-60, 50, -40), gp_Pnt(70, 150, 0)).Shape(), turn, true)
            .Shape();
    // Above the top side of a lies a wedge of b of 60 by 60 times the angle.
    const double wedge = 0.5 * 60 * 60 * std::tan(angle) * 100, whole = 130 * 100 * 40;
    const SolidTrimResult common =
        trim_solids(trim_tool(a), {trim_tool(b)}, SolidOperation::Common);
    ASSERT_EQ(common.obstacles.empty() ? std::string() : common.obstacles.front(), "");
    EXPECT_NEAR(common.total.result, whole - wedge, 1e-9 * whole);
    const SolidTrimResult cut = trim_solids(trim_tool(b), {trim_tool(a)}, SolidOperation::Cut);
    ASSERT_EQ(cut.obstacles.empty() ? std::string() : cut.obstacles.front(), "");
    EXPECT_NEAR(cut.total.result, wedge, 1e-9 * whole);
    for (const SolidTrimResult* made : {&common, &cut})
      for (const TopoDS_Solid& solid : made->solids)
        EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  }
}

std::vector<BoundingFace> faces_of_cube(double size, double tolerance) {
  const TopoDS_Shape cube = BRepPrimAPI_MakeBox(size, size, size).Shape();
  ShapeFix_ShapeTolerance().SetTolerance(cube, tolerance);
  std::vector<BoundingFace> faces;
  for (TopExp_Explorer it(cube, TopAbs_FACE); it.More(); it.Next())
    faces.push_back({TopoDS::Face(it.Current()), cone_volume(TopoDS::Face(it.Current()), {})});
  return faces;
}

// Balls of 1e-6 round its corners hold more than a cube of that size, balls and tubes of 1e-7 less.
TEST(NearContacts, SolidsThatTheirTolerancesCoverAreLeftOutAndCounted) {
  std::string obstacle;
  int left_out = 0;
  EXPECT_TRUE(solids_of(faces_of_cube(1e-6, 1e-6), obstacle, nullptr, &left_out).empty());
  EXPECT_EQ(left_out, 1);
  EXPECT_EQ(solids_of(faces_of_cube(1e-6, 1e-7), obstacle, nullptr, &left_out).size(), 1u);
  EXPECT_EQ(left_out, 1);
  EXPECT_EQ(solids_of(faces_of_cube(1e-6, 1e-6), obstacle).size(), 1u);  // nobody would be told
  EXPECT_EQ(obstacle, "");
}

// A rod through a ring of its radius meets it in two nodes. Off them by much less than the
// tolerance its curves end in different places of a node, and run to and fro there.
TEST(NearContacts, CurvesMayCrossByChanceInTheNodeInWhichTheyEnd) {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(2., 0.5).Shape();
  const auto common = [&](double off) {
    const gp_Ax2 along(gp_Pnt(0, 0, off), gp_Dir(0, 1, 0));
    const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(along, 0.5, 8).Shape();
    const SolidTrimResult made =
        trim_solids(trim_tool(ring), {trim_tool(rod)}, SolidOperation::Common);
    EXPECT_EQ(made.obstacles.empty() ? std::string() : made.obstacles.front(), "");
    return made.total.result;
  };
  EXPECT_NEAR(common(1e-9), common(0), 1e-6);
}

// Six balls round a cap of their radius all go through the middle of its flat face but for 3e-7,
// and so do neighbours through one place of its rim: between them there they leave nothing that is
// as wide as the tolerance, and curves that end in different places of that. The volume by
// integration.
TEST(NearContacts, BallsMayMissACommonPointByAFewTolerances) {
  const double radius = 20, sixth = kPi / 3, below = kPi / 18000;
  const TopoDS_Shape cap = BRepPrimAPI_MakeSphere(radius, -below, kPi / 2).Shape();
  std::vector<TrimTool> balls;
  for (int i = 0; i < 6; ++i) {
    const double at = (i + 0.5) * sixth;
    const gp_Pnt centre(radius * std::cos(at), radius * std::sin(at), 0);
    balls.push_back(trim_tool(BRepPrimAPI_MakeSphere(centre, radius).Shape()));
  }
  const SolidTrimResult made = trim_solids(trim_tool(cap), balls, SolidOperation::Cut);
  ASSERT_EQ(made.obstacles.empty() ? std::string() : made.obstacles.front(), "");
  EXPECT_NEAR(made.total.result, 1463.1623282, 1e-6);
  for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
}

}  // namespace
}  // namespace blossom::occt
