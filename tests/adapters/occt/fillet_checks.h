// SPDX-License-Identifier: LGPL-2.1-or-later
// What tests of fillets and chamfers ask of a result.

#pragma once

#include <string>

#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>

#include "adapters/occt/fillet.h"
#include "adapters/occt/soundness.h"

namespace blossom::testing {

/// What is refused, a line each.
inline std::string told(const occt::FilletResult& made) {
  std::string all;
  for (const occt::FilletRefusal& each : made.refused) all += each.text() + "\n";
  return all;
}

/// One sound solid, and nothing refused.
inline void expect_sound(const occt::FilletResult& made) {
  ASSERT_EQ(made.solids.size(), 1U) << told(made);
  EXPECT_TRUE(made.refused.empty()) << told(made);
  EXPECT_TRUE(BRepCheck_Analyzer(made.solids.front().solid).IsValid());
  for (const occt::FaceSoundness& face : occt::soundness(made.solids.front().solid).faces)
    for (const occt::Problem& problem : face.problems) ADD_FAILURE() << problem.text();
}

}  // namespace blossom::testing
