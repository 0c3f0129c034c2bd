// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts and tools of several solids that touch each other, with volumes known by hand.
#include "adapters/occt/solids/independent_sets.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/solids/solid_contacts.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::box;
using testing::kPi;

// A cylinder along x.
TopoDS_Shape rod(double from, double to, double radius) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(from, 0, 0), gp::DX()), radius, to - from).Shape();
}

TopoDS_Shape together(std::initializer_list<TopoDS_Shape> shapes) {
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes) builder.Add(all, shape);
  return all;
}

std::vector<TopoDS_Solid> solids_in(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Solid> solids;
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next())
    solids.push_back(TopoDS::Solid(it.Current()));
  return solids;
}

// By Open CASCADE's integrator.
double volume(const SolidTrimResult& result) {
  double sum = 0;
  for (const TopoDS_Solid& solid : result.solids) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid, properties, 1e-8);
    sum += properties.Mass();
  }
  return sum;
}

struct Expected {
  double part = 0, tool = 0, common = 0;  // volumes
  std::size_t cut = 0, both = 0, fused = 0;
  std::size_t pieces = 0;  // when split by all tools as one
};

void expect(const SolidTrimResult& result, std::size_t solids, double wanted) {
  std::string words;
  for (const std::string& obstacle : result.obstacles) words += obstacle + "; ";
  ASSERT_EQ(words, "");
  EXPECT_EQ(result.solids.size(), solids);
  for (const TopoDS_Solid& solid : result.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
  EXPECT_NEAR(volume(result), wanted, 1e-6 * wanted);
}

void expect_all(const TopoDS_Shape& a, const TopoDS_Shape& b, const Expected& expected) {
  const TrimTool part = trim_tool(a), tool = trim_tool(b);
  const double left = expected.part - expected.common;
  expect(trim_solids(part, {tool}, SolidOperation::Cut), expected.cut, left);
  expect(trim_solids(part, {tool}, SolidOperation::Common), expected.both, expected.common);
  expect(trim_solids(part, {tool}, SolidOperation::Fuse), expected.fused, left + expected.tool);
  expect(trim_solids(part, {tool}, SolidOperation::Split), expected.pieces, expected.part);
}

using Places = std::vector<SolidPlaces>;

TEST(SolidLayers, HoldNoTwoSolidsThatTouch) {
  const std::vector<TopoDS_Solid> row = solids_in(together(
      {box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}), box({2, 0, 0}, {3, 1, 1}),
       box({5, 0, 0}, {6, 1, 1}), BRepPrimAPI_MakeSphere(gp_Pnt(4, 0.5, 0.5), 1).Shape()}));
  const IntersectionOptions options;
  const SharedLimit limit(options);
  SolidContacts contacts(row, 1e-7, limit);
  EXPECT_EQ(contacts.layers({0, 1, 2, 3, 4}), (Places{{0, 2, 3}, {1, 4}}));
  // Two inputs: the boxes 0, 1, 2 touch each other, but only the last is joined to the others.
  EXPECT_EQ(contacts.joined({0, 0, 0, 0, 1}), (Places{{0}, {1}, {2, 3, 4}}));
}

TEST(SolidLayers, MayHoldSolidsWhoseBoxesMeet) {
  const std::vector<TopoDS_Solid> apart = solids_in(together(
      {box({0, 0, 0}, {1, 1, 1}), BRepPrimAPI_MakeSphere(gp_Pnt(1.6, 1.6, 1.6), 1).Shape()}));
  const IntersectionOptions options;
  const SharedLimit limit(options);
  EXPECT_FALSE(SolidContacts(apart, 1e-7, limit).touch(0, 1));
}

TEST(SolidLayers, PartsThatTouchAreCutWhereTheyDo) {
  const TopoDS_Shape part = together({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})});
  expect_all(part, box({0.5, -1, 0.5}, {1.5, 2, 2}), {2, 4.5, 0.5, 2, 2, 1, 4});
  expect_all(part, BRepPrimAPI_MakeSphere(gp_Pnt(1, 0, 0.5), 0.25).Shape(),
             {2, 4 * kPi / 3 / 64, 2 * kPi / 3 / 64, 2, 2, 1, 4});
}

TEST(SolidLayers, ToolsThatTouchCutTogether) {
  const TopoDS_Shape plate = box({-2, -1, -1}, {2, 1, 1});
  const TopoDS_Shape rods = together({rod(-3, 0, 0.5), rod(0, 3, 0.5)});
  expect_all(plate, rods, {16, 6 * kPi / 4, kPi, 1, 2, 1, 2});
}

TEST(SolidLayers, BothMayTouch) {
  const TopoDS_Shape rods = together({rod(-2, 0, 0.5), rod(0, 2, 0.5)});
  const TopoDS_Shape boxes = together({box({-1, -1, -1}, {1, 0, 1}), box({-1, 0, -1}, {1, 1, 1})});
  expect_all(rods, boxes, {kPi, 8, kPi / 2, 2, 4, 1, 4});
}

TEST(SolidLayers, LeaveOutSolidsWithoutFaces) {
  TopoDS_Solid empty;
  BRep_Builder().MakeSolid(empty);
  const TopoDS_Shape part = together({box({0, 0, 0}, {1, 1, 1}), empty, box({3, 0, 0}, {4, 1, 1})});
  const TopoDS_Shape tool = together({box({0.5, -1, -1}, {2, 2, 2}), empty});
  expect_all(part, tool, {2, 13.5, 0.5, 2, 1, 2, 3});
}

TEST(SolidLayers, BecomeOneWithWhatLiesInThem) {
  const TopoDS_Shape row = together({box({0, 0, 0}, {10, 10, 10}), box({10, 0, 0}, {20, 10, 10})});
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(5, 5, 5), 1).Shape();
  expect(trim_solids(trim_tool(row), {trim_tool(ball)}, SolidOperation::Fuse), 2, 2000);
  const TopoDS_Shape around = BRepPrimAPI_MakeSphere(gp_Pnt(5, 5, 5), 30).Shape();
  expect(trim_solids(trim_tool(row), {trim_tool(around)}, SolidOperation::Fuse), 1,
         4 * kPi / 3 * 27000);
}

TEST(SolidLayers, BecomeOneWhereTheToolJoinsThemAlone) {
  const TopoDS_Shape row =
      together({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}), box({2, 0, 0}, {3, 1, 1})});
  const TopoDS_Shape tool = box({1.5, -1, -1}, {5, 0.5, 0.5});
  const double both = 1.5 * 0.5 * 0.5;
  expect(trim_solids(trim_tool(row), {trim_tool(tool)}, SolidOperation::Fuse), 2,
         3 + 3.5 * 1.5 * 1.5 - both);
}

}  // namespace
}  // namespace blossom::occt
