// SPDX-License-Identifier: LGPL-2.1-or-later
// Every status of Open CASCADE's check has words of its own.

#include "adapters/occt/base/check_words.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace blossom::occt {
namespace {

TEST(CheckWords, SayNothingOfWhatIsRight) {
  EXPECT_EQ(words_of(BRepCheck_NoError), "");
  EXPECT_EQ(words_of(BRepCheck_NoError, TopAbs_WIRE), "");
}

TEST(CheckWords, AreSentencesThatDiffer) {
  std::set<std::string> known;
  for (int i = BRepCheck_NoError + 1; i <= BRepCheck_CheckFail; ++i) {
    const std::string said = words_of(static_cast<BRepCheck_Status>(i));
    EXPECT_NE(said.find(' '), std::string::npos) << said;
    EXPECT_EQ(said.find("BRepCheck"), std::string::npos) << said;
    known.insert(said);
  }
  EXPECT_EQ(known.size(), static_cast<std::size_t>(BRepCheck_CheckFail));
}

TEST(CheckWords, NameThePartOfTheFace) {
  EXPECT_EQ(words_of(BRepCheck_SelfIntersectingWire, TopAbs_WIRE), "a wire meets itself");
  EXPECT_EQ(words_of(BRepCheck_No3DCurve, TopAbs_EDGE), "an edge has no curve in space");
  EXPECT_EQ(words_of(BRepCheck_InvalidPointOnSurface, TopAbs_VERTEX),
            "a vertex lies off the surface");
  EXPECT_EQ(words_of(BRepCheck_IntersectingWires, TopAbs_FACE), "has wires that meet each other");
}

}  // namespace
}  // namespace blossom::occt
