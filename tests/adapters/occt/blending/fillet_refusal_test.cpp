// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/fillet_refusal.h"

#include <gtest/gtest.h>

#include <string>

namespace blossom::occt {
namespace {

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
