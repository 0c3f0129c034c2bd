// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets round the foot of a wing whose edges are sharp: strips of both sides run into each other
// beyond them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Precision.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"

namespace blossom::occt {
namespace {

using testing::expect_sound;

constexpr int kPoints = 19;      // of a profile's side, denser at its ends
constexpr double kLength = 6;    // of the profile
constexpr double kHeight = 0.3;  // of either side in its middle

// A side of a profile, as high as a parabola.
TopoDS_Edge side(double sign, double y, double z) {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double share = 0.5 * (1 - std::cos(std::numbers::pi * i / (kPoints - 1)));
    points->SetValue(i + 1, {kLength * share, y + sign * 4 * kHeight * share * (1 - share), z});
  }
  GeomAPI_Interpolate curve(points, Standard_False, Precision::Confusion());
  curve.Perform();
  return BRepBuilderAPI_MakeEdge(curve.Curve());
}

TopoDS_Wire profile(double y, double z) {
  BRepBuilderAPI_MakeWire wire;
  wire.Add(side(1, y, z));
  wire.Add(side(-1, y, z));
  return wire;
}

// On a plate, and leaning to one side: by so much for each unit of height.
TopoDS_Shape wing_on_a_plate(double leaning) {
  BRepOffsetAPI_ThruSections wing(true, true);
  wing.AddWire(profile(-leaning, -1));
  wing.AddWire(profile(5 * leaning, 5));
  wing.Build();
  return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, -2), gp_Pnt(11, 5, 0)).Shape(),
                          wing.Shape());
}

// The side that leans over the plate has the narrower strip at the sharp edges; its surface ends
// there, and goes on behind them as far as the other strip comes.
TEST(FilletRoundAWing, MeetsBehindItsSharpEdges) {
  for (const double leaning : {0.0, 0.3, 0.7}) {
    const TopoDS_Shape shape = wing_on_a_plate(leaning);
    std::vector<int> foot;
    for (const EdgeFacts& each : edge_facts(shape))
      if (each.kind == EdgeKind::Concave) foot.push_back(each.number);
    ASSERT_EQ(foot.size(), 2U);
    for (const double radius : {0.02, 0.1, 0.2}) {
      SCOPED_TRACE("leaning " + std::to_string(leaning) + ", radius " + std::to_string(radius));
      const FilletResult made = fillet(shape, foot, {.radius = radius});
      expect_sound(made);
      ASSERT_FALSE(made.solids.empty());
      EXPECT_TRUE(made.notes.empty()) << made.notes.front();
      EXPECT_GT(made.solids.front().volume, made.volume_before);
    }
  }
}

}  // namespace
}  // namespace blossom::occt
