// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/validity/own_contacts.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Vec.hxx>

namespace blossom::occt {
namespace {

// A notch that goes down to the bottom: its tip lies in the middle of it.
TopoDS_Shape notched_to_the_bottom() {
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [x, y] :
       std::vector<std::pair<double, double>>{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}})
    outline.Add(gp_Pnt(x, y, 0));
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire(), true).Face(),
                               gp_Vec(0, 0, 2))
      .Shape();
}

// A void that reaches out of its solid.
TopoDS_Solid with_a_void_that_sticks_out() {
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  const TopoDS_Shape outer = BRepPrimAPI_MakeBox(4, 4, 4).Shape();
  const TopoDS_Shape inner = BRepPrimAPI_MakeBox(gp_Pnt(3, 1, 1), gp_Pnt(5, 3, 3)).Shape();
  builder.Add(solid, TopExp_Explorer(outer, TopAbs_SHELL).Current());
  builder.Add(solid, TopExp_Explorer(inner, TopAbs_SHELL).Current().Reversed());
  return solid;
}

TEST(OwnContacts, AreNoneOfSoundSolids) {
  for (const TopoDS_Shape& shape :
       {BRepPrimAPI_MakeBox(1, 2, 3).Shape(), BRepPrimAPI_MakeCylinder(1, 2).Shape()})
    EXPECT_TRUE(own_contacts(trim_tool(shape), {}, {}).empty());
}

TEST(OwnContacts, SayWhichFacesMeetAndWhere) {
  const TrimTool box = trim_tool(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  const std::vector<Finding> found =
      own_contacts(box, {box, trim_tool(notched_to_the_bottom())}, {});
  ASSERT_EQ(found.size(), 2u);
  for (const Finding& finding : found) {
    EXPECT_EQ(finding.code, FindingCode::InputMeetsItself);
    ASSERT_EQ(finding.faces.size(), 2u);
    EXPECT_EQ(finding.faces.front().tool, 1);
    EXPECT_NE(finding.faces.front().face, finding.faces.back().face);
    ASSERT_TRUE(finding.point);
    EXPECT_NEAR((*finding.point)[0], 2, 1e-9);
    EXPECT_NEAR((*finding.point)[1], 0, 1e-9);
    EXPECT_NEAR(finding.size, 2, 1e-9);
  }
}

// Operations leave such solids as they are.
TEST(OwnContacts, OfWhatIsFarFromAllOthersAreNotLookedFor) {
  const TrimTool notched = trim_tool(notched_to_the_bottom());
  const TrimTool far = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(5, 0, 0), gp_Pnt(6, 1, 1)).Shape());
  EXPECT_TRUE(own_contacts(notched, {far}, {}).empty());
  TrimTool sheet;
  sheet.faces.push_back(BRepBuilderAPI_MakeFace(gp_Pln({1, 0, 0}, {1, 0, 0}), -1, 1, -1, 1).Face());
  EXPECT_EQ(own_contacts(notched, {far, sheet}, {}).size(), 2u);
}

TEST(OwnContacts, ExplainRefusals) {
  const TrimTool part = trim_tool(with_a_void_that_sticks_out());
  const TrimTool tool = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(3.5, 2, 2), gp_Pnt(9, 9, 9)).Shape());
  const SolidTrimResult made = trim_solids(part, {tool}, SolidOperation::Cut);
  ASSERT_FALSE(made.obstacles.empty());
  ASSERT_FALSE(made.findings.empty());
  for (const Finding& finding : made.findings)
    for (const InputFace& face : finding.faces) EXPECT_EQ(face.tool, -1);
  const TrimTool other = trim_tool(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  EXPECT_TRUE(trim_solids(other, {tool}, SolidOperation::Fuse).findings.empty());
}

// A star of crossed outlines meets itself in every one of its faces.
TopoDS_Shape star_prism() {
  BRepBuilderAPI_MakePolygon outline;
  constexpr int kTips = 11;
  for (int i = 0; i < kTips; ++i) {
    const double angle = 5 * i * 2 * std::numbers::pi / kTips;
    outline.Add(gp_Pnt(10 * std::cos(angle), 10 * std::sin(angle), 0));
  }
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire(), true).Face(),
                               gp_Vec(0, 0, 2))
      .Shape();
}

// One question of many, in the middle, that takes as long as a slow machine would for all of them.
TEST(OwnContacts, AreTheSameHoweverSlowTheMachineIs) {
  const TrimTool part = trim_tool(star_prism());
  const TrimTool tool = trim_tool(BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, -1), gp_Pnt(1, 1, 9)).Shape());
  int asked = 0, slow = 0;
  IntersectionOptions options{.threads = 1};
  options.cancelled = [&] {
    if (++asked == slow) std::this_thread::sleep_for(std::chrono::seconds(2));
    return false;
  };
  const auto found = [&] {
    asked = 0;
    return trim_solids(part, {tool}, SolidOperation::Cut, options).findings;
  };
  const std::size_t quick = found().size();
  ASSERT_GT(quick, 0u);
  slow = asked / 2;
  EXPECT_EQ(found().size(), quick);
}

}  // namespace
}  // namespace blossom::occt
