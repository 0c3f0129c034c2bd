// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/arguments/inputs.h"

#include <gtest/gtest.h>

#include "adapters/occt/base/errors.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "tests/plugin/cli/program.h"
#include "tests/support/loose_shapes.h"

namespace blossom::cli {
namespace {

using Ranges = std::vector<std::pair<int, int>>;

TEST(InputName, IsAFileWithoutAMark) {
  EXPECT_EQ(parse_input("wing.step").file, "wing.step");
  EXPECT_TRUE(parse_input("wing.step").faces.empty());
}

TEST(InputName, HasFaceNumbersAndRangesAfterTheMark) {
  const InputName name = parse_input("a folder/wing.step#3,5-9");
  EXPECT_EQ(name.file, "a folder/wing.step");
  EXPECT_EQ(name.faces, (Ranges{{3, 3}, {5, 9}}));
}

TEST(InputName, HasNamesBesideNumbers) {
  const InputName name = parse_input("rig.step#3,608-ZZ/Face2,solid:2");
  EXPECT_EQ(name.faces, (Ranges{{3, 3}}));
  EXPECT_EQ(name.words, (std::vector<std::string>{"608-ZZ/Face2", "solid:2"}));
  EXPECT_FALSE(name.is_whole());
}

TEST(InputName, SplitsAtTheLastMark) {
  EXPECT_EQ(parse_input("part#2.step#1").file, "part#2.step");
}

TEST(InputName, EndsAtTheMarkBehindAFileThatIsThere) {
  const testing::TestFolder folder;
  testing::write({testing::bowl()}, folder / "odd#1.brep");
  const InputName name = parse_input((folder / "odd#1.brep#Bolts, M8/Nut#8").string());
  EXPECT_EQ(name.file, folder / "odd#1.brep");
  EXPECT_EQ(name.list, "Bolts, M8/Nut#8");
}

TEST(InputName, OfAFileThatIsCalledSoIsThatFile) {
  const testing::TestFolder folder;
  testing::write({testing::bowl()}, folder / "plain.brep");
  std::filesystem::rename(folder / "plain.brep", folder / "odd.brep#1");
  EXPECT_TRUE(parse_input((folder / "odd.brep#1").string()).faces.empty());
}

class BadInputName : public ::testing::TestWithParam<const char*> {};

TEST_P(BadInputName, IsRefusedWithItsOwnWords) {
  try {
    parse_input(std::string("a.step#") + GetParam());
    FAIL() << "accepted";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("a.step#"), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Faces, BadInputName,
                         ::testing::Values("", "0", "-1", "1,", ",1", "1-", "9-5", "1.5", "1 2",
                                           "99999999999"));

TEST(Input, HasTheChosenFacesOnceAndInOrder) {
  const testing::TestFolder folder;
  const auto file = folder / "lids.brep";
  testing::write({testing::lid(1), testing::lid(2), testing::lid(3)}, file);
  EXPECT_EQ(read_input(file.string()).numbers, (std::vector{1, 2, 3}));
  const Input some = read_input(file.string() + "#3,1,2-3");
  EXPECT_EQ(some.numbers, (std::vector{1, 2, 3}));
  EXPECT_TRUE(some.faces[2].IsSame(some.model.face(3)));
  EXPECT_EQ(read_input(file.string() + "#2").numbers, (std::vector{2}));
}

TEST(Input, NamesTheFaceThatIsNotThere) {
  const testing::TestFolder folder;
  const auto file = folder / "lids.brep";
  testing::write({testing::lid(1), testing::lid(2)}, file);
  try {
    read_input(file.string() + "#1-2000000000");
    FAIL() << "accepted";
  } catch (const occt::BadModel& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("lids.brep"), std::string::npos) << text;
    EXPECT_NE(text.find("2000000000"), std::string::npos) << text;
  }
}

// Faces 1 to 3 are a cylinder with a loose image, 4 the square.
std::filesystem::path write_loose(const std::filesystem::path& file) {
  occt::Model model;
  model.add(testing::cylinder_with_loose_image(0.01), "loose");
  model.add(testing::lid(3), "lid");
  occt::write_model(model, file);
  return file;
}

TEST(Input, SharesItsModelWithOthersOfTheSameFile) {
  const testing::TestFolder folder;
  const std::string file = write_loose(folder / "part.brep");
  std::filesystem::create_symlink("part.brep", folder / "link.brep");
  const Input a = read_input(file + "#1"), b = read_input((folder / "link.brep").string() + "#2");
  EXPECT_EQ(&a.model, &b.model);
  EXPECT_TRUE(b.faces.front().IsSame(a.model.face(2)));
}

TEST(Input, IsReadAnewOnceNoneOfItsFileIsLeft) {
  const testing::TestFolder folder;
  const auto file = folder / "lids.brep";
  testing::write({testing::lid(1)}, file);
  EXPECT_EQ(read_input(file.string()).faces.size(), 1U);
  testing::write({testing::lid(1), testing::lid(2)}, file);
  EXPECT_EQ(read_input(file.string()).faces.size(), 2U);
}

TEST(Input, IsRepairedWhereItIsUsed) {
  const testing::TestFolder folder;
  const std::string file = write_loose(folder / "part.brep");
  EXPECT_TRUE(read_input(file, Faces::Required, reports::Repairing::None).repairs.empty());
  EXPECT_TRUE(read_input(file + "#4").repairs.empty());
  EXPECT_EQ(read_input(file + "#1").repairs.remade.size(), 1U);
  EXPECT_EQ(read_input(file).repairs.remade.size(), 1U);
}

TEST(RepairsOfAnInput, AreToldInOneLine) {
  const testing::TestFolder folder;
  const std::string file = write_loose(folder / "part.brep");
  const std::string output = folder / "copy.brep";
  const std::string line = file + ": 1 parameter curve recomputed (up to 0.01 mm)\n";
  EXPECT_EQ(testing::blossom({"convert", file, "-o", output}).err, "blossom: " + line);
  EXPECT_EQ(testing::blossom({"convert", file, "-o", output, "-q"}).err, "");
  const std::string more = testing::blossom({"convert", file, "-o", output, "-v"}).err;
  EXPECT_NE(more.find(line), std::string::npos) << more;
  EXPECT_NE(more.find("edge 1 on face 1 (0.01)"), std::string::npos) << more;
}

TEST(RepairsOfAnInput, AreInTheReport) {
  const testing::TestFolder folder;
  const std::string file = write_loose(folder / "part.brep");
  const Json report =
      Json::parse(testing::blossom({"intersect", file, file + "#4", "--json", "-"}).out);
  ASSERT_EQ(report["repairs"].size(), 2U);
  EXPECT_EQ(report["repairs"][0]["input"], file);
  EXPECT_EQ(report["repairs"][0]["curves_recomputed"]["count"], 1);
  EXPECT_NEAR(report["repairs"][0]["curves_recomputed"]["largest_gap"].get<double>(), 0.01, 1e-9);
  EXPECT_EQ(report["repairs"][1]["curves_recomputed"]["count"], 0);
}

TEST(RepairsOfAnInput, AreKeptByConvert) {
  const testing::TestFolder folder;
  const std::string file = write_loose(folder / "part.brep");
  const std::string copy = folder / "copy.brep";
  ASSERT_EQ(testing::blossom({"convert", file, "-o", copy}).code, 0);
  EXPECT_TRUE(read_input(copy).repairs.empty());
}

TEST(RepairsOfAnInput, AreNotNeededToTellAboutIt) {
  const testing::TestFolder folder;
  const std::string file = write_loose(folder / "part.brep");
  const testing::Finished run = testing::blossom({"info", file, "--json", "-"});
  EXPECT_EQ(run.err, "");
  EXPECT_NEAR(Json::parse(run.out)["tolerance"]["largest"].get<double>(), 0.011, 1e-9);
}

}  // namespace
}  // namespace blossom::cli
