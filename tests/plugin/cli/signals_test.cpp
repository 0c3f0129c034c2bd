// SPDX-License-Identifier: LGPL-2.1-or-later
// Signals at random moments of every command: no partial file, and what was there stays whole.
//
// BLOSSOM_TRIALS   rounds of every signal and command; 1 if it is not set
// BLOSSOM_SEED     of the moments; printed

#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fcntl.h>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopTools_ListOfShape.hxx>
#include <gp_Ax2.hxx>

#include "adapters/occt/shapes.h"
#include "tests/plugin/cli/program.h"
#include "tests/support/face_holes.h"

extern char** environ;

namespace blossom {
namespace {

using Clock = std::chrono::steady_clock;

unsigned from_environment(const char* name, unsigned otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// A plate with holes, n in each direction.
TopoDS_Shape plate(int n) {
  TopTools_ListOfShape plates, drills;
  plates.Append(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 10.0 * n, 10.0 * n, 8).Shape());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      drills.Append(
          BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(10.0 * i + 5, 10.0 * j + 5, -1), gp::DZ()), 3, 10)
              .Shape());
  BRepAlgoAPI_Cut cut;
  cut.SetArguments(plates);
  cut.SetTools(drills);
  cut.Build();
  return cut.Shape();
}

// The program at work, in a process of its own.
class Running {
 public:
  static constexpr int kNotStarted = 127;  // as shells say it

  explicit Running(const std::vector<std::string>& arguments) {
    std::vector<char*> words{const_cast<char*>(BLOSSOM_PROGRAM)};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&files, descriptor, "/dev/null", O_WRONLY, 0);
    if (posix_spawn(&process_, BLOSSOM_PROGRAM, &files, nullptr, words.data(), environ) != 0)
      process_ = -1;
    posix_spawn_file_actions_destroy(&files);
  }

  // Of no process, -1 would be all that there are.
  void send(int signal) const {
    if (process_ > 0) ::kill(process_, signal);
  }

  // Waits for the end. returns  the exit code; 128 + signal if a signal ended it
  int finish() const {
    int status = 0;
    if (process_ <= 0) return kNotStarted;
    ::waitpid(process_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  pid_t process_ = -1;
};

class SignalsAtRandomMoments : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(SignalsAtRandomMoments, LeaveWholeFilesAlone) {
  const testing::TestFolder folder;
  occt::Model part, tool;
  part.add(plate(5), "plate");
  tool.add(BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(25, 25, 4), gp_Dir(0.1, 0, 1)), 15, 4).Shape(),
           "ring");
  occt::write_model(part, folder / "part.step");
  occt::write_model(tool, folder / "tool.step");
  testing::write({testing::slantly_holed()}, folder / "holed.step");
  std::vector<std::string> arguments = GetParam();
  for (std::string& word : arguments)
    if (word.ends_with(".step") || word.ends_with(".json")) word = folder / word;

  const auto start = Clock::now();
  ASSERT_LT(Running(arguments).finish(), 4);
  const double whole = seconds_since(start);
  const std::string old = "the file that was there before\n";
  const unsigned seed = from_environment("BLOSSOM_SEED", std::random_device{}());
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> moment(0, whole);
  double longest = 0;
  for (unsigned round = 0; round < from_environment("BLOSSOM_TRIALS", 1); ++round)
    for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
      for (const char* name : {"out.step", "report.json"}) testing::write_text(folder / name, old);
      const double at = moment(random);
      const Running running(arguments);
      std::this_thread::sleep_for(std::chrono::duration<double>(at));
      running.send(signal);
      const auto sent = Clock::now();
      const int code = running.finish();
      if (signal != SIGKILL) longest = std::max(longest, seconds_since(sent));
      SCOPED_TRACE("signal " + std::to_string(signal) + " after " + std::to_string(at) +
                   " s, seed " + std::to_string(seed));
      // Before the program has begun, a signal ends it in its own way.
      EXPECT_TRUE(code < 5 || code == 130 || code == 128 + signal) << code;
      usleep(50'000);  // the killed program's child goes with it
      EXPECT_EQ(folder.listing(), (std::vector<std::string>{"holed.step", "out.step", "part.step",
                                                            "report.json", "tool.step"}));
      const std::string model = testing::text_of(folder / "out.step");
      EXPECT_TRUE(model == old || model.ends_with("END-ISO-10303-21;\n"));
      const std::string report = testing::text_of(folder / "report.json");
      EXPECT_TRUE(report == old || report.ends_with("}\n"));
    }
  std::cout << "longest end after SIGINT or SIGTERM: " << longest << " s, command: " << whole
            << " s\n";
}

// Results are lines that are added, of which the last may be half; the next run does the rest.
TEST(SignalsAtRandomMomentsOfABatch, LeaveWholeLinesAndTheRestToTheNextRun) {
  constexpr int kJobs = 20;
  const testing::TestFolder folder;
  occt::Model part;
  part.add(plate(3), "plate");
  occt::write_model(part, folder / "part.step");
  std::string jobs;
  for (int i = 0; i < kJobs; ++i)
    jobs += R"({"id":")" + std::to_string(i) +
            R"(","arguments":["check","part.step","--json","-"]})" + "\n";
  testing::write_text(folder / "jobs.jsonl", jobs);
  const std::vector<std::string> arguments{"batch", folder / "jobs.jsonl", "-o",
                                           folder / "results.jsonl", "-q"};
  const auto start = Clock::now();
  ASSERT_EQ(Running(arguments).finish(), 0);
  const unsigned seed = from_environment("BLOSSOM_SEED", std::random_device{}());
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> moment(0, seconds_since(start));
  for (unsigned round = 0; round < from_environment("BLOSSOM_TRIALS", 1); ++round)
    for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
      std::filesystem::remove(folder / "results.jsonl");
      const double at = moment(random);
      SCOPED_TRACE("signal " + std::to_string(signal) + " after " + std::to_string(at) +
                   " s, seed " + std::to_string(seed));
      const Running running(arguments);
      std::this_thread::sleep_for(std::chrono::duration<double>(at));
      running.send(signal);
      const auto sent = Clock::now();
      const int code = running.finish();
      EXPECT_TRUE(code < 5 || code == 130 || code == 128 + signal) << code;
      if (signal != SIGKILL) {
        EXPECT_LT(seconds_since(sent), 1);
      }
      usleep(50'000);  // a killed program's children go with it
      ASSERT_EQ(Running(arguments).finish(), 0);
      const std::string results = testing::text_of(folder / "results.jsonl");
      EXPECT_EQ(std::ranges::count(results, '\n'), kJobs);
      for (int i = 0; i < kJobs; ++i)
        EXPECT_NE(results.find("\"id\":\"" + std::to_string(i) + '"'), std::string::npos) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(
    OfCommands, SignalsAtRandomMoments,
    ::testing::Values(
        std::vector<std::string>{"info", "part.step", "--json", "report.json"},
        std::vector<std::string>{"check", "part.step", "--json", "report.json"},
        std::vector<std::string>{"convert", "part.step", "-o", "out.step"},
        std::vector<std::string>{"subdivide", "part.step", "-o", "out.step", "--json",
                                 "report.json"},
        std::vector<std::string>{"intersect", "part.step", "tool.step", "-o", "out.step", "--json",
                                 "report.json"},
        std::vector<std::string>{"self-intersect", "part.step", "--faces", "--json", "report.json"},
        std::vector<std::string>{"trim", "part.step", "tool.step", "--keep", "outside", "-o",
                                 "out.step", "--json", "report.json"},
        std::vector<std::string>{"trim", "part.step", "tool.step", "--solid", "cut", "-o",
                                 "out.step", "--json", "report.json"},
        std::vector<std::string>{"trim", "part.step", "--plane", "0,0,4,0,0.1,1", "--solid",
                                 "split", "-o", "out.step", "--json", "report.json"},
        std::vector<std::string>{"blend", "fillet", "part.step", "--edges", "convex", "--radius",
                                 "0.2", "-o", "out.step", "--json", "report.json"},
        std::vector<std::string>{"clash", "part.step", "tool.step", "--json", "report.json"},
        std::vector<std::string>{"query", "ray", "part.step", "--from", "25,25,50", "--direction",
                                 "0,0,-1", "--json", "report.json"},
        std::vector<std::string>{"query", "distance", "part.step", "tool.step", "--json",
                                 "report.json"},
        std::vector<std::string>{"query", "plane", "part.step", "--point", "0,0,4", "--normal",
                                 "0,0,1", "-o", "out.step", "--json", "report.json"},
        std::vector<std::string>{"query", "mass", "part.step", "--json", "report.json"},
        std::vector<std::string>{"blend", "chamfer", "part.step", "--edges", "convex", "--distance",
                                 "0.2", "-o", "out.step", "--json", "report.json"},
        std::vector<std::string>{"blend", "fill", "holed.step", "--edges", "5,6,7,8", "-o",
                                 "out.step", "--json", "report.json"},
        std::vector<std::string>{"blend", "strip", "part.step#1", "part.step#2", "-o", "out.step",
                                 "--json", "report.json"}),
    [](const auto& of) {
      std::string name = of.param[0] + of.param[1];
      std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
      return name + std::to_string(of.index);
    });

}  // namespace
}  // namespace blossom
