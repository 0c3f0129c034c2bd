// SPDX-License-Identifier: LGPL-2.1-or-later
// Real models have in common with themselves what Open CASCADE's checker finds, too, and nothing
// else: the pairs of faces below are those of BOPAlgo_CheckerSI. It also lists two faces of
// elliptiplane that fold over themselves within the tolerance of their seams.

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <utility>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/shapes.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

ShapeIntersection with_itself(const std::filesystem::path& file) {
  quiet_messages();
  Model model = read_model(file);
  model.repair();
  std::vector<TopoDS_Face> faces;
  for (int i = 1; i <= model.face_count(); ++i) faces.push_back(model.face(i));
  return self_intersect(faces, SelfScope::AllFaces);
}

class SelfIntersectionOfModels : public ::testing::TestWithParam<const char*> {
 protected:
  static std::filesystem::path folder() {
    const char* data = blossom::testing::test_data();
    return data == nullptr ? std::filesystem::path() : std::filesystem::path(data);
  }
};

TEST_P(SelfIntersectionOfModels, IsNothingWhereAModelIsSound) {
  if (folder().empty()) GTEST_SKIP() << blossom::testing::kNoTestData;
  const auto found = with_itself(folder() / GetParam());
  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_TRUE(found.pairs.empty());
}

INSTANTIATE_TEST_SUITE_P(Sound, SelfIntersectionOfModels,
                         ::testing::Values("models/ball.brep", "models/crankarm.brep",
                                           "models/elliptiplane.brep", "models/d150_wing.brep",
                                           "models/s1_mainbody_back.stp",
                                           "reports/crankshaft.stp"));

TEST_F(SelfIntersectionOfModels, IsWhatLooseFacesLieOn) {
  if (folder().empty()) GTEST_SKIP() << blossom::testing::kNoTestData;
  const auto found = with_itself(folder() / "models/nist_ctc_02.stp");
  std::set<std::pair<int, int>> pairs;
  for (const FaceIntersection& pair : found.pairs) pairs.emplace(pair.face_a + 1, pair.face_b + 1);
  const std::set<std::pair<int, int>> expected{{231, 636}, {231, 637}, {232, 636}, {232, 637},
                                               {233, 636}, {233, 637}, {636, 637}};
  EXPECT_EQ(pairs, expected);
}

}  // namespace
}  // namespace blossom::occt
