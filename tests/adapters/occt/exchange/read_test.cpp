// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of every format that are no good: the message names the file, the place and the cause; and
// files of which something is whole: that is read, and the rest is listed.

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/read_files.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

namespace fs = std::filesystem;
using testing::faces_of;
using testing::Folder;
using testing::refusal;
using testing::sample;
using testing::wide;

class EveryFormat : public ::testing::TestWithParam<const char*> {
 protected:
  fs::path file() const { return folder_ / (std::string("part") + GetParam()); }
  Folder folder_;
};

TEST_P(EveryFormat, RefusesWhatIsNoFileOrEmptyOrSomethingElse) {
  EXPECT_EQ(refusal(file()), "no such file");
  testing::write_content(file(), "");
  EXPECT_EQ(refusal(file()), "is empty");
  testing::write_content(file(), " \n\n");
  EXPECT_EQ(refusal(file()), "is empty");
  testing::write_content(file(), "This is a letter.\nIt is no model.\n");
  EXPECT_EQ(refusal(file()).substr(0, 5), "is no");
  testing::write_content(file(), std::string(5000, '\0'));
  EXPECT_NE(refusal(file()), "accepted");
  fs::remove(file());
  fs::create_directory(file());
  EXPECT_EQ(refusal(file()), "is a folder");
}

/// Solids of IGES whose faces are cut off may end the process, which the command line survives:
/// ReadingCutFiles.AreReadInPartsOrRefusedInWords in tests/plugin/cli.
class FormatThatCanBeCut : public EveryFormat {};

TEST_P(FormatThatCanBeCut, GivesWhatIsWholeOfFilesThatAreCutOffAnywhere) {
  const std::string text = sample(GetParam());
  testing::write_content(file(), text);
  const int all = faces_of(file());
  EXPECT_EQ(read_model(file()).reading().grade(), ReadingGrade::Whole);
  int read = 0;
  for (std::size_t k = 1; k < 40; ++k) {
    testing::write_content(file(), text.substr(0, text.size() * k / 40));
    try {
      const Model model = read_model(file());
      EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost) << k;
      EXPECT_LE(model.face_count(), all) << k;
      ++read;
    } catch (const BadModel&) {
      EXPECT_LT(k, 39U);
    }
  }
  EXPECT_GT(read, 0);
}

TEST_P(EveryFormat, IsFoundByTheContentWhateverTheEnding) {
  testing::write_content(folder_ / "part.dat", sample(GetParam()));
  EXPECT_EQ(faces_of(folder_ / "part.dat"), 18);
  testing::write_content(folder_ / "part.igs", sample(GetParam()));
  EXPECT_EQ(faces_of(folder_ / "part.igs"), 18);
}

TEST_P(EveryFormat, HasLineEndsOfAnySystem) {
  std::string mac = sample(GetParam()), windows;
  for (const char c : mac) windows += c == '\n' ? "\r\n" : std::string(1, c);
  std::ranges::replace(mac, '\n', '\r');
  testing::write_content(file(), mac);
  EXPECT_EQ(faces_of(file()), 18);
  testing::write_content(file(), windows);
  EXPECT_EQ(faces_of(file()), 18);
}

TEST_P(EveryFormat, MayHaveWideLetters) {
  for (const std::size_t bytes : {2, 4})
    for (const bool least_first : {true, false})
      for (const bool mark : {true, false}) {
        testing::write_content(file(), wide(sample(GetParam()), bytes, least_first, mark));
        EXPECT_EQ(faces_of(file()), 18) << bytes << least_first << mark;
      }
}

TEST_P(EveryFormat, ReadsWithoutNamesWhenTheyAreNotWanted) {
  testing::write_content(file(), sample(GetParam()));
  std::vector<std::string> steps;
  const Model model = read_model(
      file(), {.names = false, .step = [&](const char* step) { steps.push_back(step); }});
  EXPECT_EQ(model.face_count(), 18);
  EXPECT_TRUE(model.face_names().front().empty());
  ASSERT_FALSE(steps.empty());
  for (const std::string& step : steps) {
    EXPECT_TRUE(step.ends_with(" of " + file().string())) << step;
    EXPECT_EQ(step.find("names"), std::string::npos) << step;
  }
}

// Who is told of the steps may end the reading at any of them: that is no fault of the file.
TEST_P(EveryFormat, EndsWithWhatIsThrownAtAStep) {
  struct Ended : std::exception {};
  testing::write_content(file(), sample(GetParam()));
  int begun = 0;
  for (int ending = 0; begun >= ending; ++ending) {
    begun = 0;
    const auto step = [&](const char*) {
      if (++begun > ending) throw Ended();
    };
    bool ended = false;
    try {
      read_model(file(), {.step = step});
    } catch (const Ended&) {
      ended = true;
    } catch (const BadModel& error) {
      ADD_FAILURE() << error.what();
    }
    EXPECT_EQ(ended, begun > ending) << "at step " << ending;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryFormat, ::testing::Values(".step", ".iges", ".brep"));
INSTANTIATE_TEST_SUITE_P(All, FormatThatCanBeCut, ::testing::Values(".step", ".brep"));

TEST(Reading, RefusesWhatIsOfNoFormatAndHasAnUnknownEnding) {
  const Folder folder;
  EXPECT_EQ(refusal(folder / "part.obj"), "no such file");
  testing::write_content(folder / "part.obj", "v 0 0 0\n");
  EXPECT_EQ(refusal(folder / "part.obj"),
            "is no STEP, IGES or BREP file by its content, and the ending '.obj' is not known");
}

TEST(Reading, RefusesPipesAndDevicesWithoutWaiting) {
  const Folder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.step").c_str(), 0600), 0);
  EXPECT_EQ(refusal(folder / "pipe.step"), "is no regular file");
  EXPECT_EQ(refusal("/dev/zero"), "is no regular file");
}

TEST(Reading, RefusesFilesThatAreLargerThanTheMemory) {
  const Folder folder;
  testing::write_content(folder / "huge.step", "ISO-10303-21;");
  fs::resize_file(folder / "huge.step", std::uintmax_t{1} << 42U);  // a hole takes no room
  EXPECT_EQ(refusal(folder / "huge.step"), "is larger than the memory of this machine");
}

TEST(FaceNumbers, AreOneToTheCountAndRefusedByName) {
  const Folder folder;
  testing::write_machine(folder / "machine.step");
  const Model model = read_model(folder / "machine.step");
  EXPECT_FALSE(model.face(18).IsNull());
  for (const int number : {0, 19, -1}) try {
      model.face(number);
      FAIL();
    } catch (const BadModel& error) {
      EXPECT_EQ(error.what(), (folder / "machine.step").string() + ": there is no face " +
                                  std::to_string(number) + ", faces are 1 to 18");
    }
}

}  // namespace
}  // namespace blossom::occt
