// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets of walls: with radii of their thickness or half of it, and of walls with draft.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_BSplineSurface.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/blending/continuity.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/full_round.h"
#include "adapters/occt/mass.h"
#include "core/base/errors.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

using testing::expect_sound;

// Of the area beside a circle of radius 1 in the corner of its square.
constexpr double kBeside = 1 - std::numbers::pi / 4;

double volume_of(const TopoDS_Shape& shape) { return mass_of(shape).volume; }

TopoDS_Shape solid_of(const TopoDS_Shape& made) {
  return TopExp_Explorer(made, TopAbs_SOLID).Current();
}

// The edges whose ends and middle are all at a height.
std::vector<int> edges_at_height(const TopoDS_Shape& shape, double z) {
  std::vector<int> found;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (const EdgeFacts& each : edge_facts(shape)) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(each.number));
    const double first = BRep_Tool::Pnt(TopExp::FirstVertex(edge)).Z(),
                 last = BRep_Tool::Pnt(TopExp::LastVertex(edge)).Z();
    if (std::max({std::abs(each.middle[2] - z), std::abs(first - z), std::abs(last - z)}) < 1e-9)
      found.push_back(each.number);
  }
  return found;
}

TEST(FilletOfAWall, OfHalfItsThicknessRoundsTheRimOfATray) {
  const TopoDS_Shape inside = BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 2), 38, 28, 20).Shape();
  const TopoDS_Shape tray =
      solid_of(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40, 30, 20).Shape(), inside));
  const FilletResult made = fillet(tray, edges_at_height(tray, 20), {.radius = 0.5});
  expect_sound(made);
  // Strips meet in mitres: as much is taken at any distance from the middle of the wall as along a
  // rectangle there, and these are as long as the middle one on an average.
  const double middle = 2 * (39 + 29), across = 2 * kBeside * 0.25;
  EXPECT_NEAR(made.solids.front().volume, volume_of(tray) - middle * across, 1e-7);
}

// The contacts begin in different places of one circle.
TEST(FilletOfAWall, OfHalfItsThicknessRoundsTheEndOfATube) {
  const gp_Ax2 turned({0, 0, -1}, {0, 0, 1}, {0.3, 1, 0});
  const TopoDS_Shape inside = BRepPrimAPI_MakeCylinder(turned, 8, 30);
  const TopoDS_Shape tube =
      solid_of(BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(10, 20).Shape(), inside));
  const FilletResult made = fillet(tube, edges_at_height(tube, 20), {.radius = 1});
  expect_sound(made);
  EXPECT_NEAR(made.solids.front().volume, volume_of(tube) - 2 * std::numbers::pi * 9 * 2 * kBeside,
              1e-7);
}

TopoDS_Shape angle(double thickness) {
  BRepBuilderAPI_MakePolygon outline;
  const double t = thickness;
  for (const gp_Pnt& each : {gp_Pnt(0, 0, 0), gp_Pnt(28, 0, 0), gp_Pnt(28, t, 0), gp_Pnt(t, t, 0),
                             gp_Pnt(t, 25, 0), gp_Pnt(0, 25, 0)})
    outline.Add(each);
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 30));
}

// Its contact on the end of the angle runs along the edge of the inner side, and goes on from the
// inner corner to the other wall.
TEST(FilletOfAWall, AsLargeAsItIsThickGoesAlongItsFarEdge) {
  const TopoDS_Shape shape = angle(4);
  for (const EdgeFacts& each : edge_facts(shape)) {
    if (distance(each.middle, Vec3{0, 12.5, 30}) > 1e-9) continue;
    const FilletResult made = fillet(shape, {each.number}, {.radius = 4});
    expect_sound(made);
    EXPECT_TRUE(made.notes.empty()) << made.notes.front();
    EXPECT_NEAR(made.solids.front().volume, volume_of(shape) - kBeside * 16 * 25, 1e-7);
    return;
  }
  FAIL() << "no such edge";
}

int edge_with_middle(const TopoDS_Shape& shape, const Vec3& middle) {
  for (const EdgeFacts& each : edge_facts(shape))
    if (distance(each.middle, middle) < 1e-9) return each.number;
  ADD_FAILURE() << "no edge there";
  return 0;
}

TopoDS_Shape united(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  ShapeUpgrade_UnifySameDomain made(BRepAlgoAPI_Fuse(a, b).Shape());
  made.Build();
  return solid_of(made.Shape());
}

// An upright edge of a rib that is flush with its plate: below, the plate's top grows to the vertex
// in which the rib's other side ends.
TEST(FilletOfAWall, AsLargeAsARibIsThickEndsInItsFoot) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(60, 40, 4).Shape();
  const TopoDS_Shape rib = BRepPrimAPI_MakeBox(gp_Pnt(0, 8, 4), 50, 1, 5).Shape();
  const TopoDS_Shape shape = united(plate, rib);
  const FilletResult made = fillet(shape, {edge_with_middle(shape, {0, 8, 6.5})}, {.radius = 1});
  expect_sound(made);
  EXPECT_TRUE(made.notes.empty()) << made.notes.front();
  EXPECT_NEAR(made.solids.front().volume, volume_of(shape) - kBeside * 5, 1e-7);
}

// The side of the plate is used up, and on its top the contact comes to a rib and runs along it.
TEST(FilletOfAWall, AsLargeAsAPlateIsThickGoesAlongARibOnIt) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(20, 10, 3).Shape();
  const TopoDS_Shape rib = BRepPrimAPI_MakeBox(gp_Pnt(5, 3, 3), 4, 5, 6).Shape();
  const TopoDS_Shape shape = united(plate, rib);
  const FilletResult made = fillet(shape, {edge_with_middle(shape, {10, 0, 3})}, {.radius = 3});
  expect_sound(made);
  EXPECT_TRUE(made.notes.empty()) << made.notes.front();
  EXPECT_NEAR(made.solids.front().volume, volume_of(shape) - kBeside * 9 * 20, 1e-7);
}

// A ruled loft between two rectangles, on a plate: its walls are splines, though flat.
TopoDS_Shape drafted_boss() {
  BRepOffsetAPI_ThruSections loft(Standard_True, Standard_True);
  for (const auto& [z, inset] : {std::pair{0.0, 0.0}, std::pair{10.0, 1.0}}) {
    BRepBuilderAPI_MakePolygon outline;
    const double a = inset, x = 20 - inset, y = 14 - inset;
    for (const gp_Pnt& each : {gp_Pnt(a, a, z), gp_Pnt(x, a, z), gp_Pnt(x, y, z), gp_Pnt(a, y, z)})
      outline.Add(each);
    outline.Close();
    loft.AddWire(outline.Wire());
  }
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -5), 40, 34, 5).Shape();
  return solid_of(BRepAlgoAPI_Fuse(plate, loft.Shape()));
}

bool is_spline(const TopoDS_Face& face) {
  return BRep_Tool::Surface(face)->IsKind(STANDARD_TYPE(Geom_BSplineSurface));
}

// A foot of radius 2 along one of the walls: the ones beside it grow to its contact.
TEST(FilletOfAWall, WithDraftEndsInTheWallsBesideItAsBetweenPlanes) {
  const TopoDS_Shape shape = drafted_boss();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (const EdgeFacts& each : edge_facts(shape)) {
    if (distance(each.middle, Vec3{10, 0, 0}) > 1e-9) continue;
    const FilletResult made = fillet(shape, {each.number}, {.radius = 2});
    expect_sound(made);
    EXPECT_TRUE(made.notes.empty()) << made.notes.front();
    // The section is that of two planes which the ball turns between, less its sector. It grows
    // shorter as the walls beside it lean, by the height of its centre of gravity.
    const double r = 2, slope = 0.1, lean = std::atan(slope),
                 half = (std::numbers::pi / 2 - lean) / 2;
    const double leg = r * std::tan(half), kite = r * leg, sector = r * r * half;
    const double kite_z = (2 * r + leg * std::cos(lean)) / 6;
    const double sector_z = r - 2 * r * std::sin(half) / (3 * half) * std::cos(half);
    const double taken = 20 * (kite - sector) - 2 * slope * (kite * kite_z - sector * sector_z);
    EXPECT_NEAR(made.solids.front().volume - volume_of(shape), taken, 1e-6);
    int splines = 0;
    for (const FilletFace& face : made.solids.front().faces)
      if (face.from > 0 && is_spline(face.face)) ++splines;
    EXPECT_EQ(splines, 1) << "the wall that has no part in it stays as it was";
    return;
  }
  FAIL() << "no such edge";
}

// Two lines with half circles round their ends.
TopoDS_Wire slot(double half, double radius, double z) {
  const std::array corners{gp_Pnt(-half, -radius, z), gp_Pnt(half, -radius, z),
                           gp_Pnt(half, radius, z), gp_Pnt(-half, radius, z)};
  const auto arc = [&](std::size_t from, double x) {
    return BRepBuilderAPI_MakeEdge(
        GC_MakeArcOfCircle(corners[from], gp_Pnt(x, 0, z), corners[(from + 1) % 4]).Value());
  };
  BRepBuilderAPI_MakeWire made;
  made.Add(BRepBuilderAPI_MakeEdge(corners[0], corners[1]));
  made.Add(arc(1, half + radius));
  made.Add(BRepBuilderAPI_MakeEdge(corners[2], corners[3]));
  made.Add(arc(3, -half - radius));
  return made;
}

// A pocket with walls that lean: where a flat one goes on in a round one, the ball's contact comes
// to the line between them before or behind the plane across the vertex below.
TEST(FilletOfAWall, WithDraftAndChangingRadiusGoesRoundAPocket) {
  BRepOffsetAPI_ThruSections core(true, true);
  core.AddWire(slot(8, 5, 0));
  core.AddWire(slot(7.5, 4, -6));
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-20, -12, -10), gp_Pnt(20, 12, 0)).Shape();
  const TopoDS_Shape shape = solid_of(BRepAlgoAPI_Cut(block, core.Shape()));
  const RadiusLaw law = RadiusLaw::table({0, 0.5, 1}, {0.3, 0.6, 0.3});
  for (const double z : {-6.0, 0.0}) {
    std::vector<int> round;
    for (const EdgeFacts& each : edge_facts(shape))
      if (std::abs(each.middle[2] - z) < 1e-9 &&
          std::hypot(each.middle[0], each.middle[1]) < 13.5 && std::abs(each.middle[1]) < 11)
        round.push_back(each.number);
    ASSERT_EQ(round.size(), 4U);
    const FilletResult made = fillet(shape, {round.front()}, {.law = law});
    expect_sound(made);
    EXPECT_EQ(made.edges, round) << "all round";
    if (made.solids.empty()) continue;
    for (const EdgeContinuity& each : edge_continuity(made.solids.front().solid))
      if (each.found && each.found->angle.value < 0.1) {
        EXPECT_LT(each.found->angle.value, 1e-5) << "contacts, and joints of strips";
      }
    const double change = made.solids.front().volume - made.volume_before;
    EXPECT_GT(z < -1 ? change : -change, 1);
  }
}

TopoDS_Shape prism_of(const std::vector<gp_Pnt>& corners, const gp_Vec& along) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& corner : corners) wire.Add(corner);
  wire.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire(), true).Face(), along).Shape();
}

void expect_full_round(const TopoDS_Shape& wall, const std::vector<int>& edges,
                       const Interval& radii) {
  ASSERT_EQ(edges.size(), 2U);
  const auto own = full_round_radii(wall, edges[0], edges[1]);
  for (const auto& [edge, of] : own) {
    const Interval found = of.law ? of.law->extremes({0, 1}) : Interval{of.radius, of.radius};
    EXPECT_NEAR(found.from, radii.from, 1e-12);
    EXPECT_NEAR(found.to, radii.to, 1e-12);
  }
  const FilletResult made = fillet(wall, edges, {.own = own});
  expect_sound(made, 1e-6);
  EXPECT_EQ(made.status, Status::Complete);
  EXPECT_EQ(made.solids.front().faces.size(), 7U);  // the top is gone, two strips are there
}

// The top is a trapezoid of the width 2 at x = 0 and 6 at x = 40. Across an edge it is farther to
// the middle than half of that.
TEST(FullRound, LeavesNothingOfAFaceWhoseEdgesAreNotParallel) {
  const TopoDS_Shape wall =
      prism_of({{0, -1, 0}, {40, -3, 0}, {40, 3, 0}, {0, 1, 0}}, gp_Vec(0, 0, 10));
  std::vector<int> edges;
  for (const EdgeFacts& each : edge_facts(wall))
    if (each.middle[2] == 10 && each.middle[0] == 20) edges.push_back(each.number);
  const double over = std::sqrt(1 + 0.05 * 0.05);
  expect_full_round(wall, edges, {over, 3 * over});
}

// The normals at the top's edges turn by atan(10 / 2) and atan(10 / 3).
TEST(FullRound, TakesOneRadiusBetweenWallsOfDifferentDraft) {
  const TopoDS_Shape wall =
      prism_of({{0, -4, 0}, {0, 5, 0}, {0, 2, 10}, {0, -2, 10}}, gp_Vec(40, 0, 0));
  std::vector<int> edges;
  for (const EdgeFacts& each : edge_facts(wall))
    if (each.middle[2] == 10 && each.middle[0] == 20) edges.push_back(each.number);
  const double radius = 4 / (std::tan(std::atan(5) / 2) + std::tan(std::atan(10.0 / 3) / 2));
  expect_full_round(wall, edges, {radius, radius});
}

TEST(FullRound, RefusesOtherEdges) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1., 2., 3.).Shape();
  EXPECT_THROW(full_round_radii(box, 1, 1), InvalidInput);
  EXPECT_THROW(full_round_radii(box, 1, 13), InvalidInput);
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(1, 3).Shape();
  EXPECT_THROW(full_round_radii(pin, 1, 3), InvalidInput);
}

// 10 comes out as 10.000000000000002 at some edges, and as 10 where it is told.
TEST(FullRound, TakesTheNumberWithTheFewestDigitsThatIsTheSame) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(60., 40., 20.).Shape();
  for (const auto& [edge, of] : full_round_radii(box, 9, 10)) EXPECT_EQ(of.radius, 10);
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 3)), 0.7);
  const TopoDS_Shape turned = BRepBuilderAPI_Transform(box, turn).Shape();
  for (const auto& [edge, of] : full_round_radii(turned, 9, 10)) EXPECT_EQ(of.radius, 10);
}

TEST(FullRound, CanBeMadeByTheRadiusThatIsTold) {
  const TopoDS_Shape wall =
      prism_of({{0, -4, 0}, {0, 5, 0}, {0, 2, 10}, {0, -2, 10}}, gp_Vec(40, 0, 0));
  std::vector<int> edges;
  for (const EdgeFacts& each : edge_facts(wall))
    if (each.middle[2] == 10 && each.middle[0] == 20) edges.push_back(each.number);
  auto own = full_round_radii(wall, edges[0], edges[1]);
  for (auto& [edge, of] : own) {
    const double told = told_radius(of.radius);
    EXPECT_LE(told, of.radius);
    EXPECT_GT(told, (1 - 1e-5) * of.radius);
    of.radius = told;
  }
  expect_sound(fillet(wall, edges, {.own = own}), 1e-6);
}

std::string round_refusal(const TopoDS_Shape& shape, int a, int b) {
  try {
    full_round_radii(shape, a, b);
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
  return {};
}

TEST(FullRound, NamesEdgesThatWouldDo) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(60., 40., 20.).Shape();
  const std::string told = round_refusal(box, 1, 7);
  EXPECT_NE(told.find("no face in common; edges 1 and 3"), std::string::npos) << told;
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(1, 3).Shape();
  EXPECT_EQ(round_refusal(pin, 1, 3).find("would do"), std::string::npos);
}

}  // namespace
}  // namespace blossom::occt
