// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners of several fillets that no one ball fills: four and more edges, kinds and radii that
// differ, edges without fillets between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeHalfSpace.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/blending/continuity.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/soundness.h"
#include "core/base/errors.h"
#include "tests/adapters/occt/chamfered_angle.h"
#include "tests/adapters/occt/fillet_checks.h"
#include "tests/adapters/occt/fillet_volumes.h"

namespace blossom::occt {
namespace {

using testing::chamfered_angle;
using testing::expect_sound;
using testing::integral;
using testing::kCut;

constexpr double kSmooth = 2e-6;  // radians: what strips and fills keep together

std::vector<int> sharp_edges(const TopoDS_Shape& shape) {
  std::vector<int> found;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Convex || each.kind == EdgeKind::Concave)
      found.push_back(each.number);
  return found;
}

// Edges that are as high in the middle as is said.
template <class Fits>
std::vector<int> edges_where(const TopoDS_Shape& shape, const Fits& fits) {
  std::vector<int> found;
  for (const EdgeFacts& each : edge_facts(shape))
    if (fits(each)) found.push_back(each.number);
  return found;
}

// A pyramid over a quadrangle whose apex is not above its middle.
TopoDS_Shape pyramid(const gp_Pnt& apex) {
  const std::array<gp_Pnt, 4> base{gp_Pnt(-8, -7, 0), gp_Pnt(9, -8, 0), gp_Pnt(7, 8, 0),
                                   gp_Pnt(-9, 6, 0)};
  BRepBuilderAPI_Sewing sewing;
  const auto add = [&](const std::vector<gp_Pnt>& points) {
    BRepBuilderAPI_MakePolygon wire;
    for (const gp_Pnt& p : points) wire.Add(p);
    wire.Close();
    sewing.Add(BRepBuilderAPI_MakeFace(wire.Wire(), Standard_True).Face());
  };
  add({base[3], base[2], base[1], base[0]});
  for (std::size_t i = 0; i < 4; ++i) add({base[i], base[(i + 1) % 4], apex});
  sewing.Perform();
  return BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape())).Solid();
}

TopoDS_Shape chamfered_box() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 16, 12).Shape();
  BRepFilletAPI_MakeChamfer chamfer(box);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) chamfer.Add(2, TopoDS::Edge(edges(i)));
  return chamfer.Shape();
}

// Every edge of blends is smooth, but for as many as are said.
void expect_smooth(const FilletResult& made, int creases) {
  ASSERT_EQ(made.solids.size(), 1U);
  const FilletedSolid& solid = made.solids.front();
  std::vector<int> blends;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid.solid, TopAbs_FACE, faces);
  for (const FilletFace& each : solid.faces)
    if (each.from == 0) blends.push_back(faces.FindIndex(each.face));
  int sharp = 0;
  for (const EdgeContinuity& each : edge_continuity(solid.solid)) {
    const bool of_blend = std::ranges::any_of(
        each.faces, [&](int face) { return std::ranges::count(blends, face) > 0; });
    if (!of_blend || !each.found) continue;
    if (each.found->angle.value > kSmooth) ++sharp;
  }
  EXPECT_EQ(sharp, creases);
}

TEST(FilletCorner, OfFourEdgesOfAChamferedBoxIsFilledSmoothly) {
  const TopoDS_Shape shape = chamfered_box();
  const FilletResult made = fillet(shape, sharp_edges(shape), {.radius = 0.3});
  expect_sound(made);
  expect_smooth(made, 0);
  EXPECT_LT(made.solids.front().volume, made.volume_before);
}

// The normals of the three faces have a sum that is farther than a right angle from one of them:
// the ball's patch reaches that far round.
TEST(FilletCorner, OfThreeEdgesInAnAcutePeakIsASphere) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, -60), gp_Pnt(10, 10, 20)).Shape();
  const gp_Pln slope(gp_Pnt(10, 10, 10), gp_Dir(-0.71, -0.6, 0.37));
  const TopoDS_Shape above =
      BRepPrimAPI_MakeHalfSpace(BRepBuilderAPI_MakeFace(slope).Face(), gp_Pnt(0, 0, 100)).Solid();
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(box, above).Shape();
  const auto edges = edges_where(shape, [](const EdgeFacts& each) {
    for (const gp_Pnt& end : {BRep_Tool::Pnt(TopExp::FirstVertex(each.edge)),
                              BRep_Tool::Pnt(TopExp::LastVertex(each.edge))})
      if (end.Distance(gp_Pnt(10, 10, 10)) < 1e-6) return true;
    return false;
  });
  ASSERT_EQ(edges.size(), 3U);
  const FilletResult made = fillet(shape, edges, {.radius = 0.5});
  expect_sound(made);
  expect_smooth(made, 3);  // where the strips end at the other ends of the edges
  int spheres = 0;
  for (const FilletFace& each : made.solids.front().faces)
    spheres +=
        Handle(Geom_SphericalSurface)::DownCast(BRep_Tool::Surface(each.face)).IsNull() ? 0 : 1;
  EXPECT_EQ(spheres, 1);
}

// A hexagonal head whose corners a cone cuts off, turned about its axis; and its sharp edges.
struct Head {
  TopoDS_Shape shape;
  std::vector<int> edges;
};

Head hexagonal_head(double turn) {
  BRepBuilderAPI_MakePolygon hexagon;
  for (int i = 0; i < 6; ++i)
    hexagon.Add(gp_Pnt(12 * std::cos(i * std::numbers::pi / 3),
                       12 * std::sin(i * std::numbers::pi / 3), 0));
  hexagon.Close();
  const TopoDS_Shape prism =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(hexagon.Wire()), gp_Vec(0, 0, 10)).Shape();
  const gp_Ax2 frame(gp::Origin(), gp::DZ(), gp_Dir(std::cos(turn), std::sin(turn), 0));
  const TopoDS_Shape made =
      BRepAlgoAPI_Common(prism, BRepPrimAPI_MakeCone(frame, 18, 9, 12).Shape()).Shape();
  return {made, sharp_edges(made)};
}

// The cone's seam is a smooth edge: one of its ends is in a corner, or it comes to the edge beside
// that.
TEST(FilletCorner, IsASphereWhereASmoothEdgeComesToIt) {
  const Head plain = hexagonal_head(std::numbers::pi / 6);
  for (const double radius : {0.2, 1.4}) {
    const FilletResult like = fillet(plain.shape, plain.edges, {.radius = radius});
    expect_sound(like);
    for (const double turn : {0.0, 0.05}) {
      const Head head = hexagonal_head(turn);
      const FilletResult made = fillet(head.shape, head.edges, {.radius = radius});
      expect_sound(made);
      EXPECT_NEAR(made.solids.front().volume, like.solids.front().volume, 1e-4);
      expect_smooth(made, 0);
    }
  }
}

// A smooth edge parts the box's upper face, and one of its ends is in a corner: what it leaves of
// one part there is narrower than the strips.
TEST(FilletCorner, IsASphereOnOneSideOfASmoothEdge) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  for (const double y : {1.0, 4.0, 10.0}) {
    TopTools_ListOfShape parts, lines;
    parts.Append(box);
    lines.Append(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 10), gp_Pnt(10, y, 10)).Edge());
    BRepAlgoAPI_Splitter split;
    split.SetArguments(parts);
    split.SetTools(lines);
    split.Build();
    const TopoDS_Shape shape = split.Shape();
    const FilletResult made = fillet(shape, sharp_edges(shape), {.radius = 2});
    expect_sound(made);
    const double s = 6, r = 2;
    EXPECT_NEAR(made.solids.front().volume,
                s * s * s + 6 * s * s * r + 3 * std::numbers::pi * r * r * s +
                    4 * std::numbers::pi / 3 * r * r * r,
                1e-6);
  }
}

// The concave edge comes first; along its end the upper edges become one, which comes to the third
// edge only then.
TEST(FilletCorner, IsMadeAtOnceWithAnEdgeThatComesToItAlongAnother) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(6, 8, 1.25 * std::numbers::pi).Shape();
  const auto edges = edges_where(shape, [](const EdgeFacts& each) {
    const Vec3& at = each.middle;
    return each.kind == EdgeKind::Concave || distance(at, {3, 0, 8}) < 1e-6 ||
           (each.kind == EdgeKind::Convex && std::abs(at[2] - 4) < 1e-6 && at[1] < -1);
  });
  ASSERT_EQ(edges.size(), 3U);
  const FilletResult made = fillet(shape, edges, {.radius = 0.7});
  expect_sound(made);
  EXPECT_EQ(made.edges.size(), 4U);
}

std::vector<int> edges_at_origin(const TopoDS_Shape& cube, double half) {
  return edges_where(
      cube, [half](const EdgeFacts& each) { return std::abs(norm(each.middle) - half) < 1e-6; });
}

// The nearest number of as many digits is below what the strips take at that radius.
TEST(FilletCorner, TellsASetbackThatCanBeGiven) {
  const TopoDS_Shape cube = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const auto edges = edges_at_origin(cube, 5);
  ASSERT_EQ(edges.size(), 3U);
  const FilletResult near = fillet(cube, edges, {.radius = 0.77, .setback = 0.5});
  ASSERT_EQ(near.refused.size(), 1U);
  const std::string &cause = near.refused.front().cause, before = "it has to be ";
  ASSERT_NE(cause.find(before), std::string::npos) << cause;
  const double told = std::stod(cause.substr(cause.find(before) + before.size()));
  for (const FilletRefusal& each : fillet(cube, edges, {.radius = 0.77, .setback = told}).refused)
    EXPECT_NE(each.fault, FilletFault::Setback) << each.text();
}

// The strips take more than half of each edge, so the radius is what has to change.
TEST(FilletCorner, TellsARadiusWhereNoSetbackFits) {
  const TopoDS_Shape cube = BRepPrimAPI_MakeBox(10., 10., 10.).Shape();
  const FilletResult made = fillet(cube, edges_at_origin(cube, 5), {.radius = 4.9, .setback = 4});
  ASSERT_EQ(made.refused.size(), 1U);
  EXPECT_EQ(made.refused.front().fault, FilletFault::Corner) << made.refused.front().text();
  EXPECT_TRUE(made.refused.front().largest.has_value());
}

// The strips are cylinders, each as long as its edge without the setback.
TEST(FilletCorner, IsSetBackAsFarAsIsAskedFor) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(10., 11., 12.).Shape();
  const auto edges = edges_where(shape, [](const EdgeFacts& each) {
    return distance(each.middle, {5, 0, 0}) < 1e-6 || distance(each.middle, {0, 5.5, 0}) < 1e-6 ||
           distance(each.middle, {0, 0, 6}) < 1e-6;
  });
  ASSERT_EQ(edges.size(), 3U);
  const FilletResult made = fillet(shape, edges, {.radius = 1, .setback = 3});
  expect_sound(made);
  expect_smooth(made, 3);  // where the strips end at the other ends of the edges
  double along = 0;
  for (const FilletFace& each : made.solids.front().faces)
    if (each.from == 0 && each.edge > 0) along += area(each.face);
  EXPECT_NEAR(along, std::numbers::pi / 2 * (7 + 8 + 9), 1e-9);
  EXPECT_LT(made.solids.front().volume, fillet(shape, edges, {.radius = 1}).solids.front().volume);

  const FilletResult near = fillet(shape, edges, {.radius = 1, .setback = 0.5});
  ASSERT_EQ(near.refused.size(), 1U);
  EXPECT_NE(near.refused.front().cause.find("the setback is too small"), std::string::npos);
  const FilletResult far = fillet(shape, edges, {.radius = 1, .setback = 6});
  ASSERT_EQ(far.refused.size(), 1U);
  EXPECT_NE(far.refused.front().cause.find("more than half"), std::string::npos);
  // What it has to be is told; radii have no part in that.
  const double whole =
      edge_facts(shape)[static_cast<std::size_t>(far.refused.front().edge) - 1].length;
  EXPECT_NE(far.refused.front().cause.find("less than " + std::to_string(whole / 2)),
            std::string::npos);
  for (const FilletResult* made_so : {&near, &far}) {
    EXPECT_EQ(made_so->refused.front().fault, FilletFault::Setback);
    EXPECT_EQ(made_so->refused.front().text().find("radi"), std::string::npos)
        << made_so->refused.front().text();
  }
  for (const double wrong : {0.0, -1.0})
    EXPECT_THROW(fillet(shape, edges, {.setback = wrong}), InvalidInput);
}

TEST(FilletCorner, OfFourEdgesAtAnApexThatNoBallTouchesIsFilledSmoothly) {
  const TopoDS_Shape shape = pyramid({1, 2, 9});
  const auto upper = edges_where(shape, [](const EdgeFacts& each) { return each.middle[2] > 1; });
  ASSERT_EQ(upper.size(), 4U);
  const FilletResult made = fillet(shape, upper, {.radius = 0.8});
  expect_sound(made);
  int corners = 0;
  for (const FilletFace& each : made.solids.front().faces)
    corners += each.from == 0 && each.edge == 0 ? 1 : 0;
  EXPECT_GE(corners, 8);  // one patch or more for each section and each face
}

// The crease of the edge without a fillet forks, and ends where the strips beside it begin.
TEST(FilletCorner, LeavesOneOfFourEdgesAsItIs) {
  const TopoDS_Shape shape = pyramid({1, 2, 9});
  auto upper = edges_where(shape, [](const EdgeFacts& each) { return each.middle[2] > 1; });
  upper.pop_back();
  const FilletResult made = fillet(shape, upper, {.radius = 0.8});
  expect_sound(made);
  EXPECT_LT(made.solids.front().volume, made.volume_before);
}

// Two edges without fillets lie between them on one side: no plane across each.
TEST(FilletCorner, OfTwoNeighboursAmongFourEdgesHasNoPlaneAcross) {
  const TopoDS_Shape shape = pyramid({1, 2, 9});
  const auto two = edges_where(
      shape, [](const EdgeFacts& each) { return each.middle[2] > 1 && each.middle[1] < 0; });
  ASSERT_EQ(two.size(), 2U);
  const FilletResult made = fillet(shape, two, {.radius = 0.6});
  expect_sound(made);
  EXPECT_TRUE(made.notes.empty());
  EXPECT_LT(made.solids.front().volume, made.volume_before);
}

// What is cut off along both is what is cut off along the one or the other.
TEST(FilletCorner, OfTwoNeighboursAmongFourEdgesIsAMitre) {
  const TopoDS_Shape shape = chamfered_angle();
  // Two sides of a chamfer; and an upright edge with the foot of a chamfer, of which the one comes
  // to the other chamfer just where the other leaves it.
  const std::vector<std::array<Vec3, 2>> pairs{{Vec3{0, 10, 8}, Vec3{1, 1, 9}},
                                               {Vec3{0, 0, 4}, Vec3{15, 0, 8}}};
  for (const auto& middles : pairs) {
    std::vector<FilletResult> singles;
    std::vector<int> two;
    for (const Vec3& middle : middles) {
      two.push_back(edges_where(shape, [&](const EdgeFacts& each) {
                      return distance(each.middle, middle) < 1e-6;
                    }).at(0));
      singles.push_back(fillet(shape, {two.back()}, {.radius = 0.4}));
      ASSERT_EQ(singles.back().solids.size(), 1U);
    }
    const FilletResult made = fillet(shape, two, {.radius = 0.4});
    expect_sound(made);
    EXPECT_TRUE(made.notes.empty());
    GProp_GProps common;
    BRepGProp::VolumeProperties(
        BRepAlgoAPI_Common(singles[0].solids.front().solid, singles[1].solids.front().solid)
            .Shape(),
        common);
    EXPECT_NEAR(made.solids.front().volume, common.Mass(), 1e-6);
  }
}

// Concave edges come first where two of either kind alternate; the chamfered rim goes on over their
// mitres.
TEST(FilletCorner, OfTwoConvexAndTwoConcaveEdgesThatAlternateIsRolledRound) {
  const TopoDS_Shape shape = chamfered_angle();
  const FilletResult made = fillet(shape, sharp_edges(shape), {.radius = 0.5});
  expect_sound(made);
  EXPECT_TRUE(made.notes.empty());
  EXPECT_TRUE(sharp_edges(made.solids.front().solid).empty());
}

// At the vertex in the middle of the lower box's top edge three edges are convex and one is
// concave: no order of the kinds makes balls or mitres of them.
TEST(FilletCorner, OfConvexAndConcaveEdgesIsFilled) {
  const TopoDS_Shape low = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 20, 20, 6).Shape();
  const TopoDS_Shape high = BRepPrimAPI_MakeBox(gp_Pnt(5, 0, 6), 8, 9, 7).Shape();
  BRepAlgoAPI_Fuse fuse(low, high);
  fuse.SimplifyResult();
  const TopoDS_Shape shape = fuse.Shape();
  const FilletResult made = fillet(shape, sharp_edges(shape), {.radius = 0.7});
  expect_sound(made);
}

// Three bars across each other: in each of eight vertices three concave edges alternate with three
// convex ones.
TopoDS_Shape crossing_bars() {
  const TopoDS_Shape x = BRepPrimAPI_MakeBox(gp_Pnt(-20, -5, -5), 40, 10, 10).Shape();
  const TopoDS_Shape y = BRepPrimAPI_MakeBox(gp_Pnt(-5, -20, -5), 10, 40, 10).Shape();
  const TopoDS_Shape z = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -20), 10, 10, 40).Shape();
  BRepAlgoAPI_Fuse fuse(BRepAlgoAPI_Fuse(x, y).Shape(), z);
  fuse.SimplifyResult();
  return fuse.Shape();
}

// Beside a vertex a strip goes on to the planes that halve the angles between the edges.
TEST(FilletCorner, OfThreeConcaveEdgesBetweenConvexOnesIsAMitre) {
  const TopoDS_Shape shape = crossing_bars();
  const auto edges =
      edges_where(shape, [](const EdgeFacts& each) { return each.kind == EdgeKind::Concave; });
  ASSERT_EQ(edges.size(), 12U);
  const double of_corner = integral(0, std::sqrt(1 - std::sqrt(0.5)), [](double s) {
    const double z = s * s;  // the root is smooth in s
    return 2 * s * 2 * z * (1 - z - std::sqrt(2 * z - z * z));
  });
  for (const double r : {0.2, 2.5}) {
    const FilletResult made = fillet(shape, edges, {.radius = r});
    expect_sound(made);
    EXPECT_TRUE(made.notes.empty());
    EXPECT_NEAR(made.solids.front().volume - made.volume_before,
                120 * kCut * r * r + 8 * 3 * of_corner * r * r * r, 1e-6);
  }
}

// The convex edges go on along the mitres of the concave ones, and meet in a ball.
TEST(FilletCorner, OfThreeConvexAndThreeConcaveEdgesThatAlternateIsRolledRound) {
  const TopoDS_Shape shape = crossing_bars();
  const FilletResult made = fillet(shape, sharp_edges(shape), {.radius = 0.8});
  expect_sound(made);
  EXPECT_TRUE(made.notes.empty());
  expect_smooth(made, 0);
}

TEST(FilletCorner, OfChangingRadiiIsFilledSmoothly) {
  const TopoDS_Shape shape = BRepPrimAPI_MakeBox(20, 16, 12).Shape();
  const auto at_origin = edges_where(shape, [](const EdgeFacts& each) {
    return (each.middle[0] == 0) + (each.middle[1] == 0) + (each.middle[2] == 0) == 2;
  });
  ASSERT_EQ(at_origin.size(), 3U);
  const FilletResult made = fillet(shape, at_origin, {.law = RadiusLaw::linear({0, 1}, 1, 2)});
  expect_sound(made);
  expect_smooth(made, 3);  // the strips' ends in the far faces
}

// The hole breaks through the side of the cone near its top: the ball between both rolls round the
// hole, and comes back, but their edge ends at the top.
TEST(FilletOfAnOpenEdge, IsMadeWhereTheBallRollsRoundBothFaces) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(12.95, 4.24, 26.24).Shape();
  const gp_Ax2 axis(gp_Pnt(0, 0, -10), gp_Dir(-0.11, -0.02, 1));
  const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(axis, 1.2, 60).Shape();
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(cone, hole).Shape();
  const FilletResult made = fillet(shape, sharp_edges(shape), {.radius = 0.1});
  expect_sound(made);
  EXPECT_LT(made.solids.front().volume, made.volume_before);
}

}  // namespace
}  // namespace blossom::occt
