// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/inputs.h"

#include <gtest/gtest.h>

#include "adapters/occt/errors.h"
#include "plugin/cli/exit_code.h"
#include "tests/plugin/cli/program.h"

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

TEST(InputName, SplitsAtTheLastMark) {
  EXPECT_EQ(parse_input("part#2.step#1").file, "part#2.step");
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
                         ::testing::Values("", "0", "-1", "x", "1,", ",1", "1-", "9-5", "1.5",
                                           "1 2", "99999999999"));

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

}  // namespace
}  // namespace blossom::cli
