// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids that touch: faces, edges and corners in common, with volumes known by hand. Without
// BLOSSOM_TRIALS some of each kind are tried.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/solids/solid_contacts.h"

namespace blossom::occt {
namespace {

using testing::box;
using testing::SolidContact;
using testing::turned;

double volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-10);
  return properties.Mass();
}

std::size_t solids(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_SOLID, map);
  return static_cast<std::size_t>(map.Extent());
}

// Both turned, so that nothing is parallel to an axis.
enum class Place { AsItIs, Turned };

class TrimSolidsInContact : public ::testing::TestWithParam<std::tuple<SolidContact, Place>> {
 protected:
  TopoDS_Shape placed(const TopoDS_Shape& shape) const {
    return std::get<1>(GetParam()) == Place::AsItIs ? shape : turned(shape, gp_Dir(1, 2, 3), 0.7);
  }
};

std::string words(const SolidTrimResult& result) {
  std::string text;
  for (const std::string& obstacle : result.obstacles) text += obstacle + "; ";
  return text;
}

void expect_solids(const SolidTrimResult& result, double wanted, double error, std::size_t count) {
  ASSERT_EQ(words(result), "");
  double sum = 0;
  for (const TopoDS_Solid& solid : result.solids) {
    EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
    sum += volume(solid);
  }
  EXPECT_NEAR(sum, wanted, error);
  EXPECT_EQ(result.solids.size(), count);
  EXPECT_LE(result.volumes.back().cut_error(), error);
  EXPECT_LE(result.volumes.back().fuse_error(), error);
}

TEST_P(TrimSolidsInContact, HasTheVolumesKnownByHandAndAsManySolidsAsOpenCascade) {
  const SolidContact& contact = std::get<0>(GetParam());
  const TopoDS_Shape a = placed(contact.a()), b = placed(contact.b());
  const TrimTool part = trim_tool(a), tool = trim_tool(b);
  const double of_a = volume(a), of_b = volume(b), common = contact.common;
  const std::size_t cut = solids(BRepAlgoAPI_Cut(a, b).Shape());
  const std::size_t both = solids(BRepAlgoAPI_Common(a, b).Shape());
  const auto expect = [&](const SolidTrimResult& made, double wanted, std::size_t count) {
    expect_solids(made, wanted, contact.error, count);
  };
  expect(trim_solids(part, {tool}, SolidOperation::Fuse), of_a + of_b - common,
         solids(BRepAlgoAPI_Fuse(a, b).Shape()));
  expect(trim_solids(part, {tool}, SolidOperation::Split), of_a, cut + both);
  expect(trim_solids(tool, {part}, SolidOperation::Cut), of_b - common,
         solids(BRepAlgoAPI_Cut(b, a).Shape()));
}

TopoDS_Shape shifted(const TopoDS_Shape& shape, const gp_Vec& by) {
  gp_Trsf move;
  move.SetTranslation(by);
  return BRepBuilderAPI_Transform(shape, move, true).Shape();
}

// As coordinates come out of a file, or of turning a part there and back.
TEST(TrimSolidsNearlyInContact, CountsAsInContactWithinTheTolerance) {
  const TrimTool part = trim_tool(box({0, 0, 0}, {1, 1, 1}));
  for (const double off : {1e-12, -1e-12, 1e-9, -1e-9, 4e-8, -4e-8}) {
    const gp_Vec by(0.6 * off, 0.5 * off, 0.62 * off);
    const TopoDS_Shape beside = shifted(box({1, 0, 0}, {2, 1, 1}), by);
    const SolidTrimResult fused = trim_solids(part, {trim_tool(beside)}, SolidOperation::Fuse);
    expect_solids(fused, 2, 1e-7, 1);
    const TopoDS_Shape flush = shifted(box({0.5, 0, 0.5}, {1.5, 0.5, 1}), by);
    const SolidTrimResult cut = trim_solids(part, {trim_tool(flush)}, SolidOperation::Cut);
    if (cut.obstacles.empty()) expect_solids(cut, 0.875, 1e-7, 1);
  }
}

// Beyond it results may be refused, but not wrong.
TEST(TrimSolidsNearlyInContact, IsRightOrRefusedBeyondTheTolerance) {
  const TrimTool part = trim_tool(box({0, 0, 0}, {1, 1, 1}));
  for (const double off : {2e-7, -2e-7, 1e-6, -1e-6, 1e-5, -1e-5}) {
    const TopoDS_Shape beside =
        shifted(box({1, 0, 0}, {2, 1, 1}), gp_Vec(0.6 * off, 0.5 * off, 0.62 * off));
    const SolidTrimResult fused = trim_solids(part, {trim_tool(beside)}, SolidOperation::Fuse);
    const double found = fused.obstacles.empty() ? fused.volumes.back().fuse : 2;
    EXPECT_NEAR(found, 2, std::abs(off));
  }
}

// Where edges touch, cuts meet them in the place that the edges know, however near they run.
TEST(TrimSolidsWithEdgesThatTouch, AddUp) {
  for (const SolidContact& contact : testing::touching_edges()) {
    SCOPED_TRACE(contact.name);
    const TrimTool part = trim_tool(contact.a()), tool = trim_tool(contact.b());
    for (const SolidOperation operation : {SolidOperation::Split, SolidOperation::Fuse}) {
      const SolidTrimResult result = trim_solids(part, {tool}, operation);
      ASSERT_EQ(words(result), "");
      EXPECT_LE(result.volumes.back().cut_error(), contact.error);
      EXPECT_LE(result.volumes.back().fuse_error(), contact.error);
    }
  }
}

TEST(TrimSolidsWithEdgesThatTouch, TellWhatIsThinnerThanTheTolerance) {
  const std::vector<SolidContact> all = testing::touching_edges();
  const auto slit = std::ranges::find(all, "SlitAtACusp", &SolidContact::name);
  const SolidTrimResult result =
      trim_solids(trim_tool(slit->a()), {trim_tool(slit->b())}, SolidOperation::Cut);
  EXPECT_EQ(result.status, Status::Tolerance);
  ASSERT_EQ(result.merged.size(), 1u);
  EXPECT_NE(result.merged.front().find("of the tool: cuts that keep within"), std::string::npos);
}

// The lower half of a cone of height 4 r within a box, a side of which its rim touches. On patches
// of 40 units cells and ends of arcs that count as one are nearly as long as the tolerance, on
// those of 1200 longer.
TEST(TrimSolidsWithEdgesThatTouch, MayBeLarge) {
  const gp_Ax2 axis({0, 0, 0}, gp_Dir(0.34, -0.28, -0.9));
  const gp_Dir across(gp_Vec(axis.XDirection()) * 0.6 + gp_Vec(axis.YDirection()) * 0.8);
  for (const double r : {10.0, 300.0}) {
    gp_Ax2 corner({0, 0, 0}, across, axis.Direction());
    corner.Translate(
        (gp_Vec(corner.XDirection()) * 4 + gp_Vec(corner.YDirection()) * 4 + gp_Vec(across)) * -r);
    const SolidTrimResult made = trim_solids(
        trim_tool(BRepPrimAPI_MakeCone(axis, r, 0, 4 * r).Shape()),
        {trim_tool(BRepPrimAPI_MakeBox(corner, 6 * r, 8 * r, 8 * r).Shape())}, SolidOperation::Cut);
    ASSERT_EQ(words(made), "") << r;
    EXPECT_NEAR(made.volumes.back().common / (r * r * r), 3.5 / 3 * std::numbers::pi, 1e-8);
    for (const TopoDS_Solid& solid : made.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  }
}

// One of each kind, for the quick tests.
bool is_quick(const std::string& name) {
  const std::array names{
      "EqualFaces",       "ShiftedFaces",      "FlushInTwo",           "Equal",
      "EdgeToEdge",       "WedgeOnAFace",      "CutThroughTwoEdges",   "Slot",
      "PocketAtAnEdge",   "RodOnAPlate",       "RodInTheBorder",       "RodInTurnedRod",
      "HalfBalls",        "BallOnAPlate",      "LongRodLyingOnAPlate", "PegInAHole",
      "SplineCubeInCube", "EqualTurnedBalls",  "ConeInAPlate",         "DomesRoundTheirPole",
      "RodOnAnEllipse",   "RingInABall",       "ConeAtARim",           "CubeFlushWithRoundedCube",
      "FrustumAtTwoRims", "BarAtASplineCorner"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::tuple<SolidContact, Place>> cases(const std::vector<SolidContact>& all) {
  const bool only_quick = std::getenv("BLOSSOM_TRIALS") == nullptr;
  std::vector<std::tuple<SolidContact, Place>> chosen;
  for (const SolidContact& contact : all) {
    if (only_quick && !is_quick(contact.name)) continue;
    chosen.emplace_back(contact, Place::AsItIs);
    if (!only_quick) chosen.emplace_back(contact, Place::Turned);
  }
  return chosen;
}

std::string name_of(const ::testing::TestParamInfo<std::tuple<SolidContact, Place>>& of) {
  return std::get<0>(of.param).name + (std::get<1>(of.param) == Place::Turned ? "Turned" : "");
}

INSTANTIATE_TEST_SUITE_P(Boxes, TrimSolidsInContact,
                         ::testing::ValuesIn(cases(testing::box_contacts())), name_of);
INSTANTIATE_TEST_SUITE_P(Prisms, TrimSolidsInContact,
                         ::testing::ValuesIn(cases(testing::prism_contacts())), name_of);
INSTANTIATE_TEST_SUITE_P(Rods, TrimSolidsInContact,
                         ::testing::ValuesIn(cases(testing::rod_contacts())), name_of);
INSTANTIATE_TEST_SUITE_P(Balls, TrimSolidsInContact,
                         ::testing::ValuesIn(cases(testing::ball_contacts())), name_of);
INSTANTIATE_TEST_SUITE_P(Wedges, TrimSolidsInContact,
                         ::testing::ValuesIn(cases(testing::wedge_contacts())), name_of);
INSTANTIATE_TEST_SUITE_P(ConesAndRings, TrimSolidsInContact,
                         ::testing::ValuesIn(cases(testing::cone_and_ring_contacts())), name_of);
INSTANTIATE_TEST_SUITE_P(HolesAndCorners, TrimSolidsInContact,
                         ::testing::ValuesIn(cases(testing::hole_and_corner_contacts())), name_of);
INSTANTIATE_TEST_SUITE_P(Splines, TrimSolidsInContact,
                         ::testing::ValuesIn(cases(testing::spline_contacts())), name_of);

}  // namespace
}  // namespace blossom::occt
