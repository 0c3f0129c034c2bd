// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets between free-form faces that meet smoothly in some places and sharply in others.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "adapters/occt/base/edge_tolerance.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/soundness.h"
#include "tests/adapters/occt/fillet_checks.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

using testing::expect_sound;
using testing::told;

// Two arcs from (-10, 0) to (10, 0) and back, as high as `bulge` in the middle: a circle if that is
// 10, else a lens.
TopoDS_Wire two_arcs(double bulge, double z) {
  const gp_Pnt left(-10, 0, z), right(10, 0, z);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(left, gp_Pnt(0, bulge, z), right).Value()));
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(right, gp_Pnt(0, -bulge, z), left).Value()));
  return wire;
}

// A circle below, a lens above: the two side faces meet smoothly in the vertices below, and with
// growing angles from there up.
TopoDS_Shape lens_over_circle() {
  BRepOffsetAPI_ThruSections maker(true, true);
  maker.AddWire(two_arcs(10, 0));
  maker.AddWire(two_arcs(4, 10));
  maker.CheckCompatibility(false);
  maker.Build();
  return maker.Shape();
}

std::vector<int> edges_at_height(const TopoDS_Shape& shape, double z) {
  std::vector<int> found;
  for (const EdgeFacts& each : edge_facts(shape))
    if (std::abs(each.middle[2] - z) < 1e-6) found.push_back(each.number);
  return found;
}

// The ball beside the circle comes to an edge of some degrees at both vertices, where the circle
// itself goes on smoothly.
TEST(FilletOfFacesThatMeetSmoothlyInAVertex, HasMitresWhereTheBallComesToTheirEdge) {
  const TopoDS_Shape shape = lens_over_circle();
  const std::vector<int> rim = edges_at_height(shape, 0);
  ASSERT_EQ(rim.size(), 2U);
  for (const double radius : {0.1, 0.5, 1.0}) {
    const FilletResult made = fillet(shape, {rim.front()}, {.radius = radius});
    expect_sound(made);
    EXPECT_EQ(made.edges, rim);
    if (made.solids.empty()) continue;
    EXPECT_EQ(made.solids.front().faces.size(), 6U) << "both arcs have a strip of their own";
    EXPECT_LT(made.solids.front().volume, made.volume_before);
  }
}

// At the circle the strip has no width: both contacts begin in the vertex there, and the circle
// stays as it was.
TEST(FilletOfFacesThatMeetSmoothlyInAVertex, NarrowsToAPointThere) {
  const TopoDS_Shape shape = lens_over_circle();
  const std::vector<EdgeFacts> edges = edge_facts(shape);
  std::vector<int> sides;
  for (const EdgeFacts& each : edges)
    if (std::abs(each.middle[2] - 5) < 1e-6) sides.push_back(each.number);
  ASSERT_EQ(sides.size(), 2U);
  for (const double radius : {0.1, 1.0, 3.0}) {
    const FilletResult made = fillet(shape, sides, {.radius = radius});
    expect_sound(made);
    if (made.solids.empty()) continue;
    EXPECT_TRUE(made.notes.empty()) << made.notes.front();
    const TopoDS_Solid& solid = made.solids.front().solid;
    EXPECT_EQ(made.solids.front().faces.size(), 6U);
    for (const EdgeFacts& each : edge_facts(solid)) {
      const bool is_arc = std::abs(each.middle[2]) < 1e-6 && each.length > 1;
      EXPECT_NEAR(is_arc ? each.length : 10 * std::numbers::pi, 10 * std::numbers::pi, 1e-4);
    }
    EXPECT_LT(made.solids.front().volume, made.volume_before);
    for (TopExp_Explorer it(solid, TopAbs_VERTEX); it.More(); it.Next())
      EXPECT_LT(BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())), 1e-4) << radius;
  }
}

// The lens with one of its side faces moved along x, across itself in all vertices. Edges and
// vertices have tolerances for that.
TopoDS_Shape lens_apart(double by) {
  const TopoDS_Shape shape = BRepBuilderAPI_Copy(lens_over_circle()).Shape();
  const BRep_Builder builder;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);  // its own, as it is a copy
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    surface->Bounds(u0, u1, v0, v1);
    if (surface->IsKind(STANDARD_TYPE(Geom_Plane)) || surface->Value((u0 + u1) / 2, v0).Y() < 1)
      continue;
    surface->Translate(gp_Vec(by, 0, 0));
    for (TopExp_Explorer of(face, TopAbs_EDGE); of.More(); of.Next())
      builder.UpdateEdge(TopoDS::Edge(of.Current()), 2 * std::abs(by));
    for (TopExp_Explorer of(face, TopAbs_VERTEX); of.More(); of.Next())
      builder.UpdateVertex(TopoDS::Vertex(of.Current()), 2 * std::abs(by));
  }
  return shape;
}

// Faces 5e-6 apart turn against each other with the way along the edge: strips come to a point
// beside the vertex, on the edge, of which the smooth rest stays.
TEST(FilletOfFacesThatMeetSmoothlyInAVertex, NarrowsToAPointAsFarAsTheyAreApart) {
  for (const double by : {5e-6, -5e-6}) {
    const TopoDS_Shape shape = lens_apart(by);
    ASSERT_TRUE(BRepCheck_Analyzer(shape).IsValid());
    for (const int side : edges_at_height(shape, 5)) {
      const FilletResult made = fillet(shape, {side}, {.radius = 1, .largest = false});
      ASSERT_EQ(made.solids.size(), 1U) << told(made);
      EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front().solid).IsValid());
      EXPECT_TRUE(made.notes.empty()) << made.notes.front();
      EXPECT_EQ(made.solids.front().faces.size(), 5U);
    }
  }
}

// A square below, a circle above: upright edges are sharp below and smooth above.
TopoDS_Shape circle_over_square() {
  BRepOffsetAPI_ThruSections maker(true, false);
  maker.AddWire(BRepBuilderAPI_MakePolygon(gp_Pnt(-20, -20, 0), gp_Pnt(20, -20, 0),
                                           gp_Pnt(20, 20, 0), gp_Pnt(-20, 20, 0), true)
                    .Wire());
  maker.AddWire(BRepBuilderAPI_MakeWire(
      BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 40), gp_Dir(0, 0, 1)), 12))));
  maker.Build();
  return maker.Shape();
}

// Where the faces turn by less than the angle the other border is nowhere.
TEST(ChamferOfFacesThatMeetSmoothlyInAVertex, IsRefusedByAnAngleThatTheyDoNotTurnBy) {
  const TopoDS_Shape shape = circle_over_square();
  const std::vector<int> upright = edges_at_height(shape, 20);
  ASSERT_GE(upright.size(), 4U);
  for (const double size : {2.0, 25.0}) {
    FilletOptions options;
    options.chamfer = ChamferSize{size, {}, std::numbers::pi / 6};
    const FilletResult made = fillet(shape, upright, options);
    EXPECT_TRUE(made.solids.empty());
    EXPECT_NE(told(made).find("at that angle does not meet the other face"), std::string::npos)
        << told(made);
  }
}

// Steps of some of these distances came to places past an end of the edge, but to none on it, and
// what was to be fitted between had no ends: once the program crashed then.
TEST(ChamferBesideAFreeFormFace, OfFarTooLargeADistanceIsRefused) {
  const TopoDS_Shape shape = circle_over_square();
  const std::vector<int> below = edges_at_height(shape, 0);
  EXPECT_GE(below.size(), 4U);
  for (const int edge : below)
    for (const double size : {40.0, 80.0, 150.0, 400.0}) {
      FilletOptions options;
      options.chamfer = ChamferSize{size, {}, std::numbers::pi / 6};
      options.largest = false;
      const FilletResult made = fillet(shape, {edge}, options);
      EXPECT_TRUE(made.solids.empty());
      EXPECT_EQ(made.refused.size(), 1U) << size;
    }
}

TopoDS_Wire wedge(double length, double twist, double z) {
  const double half = length * std::tan(0.5 * 20 * std::numbers::pi / 180);
  return BRepBuilderAPI_MakePolygon(gp_Pnt(length, twist, z), gp_Pnt(0, half, z),
                                    gp_Pnt(0, -half, z), true);
}

// An oblique tube on a box. A pipe's wall is a rectangle of the surface of extrusion that a prism
// has as a wall: Open CASCADE does not say that it closes, and the contact goes over its seam.
TEST(FilletRoundAnObliqueTube, IsTheSameOnARectangleOfItsSurface) {
  const gp_Pnt foot(0, 0, 0), top(10, 10, 0);
  const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(foot, gp_Dir(1, 0, 0)), 5));
  const TopoDS_Face outline = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(circle).Wire());
  const TopoDS_Wire spine = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(foot, top));
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-15, -15, -15), gp_Pnt(0, 15, 15)).Shape();
  std::vector<double> more;
  for (const TopoDS_Shape& tube : {BRepPrimAPI_MakePrism(outline, gp_Vec(foot, top)).Shape(),
                                   BRepOffsetAPI_MakePipe(spine, outline).Shape()}) {
    const TopoDS_Shape shape = BRepAlgoAPI_Fuse(tube, box).Shape();
    std::vector<int> concave;
    for (const EdgeFacts& each : edge_facts(shape))
      if (each.kind == EdgeKind::Concave) concave.push_back(each.number);
    ASSERT_EQ(concave.size(), 1U);
    const FilletResult made = fillet(shape, concave, {.radius = 1});
    expect_sound(made);
    if (!made.solids.empty()) more.push_back(made.solids.front().volume - made.volume_before);
  }
  ASSERT_EQ(more.size(), 2U);
  EXPECT_NEAR(more[0], more[1], 1e-6 * more[0]);
}

// A plate with a twisted post on it, whose outline is a wedge of 20 degrees.
TopoDS_Shape wedge_on_a_plate() {
  BRepOffsetAPI_ThruSections post(true, true);
  post.AddWire(wedge(10, 0, 1));
  post.AddWire(wedge(9, 0.5, 7));
  post.Build();
  return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0), gp_Pnt(20, 10, 2)).Shape(),
                          post.Shape());
}

// Round the sharp end the two strips come near to each other only far beyond it; at the others they
// come to the upright edge at two heights.
TEST(FilletRoundATwistedPost, IsSetBackWhereStripsDoNotMeet) {
  const TopoDS_Shape shape = wedge_on_a_plate();
  std::vector<int> foot;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Concave) foot.push_back(each.number);
  ASSERT_EQ(foot.size(), 3U);
  const FilletResult made = fillet(shape, foot, {.radius = 0.5});
  expect_sound(made);
  ASSERT_FALSE(made.solids.empty());
  EXPECT_TRUE(made.notes.empty()) << made.notes.front();
  EXPECT_GT(made.solids.front().volume, made.volume_before);
}

std::filesystem::path given_model(const char* name) {
  const char* data = blossom::testing::test_data();
  return std::filesystem::path(data != nullptr ? data : "") / "models" / name;
}

std::filesystem::path propeller() { return given_model("propeller.brep"); }

// At the trailing edge one face bends so strongly that the ball does not come to the other strip.
TEST(FilletOfRealFaces, EndsInPlanesBeforeStripsThatItDoesNotComeTo) {
  const std::filesystem::path wing = given_model("d150_wing.brep");
  if (!std::filesystem::exists(wing)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const FilletResult made =
      fillet(testing::repaired_model(wing).shape(), {2}, {.radius = 0.194844});
  expect_sound(made);
  EXPECT_EQ(made.notes.size(), 2U);
}

// Round the tip of a wing the ball turns round beside both vertices: contacts stop there, and those
// of the two strips cross far away only, at the other vertex.
TEST(FilletOfRealFaces, EndsInPlanesBeforeItsBallTurnsRound) {
  const std::filesystem::path wing = given_model("d150_wing.brep");
  if (!std::filesystem::exists(wing)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(wing);
  for (const double radius : {0.0143912, 0.0479706})
    expect_sound(fillet(model.shape(), {14}, {.radius = radius}));
}

// Behind the end of its edge the ball goes on beside the next one, which it does not round, to
// where there is no room for it: the strip ends in a plane at the edge's end.
TEST(FilletOfRealFaces, EndsInAPlaneThoughItsBallRollsOnToWhereItHasNoRoom) {
  if (!std::filesystem::exists(propeller())) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(propeller());
  for (const double radius : {0.00178598, 0.00535793, 0.0178598})
    expect_sound(fillet(model.shape(), {37}, {.radius = radius}),
                 largest_edge_tolerance(model.shape()));
}

// The strips of both sides of the wing run into each other behind its sharp rear edge, for which
// the lower side grows past the border of its surface.
TEST(FilletOfRealFaces, MeetBehindTheRearEdgeOfAWing) {
  const std::filesystem::path plane = given_model("d150_fused.brep");
  if (!std::filesystem::exists(plane)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(plane);
  for (const double radius : {0.01, 0.05, 0.195}) {
    const FilletResult made = fillet(model.shape(), {222}, {.radius = radius});
    expect_sound(made);
    EXPECT_EQ(made.status, Status::Complete);
    EXPECT_EQ(made.edges, (std::vector<int>{222, 223, 228, 229, 235, 236}));
    for (const std::string& note : made.notes)
      EXPECT_EQ(note.find("ends in a plane"), std::string::npos) << note;
  }
}

// Its strip ends in a face that it crosses at a small angle, beside an edge of a tolerance of 1e-4:
// their curve misses the vertex there by ten times as much.
TEST(FilletOfRealFaces, EndsAtVerticesThatCoverTheMissesOfTolerantEdges) {
  if (!std::filesystem::exists(propeller())) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(propeller());
  for (const double radius : {1.80723, 5.42168})
    expect_sound(fillet(model.shape(), {64}, {.radius = radius}),
                 largest_edge_tolerance(model.shape()));
}

// What the faces beside these edges are apart at the point to which their strips narrow.
constexpr double kOffPoint = 0.0125;

// At one end of these edges the narrower face turns over. Balls of some radii leave it before the
// end, others roll on past it to a third face: their strips end in planes before that.
TEST(FilletOfRealFaces, EndsInAPlaneBeforeItsNarrowFaceTurnsOver) {
  if (!std::filesystem::exists(propeller())) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(propeller());
  for (const double radius : {0.02, 0.043113, 0.055, 0.2, 1.29339}) {
    const FilletResult made = fillet(model.shape(), {36}, {.radius = radius, .largest = false});
    expect_sound(made, kOffPoint);
    ASSERT_EQ(made.notes.size(), 1U) << radius;
    EXPECT_NE(made.notes.front().find("ends in a plane"), std::string::npos) << radius;
  }
}

// Of a smaller ball the contact is nowhere in the narrow face: it is no radius that is too large.
TEST(FilletOfRealFaces, IsToldALargerRadiusWhereNoSmallerOneWorks) {
  if (!std::filesystem::exists(propeller())) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(propeller());
  const FilletResult made = fillet(model.shape(), {36}, {.radius = 0.003});
  ASSERT_EQ(made.refused.size(), 1U);
  const FilletRefusal& why = made.refused.front();
  ASSERT_TRUE(why.largest) << told(made);
  EXPECT_GT(*why.largest, 2);
  EXPECT_NE(told(made).find("larger radii work"), std::string::npos) << told(made);
  expect_sound(fillet(model.shape(), {36}, {.radius = *why.told_largest(), .largest = false}),
               kOffPoint);
}

// The narrow face beside the rim is consumed, and the contact on the other one goes over bolt
// holes: through their middles, and, of the larger ball, through their far halves alone.
TEST(FilletOfRealFaces, GoesOverBoltHolesBehindANarrowFace) {
  const std::filesystem::path part = given_model("nist_ctc_02.stp");
  if (!std::filesystem::exists(part)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(part);
  for (const double radius : {16.9736, 20.7395})
    expect_sound(fillet(model.shape(), {1222}, {.radius = radius, .largest = false}),
                 largest_edge_tolerance(model.shape()));
}

// The wall at its end stands on the edge 0.002 before the vertex, which has a tolerance of 0.0027:
// of a piece between them nothing would be left.
TEST(FilletOfRealFaces, EndsInAPlaneThatLeavesNoPieceOfItsEdgeWithinAVertex) {
  const std::filesystem::path arm = given_model("crankarm.brep");
  if (!std::filesystem::exists(arm)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(arm);
  for (const int edge : {84, 97}) {
    const FilletResult made = fillet(model.shape(), {edge}, {.radius = 0.006, .largest = false});
    ASSERT_EQ(made.solids.size(), 2U) << told(made);
    for (const FilletedSolid& each : made.solids)
      EXPECT_TRUE(BRepCheck_Analyzer(each.solid).IsValid()) << "edge " << edge;
  }
}

// Its face goes on in the cone at its end with a gap below the edge's tolerance: the curve in which
// the strip meets the cone passes the contact at the root of that.
TEST(FilletOfRealFaces, EndsInAFaceThatItsStripTouches) {
  const std::filesystem::path arm = given_model("crankarm.brep");
  if (!std::filesystem::exists(arm)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(arm);
  for (const int edge : {84, 89, 97}) {
    const FilletResult made = fillet(model.shape(), {edge}, {.radius = 2.24419, .largest = false});
    ASSERT_EQ(made.solids.size(), 2U) << told(made);
    for (const FilletedSolid& each : made.solids)
      EXPECT_TRUE(BRepCheck_Analyzer(each.solid).IsValid()) << "edge " << edge;
  }
}

// Round the pocket's tip the contact goes over a smooth edge, behind which it comes 7e-4 later into
// the face, as the faces do not quite touch: that is not its way out.
TEST(FilletOfRealFaces, GoesOverASmoothEdgeWithAGap) {
  const std::filesystem::path arm = given_model("crankarm.brep");
  if (!std::filesystem::exists(arm)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(arm);
  const FilletResult made = fillet(model.shape(), {62}, {.radius = 2.46165, .largest = false});
  ASSERT_EQ(made.solids.size(), 2U) << told(made);
  for (const FilletedSolid& each : made.solids)
    EXPECT_TRUE(BRepCheck_Analyzer(each.solid).IsValid());
}

// Its faces bend within the radius of the edge: the ball is followed to there, not guessed.
TEST(FilletOfRealFaces, IsFoundWhereItsContactsAreFarFromThoseOfTheTangentPlanes) {
  const std::filesystem::path wing = given_model("d150_wing.brep");
  if (!std::filesystem::exists(wing)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(wing);
  expect_sound(fillet(model.shape(), {1}, {.radius = 0.187505, .largest = false}));
}

// Towards the tip the blade is thinner than the ball, which turns back there along the other edge:
// once this took the blade's end away.
TEST(FilletOfRealFaces, IsRefusedWhereTheBallTurnsBack) {
  if (!std::filesystem::exists(propeller())) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(propeller());
  for (const double radius : {6.1, 7.4, 12.3988}) {
    const FilletResult made = fillet(model.shape(), {74}, {.radius = radius, .largest = false});
    EXPECT_TRUE(made.solids.empty()) << radius;
    EXPECT_NE(told(made).find("turns back"), std::string::npos) << told(made);
  }
}

// Where determinants along a ball's way were noise, cusps were looked for without an end.
TEST(FilletOfRealFaces, WithAFarTooLargeRadiusIsRefusedInAShortTime) {
  if (!std::filesystem::exists(propeller())) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(propeller());
  const FilletResult made = fillet(model.shape(), {64}, {.radius = 54.2168});
  EXPECT_TRUE(made.solids.empty());
  EXPECT_EQ(made.refused.size(), 1U);
}

// A vase of three circles with a wall 2 thick, open above: its inside is an offset of its outside.
constexpr double kShellTolerance = 1e-3;
TopoDS_Shape shelled_loft() {
  BRepOffsetAPI_ThruSections loft(true, false);
  for (const Vec2& level : {Vec2{30, 0}, Vec2{38, 20}, Vec2{25, 50}}) {
    const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, level[1]), gp::DZ()), level[0]);
    loft.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)));
  }
  loft.Build();
  TopTools_ListOfShape open;
  for (TopExp_Explorer it(loft.Shape(), TopAbs_FACE); it.More(); it.Next()) {
    const auto plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(TopoDS::Face(it.Current())));
    if (!plane.IsNull() && plane->Location().Z() > 49) open.Append(it.Current());
  }
  BRepOffsetAPI_MakeThickSolid shell;
  shell.MakeThickSolidByJoin(loft.Shape(), open, -2, kShellTolerance);
  return shell.Shape();
}

// The inside is closed, which Open CASCADE says of no offset surface.
TEST(FilletOfAShelledLoft, RoundsEachRimInsideAndOutside) {
  const TopoDS_Shape vase = shelled_loft();
  int rims = 0;
  for (const double height : {0.0, 2.0, 50.0})
    for (const int edge : edges_at_height(vase, height)) {
      SCOPED_TRACE(edge);
      expect_sound(fillet(vase, {edge}, {.radius = 0.5}), kShellTolerance);
      ++rims;
    }
  EXPECT_EQ(rims, 4);
}

// Between both rims at the top there is room for two balls of 1, whose contacts meet in the middle.
TEST(FilletOfAShelledLoft, HasRoomForBallsOfHalfItsWall) {
  const TopoDS_Shape vase = shelled_loft();
  const FilletResult made = fillet(vase, edges_at_height(vase, 50), {.radius = 1.5});
  ASSERT_EQ(made.refused.size(), 1U) << told(made);
  ASSERT_TRUE(made.refused.front().largest) << told(made);
  EXPECT_NEAR(*made.refused.front().largest, 1, 1e-5);
}

}  // namespace
}  // namespace blossom::occt
