// SPDX-License-Identifier: LGPL-2.1-or-later
// --reproduce: the inputs of a command that was stopped, without what it does not take.

#include <gtest/gtest.h>

#include <filesystem>
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
  EXPECT_NE(testing::text_of(case_folder / "repeat").find("'/proc/out.step'"), std::string::npos);
}

}  // namespace
}  // namespace blossom
