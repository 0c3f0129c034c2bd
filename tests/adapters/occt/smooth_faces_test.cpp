// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of a real model that go on smoothly into each other, while their borders are a tenth of the
// tolerance apart.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "adapters/occt/intersection.h"
#include "adapters/occt/shapes.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

// The surfaces are within tolerance along all of a border, in a strip that no one line stands for.
TEST(SmoothFaces, LeaveNothingOpenAlongTheirBorder) {
  const char* folder = blossom::testing::test_data();
  if (!folder) GTEST_SKIP() << blossom::testing::kNoTestData;
  const Model model = testing::repaired_model(std::string(folder) + "/models/bearing.iges");
  for (const auto& [a, b] : {std::pair{52, 53}, {53, 52}, {75, 76}, {76, 75}}) {
    SCOPED_TRACE(std::to_string(a) + " and " + std::to_string(b));
    const ShapeIntersection found = intersect({model.face(a)}, {model.face(b)});
    EXPECT_EQ(found.status, Status::Tolerance);
    ASSERT_EQ(found.pairs.size(), 1u);
    const auto& places = found.pairs[0].found.places;
    EXPECT_FALSE(places.empty());
    EXPECT_TRUE(std::ranges::none_of(
        places, [](const Place& place) { return place.kind == PlaceKind::Open; }));
  }
}

}  // namespace
}  // namespace blossom::occt
