// SPDX-License-Identifier: LGPL-2.1-or-later
// Reading in a child process first: what ends the child tells of the file only what it can.

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <new>
#include <string>
#include <string_view>

#include <unistd.h>

#include <gtest/gtest.h>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/reading.h"
#include "tests/adapters/occt/exchange/read_files.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using Deed = std::function<void(std::string_view step)>;

class Rehearsing : public ::testing::Test {
 protected:
  Rehearsing() : file_(folder_ / "part.step") {
    testing::write_content(file_, testing::sample(".step"));
  }

  /// With which options a sound file is read if the child does something at each step.
  ReadOptions with(const Deed& deed) const {
    return rehearsed(file_, {.damaged = true, .step = [&deed](const char* step) { deed(step); }});
  }

  testing::Folder folder_;
  std::filesystem::path file_;
};

TEST_F(Rehearsing, LeavesOutTheNamesIfTheseCrash) {
  const ReadOptions options = with([](std::string_view step) {
    if (step.starts_with(kReadingNames)) std::abort();
  });
  EXPECT_FALSE(options.names);
  EXPECT_TRUE(options.damaged);
}

TEST_F(Rehearsing, RefusesWhatCrashes) {
  try {
    with([](std::string_view) { std::abort(); });
    ADD_FAILURE() << "accepted";
  } catch (const BadModel& error) {
    EXPECT_NE(std::string(error.what()).find("Open CASCADE crashes while"), std::string::npos);
  }
}

TEST_F(Rehearsing, GoesOnWhenATerminalInterruptsTheProgram) {
  const ReadOptions options = with([](std::string_view) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) std::raise(signal);
  });
  EXPECT_TRUE(options.names);
  EXPECT_TRUE(options.damaged);
}

TEST_F(Rehearsing, EndsByWhatInterruptsTheProgram) {
  struct Interrupted {};
  EXPECT_THROW(
      rehearsed(file_, {.step = [](const char*) { std::abort(); }}, [] { throw Interrupted(); }),
      Interrupted);
}

TEST_F(Rehearsing, TellsWantOfMemory) {
  EXPECT_THROW(with([](std::string_view) { throw std::bad_alloc(); }), std::bad_alloc);
  EXPECT_THROW(with([](std::string_view) { std::raise(SIGKILL); }), std::bad_alloc);
}

/// As one does that waits for a lock whose owner is a thread of the program.
TEST_F(Rehearsing, DoesNotWaitForAChildThatIsStuck) {
  const ReadOptions options = with([](std::string_view) { pause(); });
  EXPECT_TRUE(options.names);
  EXPECT_TRUE(options.damaged);
}

}  // namespace
}  // namespace blossom::occt
