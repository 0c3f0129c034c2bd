// SPDX-License-Identifier: LGPL-2.1-or-later
// --reproduce: the inputs of a command that was stopped, without what it does not take.

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>

#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using testing::blossom;
using testing::Finished;

class Reproduction : public ::testing::Test {
 protected:
  Reproduction() {
    // The bowl meets one of the lids; with a budget of one pair of cells that is left open.
    testing::write({testing::lid(8), testing::lid(9), testing::bowl(), testing::lid(7)}, a);
    testing::write({testing::lid(-4), testing::lid(0.25), testing::lid(-5)}, b);
  }
  testing::TestFolder folder;
  const std::filesystem::path a = folder / "a's parts.brep", b = folder / "b.brep";
  const std::filesystem::path case_folder = folder / "case";
};

TEST_F(Reproduction, OfAStoppedCommandHasTheFacesThatItTakes) {
  const Finished run = blossom({"intersect", a, b, "--budget", "1", "-q", "--json",
                                folder / "out.json", "--reproduce", case_folder});
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(run.err, "blossom: " + (case_folder / "repeat").string() + " does it again\n");
  for (const char* name : {"input1.brep", "input2.brep"}) {
    const Finished info = blossom({"info", case_folder / name});
    EXPECT_NE(info.out.find(" 1 face,"), std::string::npos) << info.out;
  }
  const std::string program = std::filesystem::path(BLOSSOM_PROGRAM).parent_path();
  const std::string repeat =
      "PATH='" + program + "':$PATH sh '" + (case_folder / "repeat").string() + "' >/dev/null";
  const int status = std::system(repeat.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 4);
}

TEST_F(Reproduction, OfACommandThatIsDoneIsNotWritten) {
  EXPECT_EQ(blossom({"intersect", a, b, "-q", "--reproduce", case_folder}).code, 0);
  EXPECT_FALSE(std::filesystem::exists(case_folder));
}

TEST_F(Reproduction, OfAFailedWriteNeedsTheOutputAndKeepsIt) {
  const Finished run = blossom({"trim", a.string() + "#3", b.string() + "#1", "--keep", "7", "-o",
                                "/proc/out.step", "--reproduce", case_folder});
  EXPECT_EQ(run.code, 1) << run.err;
  const std::string repeat = testing::text_of(case_folder / "repeat");
  EXPECT_NE(repeat.find("'/proc/out.step'"), std::string::npos);
  EXPECT_EQ(repeat.find("--reproduce"), std::string::npos);
}

TEST_F(Reproduction, OfFilesThatAreNoModelsTakesThemAsTheyAre) {
  const std::filesystem::path mesh = folder / "bowl.stl";
  testing::write({testing::bowl()}, folder / "bowl.brep");
  ASSERT_EQ(blossom({"convert", folder / "bowl.brep", "-o", mesh, "-q"}).code, 0);
  const Finished run =
      blossom({"convert", mesh, "-o", "/proc/out.ply", "--reproduce", case_folder});
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_TRUE(run.err.ends_with("/repeat does it again\n")) << run.err;
  EXPECT_EQ(testing::text_of(case_folder / "input1.stl"), testing::text_of(mesh));
}

// A command that cannot go without its output writes it in the folder: what is there under that
// name elsewhere is no input, and stays.
TEST_F(Reproduction, OfACommandThatHasToWriteWritesInItsFolder) {
  const std::filesystem::path mesh = folder / "mesh.stl", bowl = folder / "bowl.brep";
  testing::write({testing::bowl()}, bowl);
  testing::write_text(mesh, "older");
  const Finished run = blossom({"convert", bowl, "-o", mesh, "--deviation", "1e-9", "--time-limit",
                                "0.3", "--log", folder / "log.jsonl", "--reproduce", case_folder});
  ASSERT_EQ(run.code, 4) << run.err;
  EXPECT_EQ(testing::text_of(mesh), "older");
  const std::string repeat = testing::text_of(case_folder / "repeat");
  EXPECT_TRUE(
      repeat.ends_with(" 'convert' 'input1.brep' '-o' 'output1.stl' '--deviation' '1e-9' "
                       "'--time-limit' '0.3'\n"))
      << repeat;
  const std::filesystem::directory_iterator files(case_folder);
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

}  // namespace
}  // namespace blossom
