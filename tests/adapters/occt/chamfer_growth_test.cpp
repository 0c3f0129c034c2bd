// SPDX-License-Identifier: LGPL-2.1-or-later
// Chamfers at whose ends spline faces grow past the natural borders of their surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/base/edge_tolerance.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

using testing::expect_sound;

// A hexagon across the x axis.
TopoDS_Wire hexagon(double x, double y, double radius) {
  BRepBuilderAPI_MakePolygon made;
  for (int i = 0; i < 6; ++i) {
    const double angle = i * std::numbers::pi / 3;
    made.Add(gp_Pnt(x, y + radius * std::cos(angle), radius * std::sin(angle)));
  }
  made.Close();
  return made;
}

TopoDS_Wire rectangle(double x, double y, double z, double long_side, double short_side) {
  const double a = 0.5 * long_side, b = 0.5 * short_side;
  return BRepBuilderAPI_MakePolygon(gp_Pnt(x - a, y - b, z), gp_Pnt(x + a, y - b, z),
                                    gp_Pnt(x + a, y + b, z), gp_Pnt(x - a, y + b, z), true);
}

TopoDS_Shape ruled(const std::vector<TopoDS_Wire>& sections) {
  BRepOffsetAPI_ThruSections made(true, true);
  for (const TopoDS_Wire& each : sections) made.AddWire(each);
  made.CheckCompatibility(false);
  made.Build();
  return made.Shape();
}

FilletResult chamfered(const TopoDS_Shape& shape, const std::vector<int>& edges, double distance) {
  FilletOptions options;
  options.chamfer = ChamferSize{distance};
  return fillet(shape, edges, options);
}

// What programs that know nothing of where a surface ended make of it.
double measured(const TopoDS_Shape& shape) {
  GProp_GProps mass;
  BRepGProp::VolumePropertiesGK(shape, mass, 1e-7);
  return mass.Mass();
}

// Two edges in line meet at a bend of 5 degrees, with concave edges between them: the one strip
// goes over the face of the other, of which a hair lies past its border.
TEST(ChamferOfALoftedBar, KeepsTheToleranceBesideASlightBend) {
  const TopoDS_Shape bar =
      ruled({hexagon(0, -0.2516, 1.635), hexagon(6, 0.3572, 1.8856), hexagon(13, 0.1767, 1.915)});
  std::vector<int> low;  // in the plane of symmetry
  for (const EdgeFacts& each : edge_facts(bar))
    if (each.middle[1] < -1 && std::abs(each.middle[2]) < 1e-6) low.push_back(each.number);
  ASSERT_EQ(low.size(), 2U);
  const FilletResult made = chamfered(bar, low, 0.5);
  expect_sound(made, 1e-6);
  ASSERT_FALSE(made.solids.empty());
  EXPECT_NEAR(made.solids.front().volume, measured(made.solids.front().solid), 1e-5);
}

// Round the foot of a post with leaning walls, one edge after the other: the narrow walls grow by
// more than an eighth of their width.
TEST(ChamferAtALeaningPost, EndsInWallsThatGrowAsFarAsItIsWide) {
  const TopoDS_Shape post = ruled({rectangle(0, 0, -1, 5, 1.1), rectangle(0.4, 0.3, 8, 3.5, 0.8)});
  const TopoDS_Shape shape =
      BRepAlgoAPI_Fuse(post, BRepPrimAPI_MakeBox(gp_Pnt(-6, -5, -2), gp_Pnt(6, 5, 0)).Shape());
  std::vector<int> foot;
  for (const EdgeFacts& each : edge_facts(shape))
    if (each.kind == EdgeKind::Concave) foot.push_back(each.number);
  ASSERT_EQ(foot.size(), 4U);
  for (const int edge : foot) {
    const FilletResult made = chamfered(shape, {edge}, 0.4);
    expect_sound(made);
    ASSERT_FALSE(made.solids.empty());
    EXPECT_TRUE(made.notes.empty()) << made.notes.front();
    EXPECT_NEAR(made.solids.front().volume, measured(made.solids.front().solid), 1e-4);
  }
}

}  // namespace
}  // namespace blossom::occt
