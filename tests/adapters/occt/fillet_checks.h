// SPDX-License-Identifier: LGPL-2.1-or-later
// What tests of fillets and chamfers ask of a result.

#pragma once

#include <string>

#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/edge_tolerance.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/soundness.h"

namespace blossom::testing {

/// What is refused, a line each.
inline std::string told(const occt::FilletResult& made) {
  std::string all;
  for (const occt::FilletRefusal& each : made.refused) all += each.text() + "\n";
  return all;
}

/// One sound solid, and nothing refused. Only models that are not that good have edges of a larger
/// tolerance.
inline void expect_sound(const occt::FilletResult& made, double tolerance = 1e-5) {
  ASSERT_EQ(made.solids.size(), 1U) << told(made);
  EXPECT_TRUE(made.refused.empty()) << told(made);
  EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front().solid).IsValid());
  EXPECT_LE(occt::largest_edge_tolerance(made.solids.front().solid), tolerance);
  for (const occt::FaceSoundness& face : occt::soundness(made.solids.front().solid).faces)
    for (const occt::Problem& problem : face.problems) ADD_FAILURE() << problem.text();
}

}  // namespace blossom::testing
