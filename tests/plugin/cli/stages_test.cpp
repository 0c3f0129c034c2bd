// SPDX-License-Identifier: LGPL-2.1-or-later
// --log and --profile: what a command was at, also when it did not come to its end.

#include "plugin/cli/process/stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <sstream>
#include <string>
#include <vector>

#include "plugin/cli/process/supervision.h"
#include "tests/plugin/cli/program.h"

namespace blossom::cli {
namespace {

using testing::blossom;
using testing::Finished;

std::vector<nlohmann::json> reports_in(const std::filesystem::path& file) {
  std::vector<nlohmann::json> lines;
  std::istringstream in(testing::text_of(file));
  for (std::string line; std::getline(in, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

class Stages : public ::testing::Test {
 protected:
  Stages() {
    testing::write({testing::bowl()}, folder / "bowl.brep");
    testing::write({testing::lid(0.25)}, folder / "lid.brep");
  }
  testing::TestFolder folder;
  const std::string log = folder / "log.jsonl";
};

TEST_F(Stages, AreLoggedOneAfterTheOtherAndAddUpToTheWhole) {
  const std::string bowl = folder / "bowl.brep";
  ASSERT_EQ(blossom({"intersect", bowl, folder / "lid.brep", "-q", "--log", log}).code, 0);
  const std::vector<nlohmann::json> lines = reports_in(log);
  bool reads = false, intersects = false;
  double end = 0;
  nlohmann::json pair;
  for (const nlohmann::json& line : lines) {
    if (line.contains("pair")) pair = line;
    if (!line.contains("stage")) continue;
    const std::string stage = line["stage"];
    reads = reads || stage.find(bowl) != std::string::npos;
    intersects = intersects || stage == "intersecting";
    EXPECT_NEAR(line["at"], end, 1e-9);
    end = line["at"].get<double>() + line["seconds"].get<double>();
    EXPECT_GT(line["memory_mb"], 1);
  }
  EXPECT_TRUE(reads && intersects);
  EXPECT_EQ(pair["pair"], nlohmann::json::array({1, 1}));
  EXPECT_EQ(pair["curves"], 1);
  EXPECT_GT(pair["cells"], 0);
  EXPECT_EQ(lines.back()["ended"], "exit code 0");
}

TEST_F(Stages, OfTrianglesAreReadingAndWork) {
  const std::string mesh = folder / "bowl.stl";
  ASSERT_EQ(blossom({"convert", folder / "bowl.brep", "-o", mesh, "-q"}).code, 0);
  ASSERT_EQ(blossom({"info", mesh, "-q", "--log", log}).code, 0);
  std::vector<std::string> stages;
  for (const nlohmann::json& line : reports_in(log))
    if (line.contains("stage")) stages.push_back(line["stage"]);
  EXPECT_EQ(stages,
            (std::vector<std::string>{"starting", "reading " + mesh, "working on " + mesh}));
}

TEST_F(Stages, ALogGoesOnBehindWhatIsThere) {
  for (int i = 0; i < 2; ++i) blossom({"info", folder / "bowl.brep", "-q", "--log", log});
  int ends = 0;
  for (const nlohmann::json& line : reports_in(log)) ends += line.contains("ended") ? 1 : 0;
  EXPECT_EQ(ends, 2);
}

TEST_F(Stages, TheLastIsLoggedWhenItCrashes) {
  ::testing::internal::CaptureStderr();
  supervised([&] {
    log_stages(log);
    enter(Phase::Working, "dividing by nothing");
    return raise(SIGFPE);
  });
  ::testing::internal::GetCapturedStderr();
  const nlohmann::json last = reports_in(log).back();
  EXPECT_EQ(last["stage"], "dividing by nothing");
  EXPECT_EQ(last["ended"], "an arithmetic fault");
}

TEST_F(Stages, AProfileNamesTheSlowestFirstAndCountsKinds) {
  ::testing::internal::CaptureStderr();
  supervised([&] {
    profile_stages();
    for (const char* face : {"1", "2", "3"})
      enter(Phase::Working, "checking face " + std::string(face) + " of a1.step");
    enter(Phase::Working, "sleeping");
    usleep(200'000);
    return 0;
  });
  std::istringstream said(::testing::internal::GetCapturedStderr());
  std::string line;
  std::getline(said, line);
  EXPECT_TRUE(line.starts_with("blossom: 0.2")) << line;
  std::getline(said, line);
  EXPECT_TRUE(line.ends_with("%  sleeping")) << line;
  const std::string rest(std::istreambuf_iterator<char>(said), {});
  EXPECT_NE(rest.find("checking face ... of a1.step, 3 times\n"), std::string::npos) << rest;
}

TEST_F(Stages, AProfileAddsUpWhatItDoesNotName) {
  ::testing::internal::CaptureStderr();
  supervised([&] {
    profile_stages();
    for (const char* what : {"one", "two", "three", "four", "five", "six", "seven", "eight"})
      enter(Phase::Working, what);
    usleep(1000);
    enter(Phase::Working, "nine");
    return 0;
  });
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::ranges::count(said, '\n'), 10) << said;
  EXPECT_TRUE(said.ends_with("%  2 other stages\n")) << said;
}

TEST_F(Stages, NothingIsAddedToAModel) {
  const std::string model = folder / "bowl.brep", before = testing::text_of(model);
  const Finished run = blossom({"info", model, "--log", model});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(run.err.starts_with("blossom: " + model + ": a log's name ends in")) << run.err;
  EXPECT_EQ(testing::text_of(model), before);
}

}  // namespace
}  // namespace blossom::cli
