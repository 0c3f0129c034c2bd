// SPDX-License-Identifier: LGPL-2.1-or-later
// Fillets of models whose faces miss their common edges.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <utility>

#include <BRepCheck_Analyzer.hxx>

#include "adapters/occt/base/edge_tolerance.h"
#include "adapters/occt/fillet.h"
#include "tests/adapters/occt/fillet_checks.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

using testing::expect_sound;
using testing::told;

std::filesystem::path given_model(const char* name) {
  const char* data = blossom::testing::test_data();
  return std::filesystem::path(data != nullptr ? data : "") / "models" / name;
}

// Smooth faces miss their common edges by up to 0.0095, and contacts go over these at 2 degrees: up
// to 0.27 apart they leave the one face and come to the other.
TEST(FilletOfFacesWithGaps, GoesOverSmoothEdgesWithGapsAtSmallAngles) {
  const std::filesystem::path crank = given_model("crankarm.brep");
  if (!std::filesystem::exists(crank)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(crank);
  for (const auto& [edge, radius] : {std::pair{100, 0.0819109}, std::pair{24, 0.698005}}) {
    const FilletResult made = fillet(model.shape(), {edge}, {.radius = radius});
    EXPECT_TRUE(made.refused.empty()) << told(made);
    for (const FilletedSolid& each : made.solids)
      EXPECT_TRUE(BRepCheck_Analyzer(each.solid).IsValid());
  }
}

// Faces of the model miss their common edges by more than the ball takes off: what its solid gets
// smaller by is known only with what lies between faces and edges.
TEST(FilletOfFacesWithGaps, TakesOffLessThanTheGapsEnclose) {
  const std::filesystem::path propeller = given_model("propeller.brep");
  if (!std::filesystem::exists(propeller)) GTEST_SKIP() << "BLOSSOM_TEST_DATA has no such model";
  const Model model = testing::repaired_model(propeller);
  expect_sound(fillet(model.shape(), {59}, {.radius = 0.00179242}),
               largest_edge_tolerance(model.shape()));
  expect_sound(fillet(model.shape(), {57}, {.radius = 0.00661189}),
               largest_edge_tolerance(model.shape()));
}

}  // namespace
}  // namespace blossom::occt
