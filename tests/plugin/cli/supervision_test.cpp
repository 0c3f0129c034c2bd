// SPDX-License-Identifier: LGPL-2.1-or-later
// The parent of a command: crashes, limits and signals of the work become exit codes and words.

#include "plugin/cli/process/supervision.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/base/sanitizers.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/interruption.h"

namespace blossom::cli {
namespace {

struct Ended {
  int code = 0;
  std::string said;
  double seconds = 0;
};

Ended ended(const std::function<int()>& work) {
  ::testing::internal::CaptureStderr();
  const auto start = std::chrono::steady_clock::now();
  Ended end;
  end.code = supervised(work);
  end.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  end.said = ::testing::internal::GetCapturedStderr();
  return end;
}

[[noreturn]] void sleep_for_ever() {
  while (true) pause();
}

// The bound of a test on time: what is promised, and room for a machine with much to do.
constexpr double kSoon = 5;

TEST(Supervision, PassesTheExitCodeOn) {
  const Ended end = ended([] { return 3; });
  EXPECT_EQ(end.code, 3);
  EXPECT_EQ(end.said, "");
}

TEST(Supervision, CrashInReadingIsTheFilesFault) {
  const Ended end = ended([] {
    enter(Phase::Reading, "part.step", "transferring the shapes of part.step");
    return raise(SIGSEGV);
  });
  EXPECT_EQ(end.code, 2);
  EXPECT_EQ(
      end.said,
      "blossom: part.step: cannot be read: Open CASCADE crashes while transferring the shapes "
      "of part.step (an invalid memory access)\n");
}

TEST(Supervision, CrashElsewhereIsAFailure) {
  const Ended end = ended([] {
    enter(Phase::Working, "intersecting");
    return raise(SIGFPE);
  });
  EXPECT_EQ(end.code, 1);
  EXPECT_EQ(
      end.said,
      "blossom: internal error: the program crashed while intersecting (an arithmetic fault); "
      "please report it with the command and its inputs\n");
}

TEST(Supervision, CrashInAnOptionalStepBeginsAgainWithoutIt) {
  const Ended end = ended([] {
    enter(Phase::Optional, "named.step", "reading names of named.step");
    return has_failed("reading names of named.step") ? 0 : raise(SIGSEGV);
  });
  EXPECT_EQ(end.code, 0);
  EXPECT_EQ(end.said, "");
}

TEST(Supervision, WhatWasSaidIsNoNewsWhenTheWorkBeginsAgain) {
  const Ended end = ended([] {
    note("one attribute is lost");
    enter(Phase::Optional, "told.step", "reading names of told.step");
    if (!has_failed("reading names of told.step")) return raise(SIGSEGV);
    note("no names are read");
    return 0;
  });
  EXPECT_EQ(end.code, 0);
  EXPECT_EQ(end.said, "blossom: one attribute is lost\nblossom: no names are read\n");
}

TEST(Supervision, OptionalStepThatNeverEndsIsLeftOut) {
  const Ended end = ended([] {
    enter(Phase::Optional, "loop.step", "checking face 1 of loop.step");
    if (has_failed("checking face 1 of loop.step")) return 0;
    allow_processor_time(0.2);
    while (!interrupted()) {
    }
    return 1;
  });
  EXPECT_EQ(end.code, 0);
  EXPECT_EQ(end.said, "");
}

TEST(Supervision, CrashInAnOptionalStepAgainEnds) {
  const Ended end = ended([] {
    enter(Phase::Optional, "worse.step", "reading names of worse.step");
    return raise(SIGSEGV);
  });
  EXPECT_EQ(end.code, 1);
}

TEST(Supervision, WorkThatDoesNotLookAtTheTimeLimitIsEnded) {
  const Ended end = ended([]() -> int {
    set_time_limit(0.2);
    enter(Phase::Reading, "part.step");
    sleep_for_ever();
  });
  EXPECT_EQ(end.code, 4);
  EXPECT_EQ(end.said,
            "blossom: the time limit of 0.2 s was reached while reading part.step, nothing was "
            "written\n");
  EXPECT_LT(end.seconds, kSoon);
}

TEST(Supervision, PlacingIsFinishedAfterTheTimeLimit) {
  const Ended end = ended([] {
    set_time_limit(0.1);
    enter(Phase::Placing, "rest.step");
    std::this_thread::sleep_for(std::chrono::milliseconds(1300));
    return 4;
  });
  EXPECT_EQ(end.code, 4);
  EXPECT_EQ(end.said, "");
}

TEST(Supervision, WritingThatGoesOnAfterTheTimeLimitIsEnded) {
  const Ended end = ended([]() -> int {
    set_time_limit(0.2);
    enter(Phase::Writing, "rest.step");
    sleep_for_ever();
  });
  EXPECT_EQ(end.code, 4);
  EXPECT_EQ(end.said,
            "blossom: the time limit of 0.2 s was reached while writing rest.step, which is not "
            "done\n");
  EXPECT_LT(end.seconds, kSoon);
}

TEST(Supervision, ReaderThatNeverEndsIsEnded) {
  const Ended end = ended([] {
    enter(Phase::Reading, "loop.brep");
    allow_processor_time(0.2);
    while (!interrupted()) {
    }
    return 0;
  });
  EXPECT_EQ(end.code, 2);
  EXPECT_NE(end.said.find("loop.brep: reading it takes more than"), std::string::npos) << end.said;
  EXPECT_LT(end.seconds, kSoon);
}

TEST(Supervision, TimeLimitOfTheUserGoesBeforeThatOfReading) {
  const Ended end = ended([] {
    set_time_limit(60);
    enter(Phase::Reading, "slow.brep");
    allow_processor_time(0.01);
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    while (std::chrono::steady_clock::now() < until) {
    }
    return 0;
  });
  EXPECT_EQ(end.code, 0) << end.said;
}

TEST(Supervision, SignalsReachTheWorkAndThenEndIt) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t parent = getpid();
    const Ended polite = ended([=] {
      kill(parent, signal);
      while (!interrupted()) usleep(1000);
      return 130;
    });
    EXPECT_EQ(polite.code, 130);
    EXPECT_EQ(polite.said, "");
    const Ended deaf = ended([=]() -> int {
      kill(parent, signal);
      while (true) usleep(1000);
    });
    EXPECT_EQ(deaf.code, 130);
    EXPECT_EQ(deaf.said, "blossom: interrupted, nothing was written\n");
    EXPECT_LT(deaf.seconds, kSoon);
  }
}

TEST(Supervision, WorkThatCrashesWhenItIsToEndDoesNotBeginAgain) {
  const pid_t parent = getpid();
  const Ended end = ended([=] {
    enter(Phase::Optional, "late.step", "reading names of late.step");
    if (has_failed("reading names of late.step")) return 0;
    kill(parent, SIGTERM);
    while (!interrupted()) usleep(1000);
    return raise(SIGSEGV);
  });
  EXPECT_EQ(end.code, 130);
  EXPECT_EQ(end.said, "blossom: interrupted, nothing was written\n");
}

#if !defined(BLOSSOM_ADDRESS_SANITIZER)
TEST(Supervision, AskingForAllMemoryIsAnErrorOfTheWork) {
  const Ended end = ended([] {
    try {
      std::vector<std::vector<char>> taken;
      while (true) taken.emplace_back(std::size_t{1} << 40);
    } catch (const std::bad_alloc&) {
      return 7;
    }
  });
  EXPECT_EQ(end.code, 7);
}
#endif

// As libraries start their threads: nobody can catch what that throws.
template <class Error>
Ended ended_by_uncaught(const Error& error) {
  return ended([&] {
    enter(Phase::Working, "intersecting");
    const auto fail = [&] { throw error; };
    [&]() noexcept { fail(); }();
    return 0;
  });
}

TEST(Supervision, WantOfMemoryThatCannotBeCaughtIsNoCrash) {
  const Ended end = ended_by_uncaught(std::bad_alloc());
  EXPECT_EQ(end.code, 1);
  EXPECT_FALSE(last_ending().crashed);
  EXPECT_TRUE(last_ending().lacked_memory);
  EXPECT_EQ(end.said, "blossom: there is not enough memory for intersecting\n");
}

TEST(Supervision, OtherErrorsThatCannotBeCaughtAreCrashes) {
  const Ended end = ended_by_uncaught(std::runtime_error("no thread"));
  EXPECT_EQ(end.code, 1);
  EXPECT_TRUE(last_ending().crashed);
  EXPECT_FALSE(last_ending().lacked_memory);
  EXPECT_NE(end.said.find("(a failed internal check)"), std::string::npos) << end.said;
}

TEST(Supervision, TellsWhatIsLeftOfTheTimeLimit) {
  const Ended end = ended([] {
    if (seconds_left() != 0) return 1;
    set_time_limit(1000);
    return seconds_left() > 900 && seconds_left() <= 1000 ? 0 : 2;
  });
  EXPECT_EQ(end.code, 0);
}

}  // namespace
}  // namespace blossom::cli
