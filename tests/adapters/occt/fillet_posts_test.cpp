// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets round the feet of lofted posts.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Precision.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

using testing::expect_sound;

// A closed smooth curve through six points, every other one of them farther out.
TopoDS_Wire rounded_ring(double radius, double out, double turn, double z) {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 6);
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::numbers::pi / 3 + turn, r = k % 2 == 0 ? radius : out * radius;
    points->SetValue(k + 1, gp_Pnt(r * std::cos(angle), r * std::sin(angle), z));
  }
  GeomAPI_Interpolate curve(points, Standard_True, Precision::Confusion());
  curve.Perform();
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve.Curve()));
}

TopoDS_Wire rectangle(double x0, double x1, double y0, double y1, double z) {
  return BRepBuilderAPI_MakePolygon(gp_Pnt(x0, y0, z), gp_Pnt(x1, y0, z), gp_Pnt(x1, y1, z),
                                    gp_Pnt(x0, y1, z), Standard_True)
      .Wire();
}

TopoDS_Shape on_plate(const std::vector<TopoDS_Wire>& sections, bool ruled) {
  BRepOffsetAPI_ThruSections post(true, ruled);
  for (const TopoDS_Wire& each : sections) post.AddWire(each);
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-15, -15, -3), gp_Pnt(15, 15, 0)).Shape();
  ShapeUpgrade_UnifySameDomain merged(BRepAlgoAPI_Fuse(plate, post.Shape()).Shape());
  merged.Build();
  return TopExp_Explorer(merged.Shape(), TopAbs_SOLID).Current();
}

std::vector<int> foot_of(const TopoDS_Shape& shape) {
  std::vector<int> found;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Concave) found.push_back(each.number);
  return found;
}

// Open CASCADE divides the sections at each other's vertices. Its side faces turn by up to a degree
// where they meet, convex at the one end of an edge and concave at the other.
TopoDS_Shape post_of_rings() {
  return on_plate(
      {rounded_ring(5, 1.3, 0, -1), rounded_ring(4, 1.2, 0.3, 5), rounded_ring(3, 1.1, 0.5, 12)},
      false);
}

TEST(FilletRoundALoftedPost, GoesRoundSlightBendsOfItsFaces) {
  const TopoDS_Shape shape = post_of_rings();
  const std::vector<int> foot = foot_of(shape);
  ASSERT_EQ(foot.size(), 3U);
  for (const auto& [radius, added] : {std::array{0.4, 0.7374}, std::array{1.2, 6.709}}) {
    const FilletResult made = fillet(shape, foot, {.radius = radius});
    expect_sound(made);
    EXPECT_TRUE(made.notes.empty());
    if (made.solids.empty()) continue;
    EXPECT_NEAR(made.solids.front().volume - made.volume_before, added, 1e-3 * added);
  }
}

// One edge alone would leave a stub of itself at each of its ends.
TEST(FilletRoundALoftedPost, GoesOnOverSlightBendsRatherThanEndBeforeThem) {
  const TopoDS_Shape shape = post_of_rings();
  const std::vector<int> foot = foot_of(shape);
  ASSERT_EQ(foot.size(), 3U);
  const FilletResult made = fillet(shape, {foot.front()}, {.radius = 0.4});
  expect_sound(made);
  EXPECT_EQ(made.edges, foot);
  EXPECT_EQ(made.status, Status::Complete);
  ASSERT_EQ(made.notes.size(), 1U) << "what else is rounded is told";
}

// Faces of the post end at the plate: ends of strips go past their borders.
TEST(FilletRoundALoftedPost, TakesNoLongerThanOtherFillets) {
  const TopoDS_Shape shape = on_plate(
      {rectangle(-5.6307, 5.6307, -4, 4, 0), rectangle(-5.0882, 2.1986, -2.4521, 2.7244, 4.3838)},
      true);
  FilletOptions options{.radius = 0.4};
  options.intersection.time_limit = 3;  // seconds: a tenth of one is enough
  for (const int edge : foot_of(shape)) {
    const FilletResult made = fillet(shape, {edge}, options);
    expect_sound(made);
    EXPECT_EQ(made.status, Status::Complete);
  }
}

int edge_at(const TopoDS_Shape& shape, const Vec3& middle) {
  for (const EdgeFacts& each : edge_facts(shape))
    if (distance(each.middle, middle) < 1e-3) return each.number;
  return 0;
}

// Long walls in planes, narrow ones of arcs that are extruded. Beside the foot of a long one the
// narrow ones grow by as much as they are wide.
TEST(FilletRoundAPostOfExtrudedWalls, EndsInWallsThatGoOnPastTheirSurfaces) {
  const auto bulge = [](double x, double y) {
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 4);
    for (int k = 0; k < 4; ++k)
      points->SetValue(k + 1, gp_Pnt(k % 3 == 0 ? x : 1.03 * x, y * (1 - 2.0 * k / 3), 0));
    GeomAPI_Interpolate curve(points, Standard_False, Precision::Confusion());
    curve.Perform();
    return TopoDS_Edge(BRepBuilderAPI_MakeEdge(curve.Curve()));
  };
  BRepBuilderAPI_MakeWire profile;
  profile.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(-3, -0.55, 0), gp_Pnt(3, -0.55, 0)));
  profile.Add(bulge(3, -0.55));
  profile.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(3, 0.55, 0), gp_Pnt(-3, 0.55, 0)));
  profile.Add(bulge(-3, 0.55));
  const TopoDS_Shape post =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(profile.Wire()), gp_Vec(0, 0, 8)).Shape();
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-15, -15, -3), gp_Pnt(15, 15, 0)).Shape();
  ShapeUpgrade_UnifySameDomain merged(BRepAlgoAPI_Fuse(plate, post).Shape());
  merged.Build();
  const TopoDS_Shape shape = TopExp_Explorer(merged.Shape(), TopAbs_SOLID).Current();
  for (const double y : {-0.55, 0.55})
    for (const double radius : {0.4, 0.8}) {
      const FilletResult made = fillet(shape, {edge_at(shape, {0, y, 0})}, {.radius = radius});
      expect_sound(made);
      EXPECT_TRUE(made.notes.empty()) << made.notes.front();
      if (made.solids.empty()) continue;
      GProp_GProps mass;
      BRepGProp::VolumePropertiesGK(made.solids.front().solid, mass, 1e-7);
      EXPECT_NEAR(made.solids.front().volume, mass.Mass(), 1e-5);
      const double along = 6 * (1 - std::numbers::pi / 4) * radius * radius;
      EXPECT_NEAR(made.solids.front().volume - made.volume_before, along, 0.05 * along);
    }
}

// A post that hangs over the border of its plate. Below it the contact on the plate's side does not
// come to the plate's top, which is next to it there, but to the post, if that went on; beside it
// to none but the post either.
TEST(FilletAtAPostThatHangsOver, EndsAtThePostWhichGoesOn) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -3), gp_Pnt(10, 10, 0)).Shape();
  const TopoDS_Shape post = BRepPrimAPI_MakeCone(gp_Ax2({7, 0, 0}, {0, 0, 1}), 5, 4, 10).Shape();
  const TopoDS_Shape shape =
      TopExp_Explorer(BRepAlgoAPI_Fuse(plate, post).Shape(), TopAbs_SOLID).Current();
  struct Case {
    Vec3 middle;
    double radius, change;  // the latter as Open CASCADE's own fillets have it
  };
  for (const Case& each : {Case{{10, 0, 0}, 0.4, 0.270673}, Case{{10, 0, 0}, 1.2, 2.352445},
                           Case{{10, -7, 0}, 1.2, -1.788696}}) {
    const FilletResult made = fillet(shape, {edge_at(shape, each.middle)}, {.radius = each.radius});
    expect_sound(made);
    EXPECT_TRUE(made.notes.empty()) << "it ends nowhere before its edge";
    if (made.solids.empty()) continue;
    EXPECT_NEAR(made.solids.front().volume - made.volume_before, each.change, 1e-5);
  }
}

}  // namespace
}  // namespace blossom::occt
