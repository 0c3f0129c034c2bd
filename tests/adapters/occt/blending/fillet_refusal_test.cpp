// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/fillet_refusal.h"

#include <gtest/gtest.h>

#include <string>

namespace blossom::occt {
namespace {

TEST(FilletRefusalText, TellsPlacesWithoutWhatIsLeftOfRounding) {
  EXPECT_EQ(told_place({6, -1.47e-15, -4.25}), "(6, 0, -4.25)");
  EXPECT_EQ(told_place({1e-9, 0, 2e-9}), "(1e-09, 0, 2e-09)");
}

// The place belongs to the cause.
TEST(FilletRefusalText, TellsWhatOtherRadiiShowedLast) {
  FilletRefusal why;
  why.edge = 3;
  why.cause = "the ball is too large";
  why.point = Vec3{1, 2, 3};
  why.tried = "; larger balls are stopped by edge 4";
  why.largest = 1.5;
  EXPECT_EQ(why.text(),
            "edge 3: the ball is too large, at (1, 2, 3); larger balls are stopped by edge 4; the "
            "largest radius that works is 1.5");
}

TEST(FilletRefusalInOtherNumbers, NamesEdgesAndFacesAsTheyAreCalledThere) {
  const auto edge = [](int number) {
    return number == 12 ? std::string("edge 7") : std::string("an edge of a blend");
  };
  const auto face = [](int number) { return "face " + std::to_string(number + 100); };
  EXPECT_EQ(renumbered("edge 12: the contact on face 3 meets edge 4, at 12", edge, face),
            "edge 7: the contact on face 103 meets an edge of a blend, at 12");
  EXPECT_EQ(renumbered("its edges and face beside 3", edge, face), "its edges and face beside 3");
  EXPECT_EQ(renumbered("", edge, face), "");
  EXPECT_EQ(renumbered("edge 99999999999", edge, face), "edge 99999999999");
}

}  // namespace
}  // namespace blossom::occt
