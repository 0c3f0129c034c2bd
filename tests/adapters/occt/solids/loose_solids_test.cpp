// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids whose edges are off their faces by what their tolerances allow, where such pairs are at
// hand: results cover the ends of their edges, also as other programs read them.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include <BRepCheck_Analyzer.hxx>

#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/exchange/shapes_files.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

struct LoosePair {
  const char* name;
  SolidOperation operation;
  double volume;
};

class LooseSolids : public ::testing::TestWithParam<LoosePair> {};

TEST_P(LooseSolids, GiveResultsThatAreValidInFiles) {
  const char* const data = blossom::testing::test_data();
  if (data == nullptr) GTEST_SKIP() << blossom::testing::kNoTestData;
  const std::filesystem::path pair = std::filesystem::path(data) / "solids" / GetParam().name;
  if (!std::filesystem::exists(pair.string() + ".a.brep")) GTEST_SKIP() << "there is no such pair";
  const Model a = read_model(pair.string() + ".a.brep"), b = read_model(pair.string() + ".b.brep");

  const SolidTrimResult made =
      trim_solids(trim_tool(a.shape()), {trim_tool(b.shape())}, GetParam().operation);

  ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
  ASSERT_EQ(made.solids.size(), 1U);
  const SolidVolumes& volumes = made.volumes.back();
  EXPECT_NEAR(GetParam().operation == SolidOperation::Cut ? volumes.cut : volumes.fuse,
              GetParam().volume, 1e-6 * GetParam().volume);
  const testing::Folder folder;
  Model model;
  model.add(made.solids.front(), "result");
  write_model(model, folder / "result.brep");
  EXPECT_TRUE(BRepCheck_Analyzer(read_model(folder / "result.brep").shape()).IsValid());
}

INSTANTIATE_TEST_SUITE_P(
    Pairs, LooseSolids,
    ::testing::Values(LoosePair{"fuse_43", SolidOperation::Fuse, 59287430.9167662},
                      LoosePair{"tuc_44", SolidOperation::Cut, 247430.91537754}),
    [](const auto& pair) { return std::string(pair.param.name); });

}  // namespace
}  // namespace blossom::occt
