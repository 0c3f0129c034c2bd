// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/clear_charts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Ax2.hxx>
#include <gp_Elips.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/queries/cone_volumes.h"

namespace blossom::occt {
namespace {

TopoDS_Shape ball_at(const gp_Pnt& middle, double radius) {
  return BRepPrimAPI_MakeSphere(middle, radius).Shape();
}

bool holds(const SolidTrimResult& made, const TopoDS_Face& face) {
  for (const TopoDS_Solid& solid : made.solids)
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
      if (it.Current().IsEqual(face)) return true;
  return false;
}

TopoDS_Solid solid_of(const std::vector<TopoDS_Face>& faces) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const TopoDS_Face& face : faces) builder.Add(shell, face);
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

// Of the nearest vertex or edge of a face that is no point.
double distance(const TopoDS_Face& face, const TopoDS_Shape& from, TopAbs_ShapeEnum kind) {
  double least = 1e100;
  for (TopExp_Explorer it(face, kind); it.More(); it.Next())
    if (kind == TopAbs_VERTEX || !BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
      least = std::min(least, BRepExtrema_DistShapeShape(it.Current(), from).Value());
  return least;
}

// The ring's seam goes through the ball on the ball's own: the ball turns about its axis alone, so
// that the circles in which they meet stay parallels of both.
TEST(ClearCharts, KeepTheAxisOfABallWhereOnlyItsSeamIsInTheWay) {
  const TrimTool ball = trim_tool(ball_at({0, 0, 0}, 5));
  const TrimTool ring = trim_tool(BRepPrimAPI_MakeTorus(6, 2).Shape());
  const ClearCharts made = clear_charts(ball, ring);
  ASSERT_EQ(made.turned.size(), 1u);
  const auto surface =
      Handle(Geom_SphericalSurface)::DownCast(BRep_Tool::Surface(made.turned.front().first));
  ASSERT_FALSE(surface.IsNull());
  EXPECT_TRUE(surface->Position().Direction().IsEqual(gp::DZ(), 1e-15));
  EXPECT_FALSE(surface->Position().XDirection().IsEqual(gp::DX(), 0.1));
}

// Its pole lies on the wall, 2 from the axis of a cylinder of radius 2.
TEST(ClearCharts, KeepPolesOffFaces) {
  const TrimTool ball = trim_tool(ball_at({2, 0, 1}, 1));
  const TrimTool rod = trim_tool(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  const ClearCharts made = clear_charts(ball, rod);
  ASSERT_EQ(made.turned.size(), 1u);
  EXPECT_TRUE(made.turned.front().second.IsEqual(ball.faces.front()));
  const Handle(Geom_SphericalSurface) sphere =
      Handle(Geom_SphericalSurface)::DownCast(BRep_Tool::Surface(made.solid.faces.front()));
  ASSERT_FALSE(sphere.IsNull());
  EXPECT_LT(sphere->Location().Distance(gp_Pnt(2, 0, 1)), 1e-14);
  EXPECT_NEAR(sphere->Radius(), 1, 1e-15);
  for (const double sign : {-1.0, 1.0}) {
    const gp_XYZ pole = sphere->Location().XYZ() + sign * sphere->Axis().Direction().XYZ();
    EXPECT_GT(std::abs(std::hypot(pole.X(), pole.Y()) - 2), 1.0 / 16);
    EXPECT_GT(std::abs(pole.Z()), 1.0 / 16);
  }
}

TEST(ClearCharts, ChangeNothingThatIsClear) {
  const TrimTool rod = trim_tool(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  for (const TopoDS_Shape& shape :
       {ball_at({9, 0, 1}, 1), ball_at({2.4, 0, 2.5}, 0.5), TopoDS_Shape(rod.solids.front())}) {
    const TrimTool solid = trim_tool(shape);
    const ClearCharts made = clear_charts(solid, rod);
    EXPECT_TRUE(made.turned.empty());
    for (std::size_t i = 0; i < solid.faces.size(); ++i)
      EXPECT_TRUE(made.solid.faces[i].IsEqual(solid.faces[i]));
  }
}

// The frame of a mirror image is left-handed, and its face is turned round.
TEST(ClearCharts, KeepMaterialAndTolerances) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp::DX()));
  const TopoDS_Shape image = BRepBuilderAPI_Transform(ball_at({2, 0, 1}, 1), mirror, true).Shape();
  const TrimTool rod = trim_tool(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  for (TrimTool ball : {trim_tool(image), trim_tool(ball_at({2, 0, 1}, 1))}) {
    const ClearCharts made = clear_charts(ball, rod);
    ASSERT_EQ(made.turned.size(), 1u);
    const TopoDS_Face& face = made.solid.faces.front();
    ConeVolumes cones({0, 0, 0});
    EXPECT_NEAR(cones.of(face), 4 * std::numbers::pi / 3, 1e-9);
    EXPECT_EQ(BRep_Tool::Tolerance(face), BRep_Tool::Tolerance(ball.faces.front()));
  }
}

TEST(ClearCharts, LeaveFacesThatDoNotGoRound) {
  const TrimTool half = trim_tool(BRepPrimAPI_MakeSphere(2, std::numbers::pi).Shape());
  const TrimTool box = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(-3, 0, 1), gp_Pnt(3, 9, 2)).Shape());
  EXPECT_TRUE(clear_charts(half, box).turned.empty());
  EXPECT_TRUE(clear_charts(box, half).turned.empty());
}

// The tube closes along its way, which is no turn about the ring's axis.
TEST(ClearCharts, LeaveTubesThatEndInPlanes) {
  const TrimTool tube = trim_tool(BRepPrimAPI_MakeTorus(3, 1, std::numbers::pi).Shape());
  const TrimTool box = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(-1, 4, -1), gp_Pnt(1, 6, 1)).Shape());
  EXPECT_TRUE(clear_charts(tube, box).turned.empty());
}

// A bar touches the rod along its seam, as far as it goes. The discs get the new rims.
TEST(ClearCharts, KeepSeamsOfRodsOffWhatTheyTouch) {
  const TrimTool rod = trim_tool(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  const TopoDS_Shape bar = BRepPrimAPI_MakeBox(gp_Pnt(2, -1, 1), gp_Pnt(3, 1, 4)).Shape();
  const ClearCharts made = clear_charts(rod, trim_tool(bar));
  ASSERT_EQ(made.turned.size(), 3u);
  EXPECT_GT(distance(made.solid.faces.front(), bar, TopAbs_VERTEX), 2.0 / 16);
  EXPECT_TRUE(BRepCheck_Analyzer(compound_of(made.solid.faces)).IsValid());
  EXPECT_TRUE(is_closed_solid(solid_of(made.solid.faces)));
  ConeVolumes cones({0, 0, 0});
  double volume = 0;
  for (const TopoDS_Face& face : made.solid.faces) volume += cones.of(face);
  EXPECT_NEAR(volume, 20 * std::numbers::pi, 1e-9);
}

// Where a wall goes through the axis the seam is its border, all along or for a part.
TEST(ClearCharts, LeaveASeamInAWallThroughTheAxis) {
  const TrimTool rod = trim_tool(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  const TrimTool box = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(-9, 0, -9), gp_Pnt(9, 9, 9)).Shape());
  EXPECT_TRUE(clear_charts(rod, box).turned.empty());
}

// Under a bulge, the arc through (1, 0), (1.3, 1) and (1, 2), that is no torus.
TopoDS_Shape barrel() {
  const TopoDS_Edge bulge = BRepBuilderAPI_MakeEdge(
      GC_MakeArcOfCircle(gp_Pnt(1, 0, 0), gp_Pnt(1.3, 0, 1), gp_Pnt(1, 0, 2)).Value());
  BRepBuilderAPI_MakeWire outline(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Edge(),
                                  bulge,
                                  BRepBuilderAPI_MakeEdge(gp_Pnt(1, 0, 2), gp_Pnt(0, 0, 2)).Edge(),
                                  BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 2), gp_Pnt(0, 0, 0)).Edge());
  const TopoDS_Face profile = BRepBuilderAPI_MakeFace(outline.Wire(), true).Face();
  return BRepPrimAPI_MakeRevol(profile, gp::OZ()).Shape();
}

// A slanted bar's rim touches the barrel's in (1, 0, 2), where the seam ends in the rim.
TEST(ClearCharts, KeepSeamsOfRevolutionsOffWhatTouchesThem) {
  const gp_Elips rim(gp_Ax2(gp_Pnt(5.25, 0, 0), gp::DZ()), 4.5, 1);
  const TopoDS_Wire outline = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(rim).Edge()).Wire();
  const TopoDS_Shape bar =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline).Face(), gp_Vec(0.25, 0, 2)).Shape();
  const TrimTool part = trim_tool(barrel()), tool = trim_tool(bar);
  const ClearCharts charts = clear_charts(part, tool);
  EXPECT_EQ(charts.turned.size(), 3u);
  EXPECT_TRUE(is_closed_solid(solid_of(charts.solid.faces)));
  const SolidTrimResult made = trim_solids(part, {tool}, SolidOperation::Cut);
  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  ASSERT_EQ(made.solids.size(), 1u);
  EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front()).IsValid());
  EXPECT_NEAR(made.volumes.front().cut, 8.830046, 1e-6);
}

// What has rims in common turns with them, unless more than planes and rims meets there.
TEST(ClearCharts, TurnFacesThatMeetInRimsTogether) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  const TopoDS_Shape tip = BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(0, 0, 5), gp::DZ()), 2, 0, 3).Shape();
  const TrimTool pencil = trim_tool(BRepAlgoAPI_Fuse(rod, tip).Shape());
  ASSERT_EQ(pencil.faces.size(), 3u);
  const TrimTool bar = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(2, -1, 1), gp_Pnt(3, 1, 4)).Shape());
  const ClearCharts made = clear_charts(pencil, bar);
  EXPECT_EQ(made.turned.size(), 3u);
  EXPECT_TRUE(is_closed_solid(solid_of(made.solid.faces)));
}

// The torus stays as it is, and its seams go elsewhere.
TEST(ClearCharts, KeepTheCornerOfATorusOffFaces) {
  const TrimTool ring = trim_tool(BRepPrimAPI_MakeTorus(3, 1).Shape());
  const TrimTool box = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(4, -1, -1), gp_Pnt(6, 1, 1)).Shape());
  const ClearCharts made = clear_charts(ring, box);
  ASSERT_EQ(made.turned.size(), 1u);
  const TopoDS_Face& face = made.solid.faces.front();
  const Handle(Geom_ToroidalSurface) torus =
      Handle(Geom_ToroidalSurface)::DownCast(BRep_Tool::Surface(face));
  ASSERT_FALSE(torus.IsNull());
  EXPECT_EQ(torus->MajorRadius(), 3);
  EXPECT_TRUE(torus->Axis().IsParallel(gp_Ax1(gp::Origin(), gp::DZ()), 1e-15));
  EXPECT_GT(distance(face, box.solids.front(), TopAbs_VERTEX), 1.0 / 16);
  EXPECT_TRUE(BRepCheck_Analyzer(face).IsValid());
  ConeVolumes cones({0, 0, 0});
  EXPECT_NEAR(cones.of(face), 6 * std::pow(std::numbers::pi, 2), 1e-6);
}

// A wall stands on the circle that is its seam about the axis, and touches it.
TEST(ClearCharts, KeepSeamsAboutTheAxisOffWhatTheyTouch) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp::DX()));
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(3, 1).Shape();
  const TrimTool box = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(-1, 4, -1), gp_Pnt(1, 6, 1)).Shape());
  for (const TopoDS_Shape& shape :
       {torus, TopoDS_Shape(BRepBuilderAPI_Transform(torus, mirror, true).Shape())}) {
    const ClearCharts made = clear_charts(trim_tool(shape), box);
    ASSERT_EQ(made.turned.size(), 1u);
    const TopoDS_Face& face = made.solid.faces.front();
    EXPECT_GT(distance(face, box.solids.front(), TopAbs_EDGE), 1.0 / 16);
    ConeVolumes cones({0, 0, 0});
    EXPECT_NEAR(cones.of(face), 6 * std::pow(std::numbers::pi, 2), 1e-6);
  }
}

// Half a ring has the seam as its border.
TEST(ClearCharts, LeaveASeamThatAFaceFollows) {
  const TrimTool ring = trim_tool(BRepPrimAPI_MakeTorus(3, 1).Shape());
  const TrimTool box = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(-9, -9, 0), gp_Pnt(9, 9, 5)).Shape());
  EXPECT_TRUE(clear_charts(ring, box).turned.empty());
}

// Both seams go through the same two points of the circle in which the balls meet.
TEST(ClearCharts, KeepSeamsOffOtherSeams) {
  gp_Trsf round;
  round.SetRotation(gp_Ax1(gp_Pnt(2, 0, 0), gp::DZ()), std::numbers::pi);
  const TrimTool ball = trim_tool(ball_at({0, 0, 0}, 2));
  const TrimTool other =
      trim_tool(BRepBuilderAPI_Transform(ball_at({2, 0, 0}, 1), round, true).Shape());
  const ClearCharts made = clear_charts(ball, other);
  ASSERT_EQ(made.turned.size(), 1u);
  for (const double high : {-1.0, 1.0}) {
    const TopoDS_Vertex meeting =
        BRepBuilderAPI_MakeVertex(gp_Pnt(1.75, 0, high * std::sqrt(0.9375)));
    EXPECT_GT(distance(made.solid.faces.front(), meeting, TopAbs_EDGE), 1.0 / 8);
  }
  EXPECT_TRUE(clear_charts(other, made.solid).turned.empty());
}

// The curve in which they meet touches the outermost circle of the first in its corner. A seam
// there has to go elsewhere as well as the corner.
TEST(ClearCharts, LetRingsMeetWhereASeamIsTouched) {
  for (const double scale : {1.0, 7480.91}) {
    const gp_Dir corner(0, -1, 0);
    const gp_Ax2 flat(gp_Pnt(0, 0, 0), gp::DZ(), corner);
    const gp_Ax2 upright(gp_Pnt(0, -3.5 * scale, -2.625 * scale), gp_Dir(-1, 0, 0), corner);
    const TrimTool lying = trim_tool(BRepPrimAPI_MakeTorus(flat, 2 * scale, 1.5 * scale).Shape());
    const TrimTool standing =
        trim_tool(BRepPrimAPI_MakeTorus(upright, 1.5 * scale, 1.125 * scale).Shape());
    const SolidTrimResult made = trim_solids(lying, {standing}, SolidOperation::Fuse);
    ASSERT_TRUE(made.obstacles.empty()) << scale << ": " << made.obstacles.front();
    ASSERT_EQ(made.solids.size(), 1u);
    EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front()).IsValid());
  }
}

// Its seam touches the box beside it.
TEST(ClearCharts, RodsAreTurnedBackWhereNothingIsDivided) {
  const TrimTool rod = trim_tool(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  const TrimTool bar = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(2, -1, 1), gp_Pnt(3, 1, 4)).Shape());
  ASSERT_EQ(clear_charts(rod, bar).turned.size(), 3u);
  const SolidTrimResult made = trim_solids(rod, {bar}, SolidOperation::Cut);
  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  for (const TopoDS_Face& face : rod.faces) EXPECT_TRUE(holds(made, face));
  ASSERT_EQ(made.solids.size(), 1u);
  EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front()).IsValid());
}

// It stands on its pole.
TEST(ClearCharts, AreTurnedBackWhereNothingIsDivided) {
  const TrimTool ball = trim_tool(ball_at({1, 1, 2}, 1));
  const TrimTool box = trim_tool(BRepPrimAPI_MakeBox(2, 2, 1).Shape());
  ASSERT_EQ(clear_charts(ball, box).turned.size(), 1u);
  const SolidTrimResult made = trim_solids(ball, {box}, SolidOperation::Cut);
  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  ASSERT_EQ(made.solids.size(), 1u);
  EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front()).IsValid());
  EXPECT_TRUE(holds(made, ball.faces.front()));
}

// Along the wall's rulings at the pole: the quartic has a vertical tangent in either pole.
TEST(ClearCharts, LetABallBeCutByAWallThroughItsPoles) {
  for (const double scale : {1e-3, 1.0, 1e4}) {
    const TrimTool ball = trim_tool(ball_at({2 * scale, 0, 0}, scale));
    const TrimTool rod = trim_tool(
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -scale), gp::DZ()), 2 * scale, 2 * scale)
            .Shape());
    const SolidTrimResult made = trim_solids(ball, {rod}, SolidOperation::Split);
    ASSERT_TRUE(made.obstacles.empty()) << scale << ": " << made.obstacles.front();
    ASSERT_EQ(made.solids.size(), 2u);
    const SolidVolumes& volumes = made.volumes.back();
    EXPECT_NEAR(volumes.cut + volumes.common, 4 * std::numbers::pi / 3 * std::pow(scale, 3),
                1e-6 * std::pow(scale, 3));
    EXPECT_LT(volumes.common, volumes.cut);
  }
}

}  // namespace
}  // namespace blossom::occt
