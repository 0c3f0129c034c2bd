// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/tolerances/contact_scale.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/solid_trim.h"
#include "adapters/occt/soundness.h"
#include "tests/adapters/occt/solids/solid_contacts.h"

namespace blossom::occt {
namespace {

TEST(ContactScale, IsInTheMiddleOfTheWidestRangeWithoutGaps) {
  EXPECT_DOUBLE_EQ(contact_scale({}, 1e-7), 1e-6);
  EXPECT_DOUBLE_EQ(contact_scale({0, 1e-12}, 1e-7), 1e-6);
  EXPECT_DOUBLE_EQ(contact_scale({0, 2e-7, 8e-6}, 1e-7), 1e-6);  // and no wider than that
  EXPECT_DOUBLE_EQ(contact_scale({0, 1e-12, 2e-6}, 1e-7), std::sqrt(1e-7 * 2e-6));
  EXPECT_DOUBLE_EQ(contact_scale({2e-7, 1.5e-6}, 1e-7), std::sqrt(1.1 * 2e-7 * 1.5e-6));
  EXPECT_DOUBLE_EQ(contact_scale({1.5e-7, 5e-4}, 1e-7), 1e-6);
  EXPECT_DOUBLE_EQ(contact_scale({1e-6}, 1e-7), 1.1e-6);  // what covers a gap of ten tolerances
}

TEST(ContactScale, IsTheToleranceWhereGapsAreEverywhere) {
  std::vector<double> gaps;
  for (double gap = 1e-8; gap < 1e-5; gap *= 1.09) gaps.push_back(gap);
  EXPECT_NEAR(contact_scale(gaps, 1e-7), 1e-7, 2e-8);
}

TEST(ContactGaps, AreThoseOfVerticesEdgesAndFaces) {
  const IntersectionOptions options;
  const SharedLimit limit(options);
  const TrimTool part = trim_tool(testing::box({0, 0, 0}, {1, 1, 1}));
  const TrimTool above = trim_tool(testing::box({0.2, 0.2, 1 + 3e-7}, {0.8, 2, 2}));
  const std::vector<double> gaps = contact_gaps(part, above, 1e-5, limit);
  ASSERT_FALSE(gaps.empty());
  EXPECT_NEAR(gaps.front(), 3e-7, 1e-12);
  EXPECT_NEAR(gaps.back(), 3e-7, 1e-12);
  const TrimTool far = trim_tool(testing::box({0.2, 0.2, 1.1}, {0.8, 2, 2}));
  EXPECT_TRUE(contact_gaps(part, far, 1e-5, limit).empty());
}

// Apart or into each other by more than the tolerance, and less than what lies on a face.
TEST(SolidsBetweenTouchingAndApart, AreCombined) {
  for (const double off : {1.4e-7, -1.4e-7, 2.4e-7, -2.4e-7}) {
    SCOPED_TRACE(off);
    const TopoDS_Shape plate = testing::turned(testing::box({-1, -1, 0}, {1, 1, 1}), gp::DZ(), 0.7);
    const TopoDS_Shape block = testing::box({-1.5, -2.5, -1}, {0.5, 0.5, off});
    const gp_Ax2 beside({0, 1.5, off}, gp::DZ());
    const std::array pairs{std::pair{plate, block},
                           std::pair{TopoDS_Shape(BRepPrimAPI_MakeCylinder(4, 0.5).Shape()),
                                     TopoDS_Shape(BRepPrimAPI_MakeCylinder(beside, 4, 2).Shape())}};
    for (const auto& [a, b] : pairs)
      for (const SolidOperation operation : {SolidOperation::Cut, SolidOperation::Fuse}) {
        const SolidTrimResult made = trim_solids(trim_tool(a), {trim_tool(b)}, operation);
        ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
        const TopoDS_Shape all = compound_of(made.solids);
        EXPECT_TRUE(BRepCheck_Analyzer(all).IsValid());
        for (const EdgeSoundness& edge : soundness(all).edges)
          EXPECT_TRUE(edge.problems.empty()) << edge.problems.front().text();
      }
  }
}

// Copies that are moved by a few tolerances: their walls are apart, or count as one.
TEST(SolidsBetweenTouchingAndApart, AreCombinedWithTheirMovedCopies) {
  for (const double off : {2e-7, 6e-7, 1e-6}) {
    gp_Trsf move;
    move.SetTranslation({0.48 * off, 0.6 * off, 0.64 * off});
    for (const TopoDS_Shape& solid : {testing::box({0, 0, 0}, {10, 10, 10}),
                                      TopoDS_Shape(BRepPrimAPI_MakeCylinder(5, 10).Shape())}) {
      SCOPED_TRACE(off);
      const TopoDS_Shape copy = BRepBuilderAPI_Transform(solid, move, true).Shape();
      const SolidTrimResult fused =
          trim_solids(trim_tool(solid), {trim_tool(copy)}, SolidOperation::Fuse);
      ASSERT_TRUE(fused.obstacles.empty()) << fused.obstacles.front();
      ASSERT_EQ(fused.solids.size(), 1u);
      EXPECT_TRUE(BRepCheck_Analyzer(fused.solids.front()).IsValid());
      EXPECT_NEAR(fused.total.result, fused.total.part, 1e-6 * fused.total.part);
      EXPECT_LE(fused.faces.size(), 12u);
    }
  }
}

// A rim and its moved copy cross at an angle of the way over their radius. Two of the curves that
// meet there end where they do by less than the tolerance, divided by that angle.
TEST(SolidsBetweenTouchingAndApart, MeetTheirMovedCopiesAtSmallAngles) {
  constexpr double kRadius = 5, kHeight = 10;
  for (const double off : {1e-4, 1e-3, 1e-2}) {
    SCOPED_TRACE(off);
    gp_Trsf move;
    move.SetTranslation({0.48 * off, 0.6 * off, 0.64 * off});
    const TopoDS_Shape solid = BRepPrimAPI_MakeCylinder(kRadius, kHeight).Shape();
    const TopoDS_Shape copy = BRepBuilderAPI_Transform(solid, move, true).Shape();
    const double half = 0.5 * std::hypot(0.48 * off, 0.6 * off);
    const double lens = 2 * (kRadius * kRadius * std::acos(half / kRadius) -
                             half * std::sqrt(kRadius * kRadius - half * half));
    const SolidTrimResult common =
        trim_solids(trim_tool(solid), {trim_tool(copy)}, SolidOperation::Common);
    ASSERT_TRUE(common.obstacles.empty()) << common.obstacles.front();
    ASSERT_EQ(common.solids.size(), 1u);
    EXPECT_TRUE(BRepCheck_Analyzer(common.solids.front()).IsValid());
    EXPECT_NEAR(common.total.result, lens * (kHeight - 0.64 * off), 1e-7 * common.total.part);
    EXPECT_EQ(common.faces.size(), 5u);  // a seam divides one of the two sides
  }
}

// A face that is turned by 5e-7 about an edge of its own which lies in the face of the part within
// a tolerance: the curve in which both meet is up to a fifth of a unit beside that edge.
TEST(SolidsBetweenTouchingAndApart, MeetBesideAnEdgeThatLiesInAFace) {
  const TopoDS_Shape part = testing::box({0, 0, 0}, {5000, 2100, 100});
  BRepBuilderAPI_MakePolygon outline;
  for (const gp_Pnt& corner : {gp_Pnt(4700, 2100, 105), gp_Pnt(759, 1550, 105),
                               gp_Pnt(159, 1550, 105), gp_Pnt(159, 2100 + 2.36e-3, 105)})
    outline.Add(corner);
  outline.Close();
  const TopoDS_Shape tool =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()), gp_Vec(0, -1.1e-7, -108));
  const SolidTrimResult cut = trim_solids(trim_tool(part), {trim_tool(tool)}, SolidOperation::Cut);
  ASSERT_TRUE(cut.obstacles.empty()) << cut.obstacles.front();
  ASSERT_EQ(cut.solids.size(), 1u);
  EXPECT_TRUE(BRepCheck_Analyzer(cut.solids.front()).IsValid());
  const double outline_area = 0.5 * 550 * ((4700 - 159) + (759 - 159));
  EXPECT_NEAR(cut.total.result, 100 * (5000.0 * 2100 - outline_area), 10);
  EXPECT_EQ(cut.faces.size(), 10u);
}

}  // namespace
}  // namespace blossom::occt
