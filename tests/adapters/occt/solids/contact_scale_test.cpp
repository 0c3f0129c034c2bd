// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/contact_scale.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>

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

}  // namespace
}  // namespace blossom::occt
