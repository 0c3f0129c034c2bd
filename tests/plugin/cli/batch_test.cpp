// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom batch`: every job has one result, whatever interrupts the batch.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/sanitizers.h"
#include "tests/plugin/cli/program.h"

namespace blossom {
namespace {

using testing::blossom;
using testing::Finished;

// The lines of a file of results by the ids; each may be there once.
std::map<std::string, nlohmann::json> results_in(const std::filesystem::path& file) {
  std::map<std::string, nlohmann::json> results;
  std::istringstream in(testing::text_of(file));
  for (std::string line; std::getline(in, line);) {
    const nlohmann::json result = nlohmann::json::parse(line);
    EXPECT_TRUE(results.emplace(result["id"], result).second) << result["id"] << " is there twice";
  }
  return results;
}

// Without what differs from run to run.
nlohmann::json lasting(nlohmann::json result) {
  result.erase("run");
  if (result.contains("report"))
    for (const char* name : {"seconds", "seconds_first"}) result["report"].erase(name);
  return result;
}

class Batch : public ::testing::Test {
 protected:
  Batch() {
    testing::write({testing::bowl()}, folder / "bowl.brep");
    testing::write({testing::lid(0.25)}, folder / "lid.brep");
    std::filesystem::create_directory(folder / "elsewhere");
  }

  // Bowls cut at `count` heights, and a model that is not there.
  void write_jobs(int count) {
    std::string lines;
    for (int i = 1; i <= count; ++i) {
      const std::string lid = i == 2 ? "nowhere.brep" : "lid.brep";
      const nlohmann::json job = {{"id", "cut " + std::to_string(i)},
                                  {"arguments", {"intersect", "bowl.brep", lid, "--json", "-"}}};
      lines += job.dump() + "\n";
    }
    testing::write_text(jobs, lines);
  }

  testing::TestFolder folder;
  const std::filesystem::path jobs = folder / "jobs.jsonl", results = folder / "results.jsonl";
};

TEST_F(Batch, AnswersEveryJobAsTheCommandItselfDoes) {
  write_jobs(3);
  const Finished run = blossom({"batch", jobs, "-o", results, "-j", "2"});
  EXPECT_EQ(run.code, 1);  // one has failed
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(run.out.starts_with("3 jobs: 2 done, 0 stopped, 1 failed; ")) << run.out;
  EXPECT_NE(run.out.find("\n    cut 2: nowhere.brep: no such file\n"), std::string::npos)
      << run.out;

  std::map<std::string, nlohmann::json> found = results_in(results);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found["cut 2"]["code"], 2);
  const std::string there = "cd '" + (folder / "").string() + "' && ";
  const Finished alone = blossom({"intersect", "bowl.brep", "lid.brep", "--json", "-"}, there);
  EXPECT_EQ(found["cut 1"]["code"], alone.code);
  EXPECT_TRUE(lasting(found["cut 1"])["report"] ==
              lasting({{"report", nlohmann::json::parse(alone.out)}})["report"]);
}

TEST_F(Batch, DoesWhatHasNoResultYetAndRepairsHalfALine) {
  write_jobs(2);
  blossom({"batch", jobs, "-o", results, "-q"});
  const std::string first = testing::text_of(results);
  write_jobs(5);
  testing::write_text(results, first + R"({"id":"cut 3","status":"do)");
  const Finished run = blossom({"batch", jobs, "-o", results});
  EXPECT_NE(run.out.find("5 jobs: 4 done, 0 stopped, 1 failed; 2 of them before; "),
            std::string::npos)
      << run.out;
  EXPECT_TRUE(testing::text_of(results).starts_with(first));
  EXPECT_EQ(results_in(results).size(), 5u);
  const std::string all = testing::text_of(results);
  EXPECT_EQ(blossom({"batch", jobs, "-o", results, "-q"}).code, 1);
  EXPECT_EQ(testing::text_of(results), all);
}

TEST_F(Batch, GoesOnAfterItWasKilledWithTheSameResults) {
  write_jobs(60);
  blossom({"batch", jobs, "-o", folder / "undisturbed.jsonl", "-q"});
  int broken_off = 0;
  for (const char* before :
       {"timeout -s KILL 0.25", "timeout -s INT 0.3", "timeout -s KILL 0.35"}) {
    const int code = blossom({"batch", jobs, "-o", results, "-q"}, before).code;
    broken_off += code != 1 ? 1 : 0;
  }
  EXPECT_EQ(blossom({"batch", jobs, "-o", results, "-q"}).code, 1);
  const std::map<std::string, nlohmann::json> expected = results_in(folder / "undisturbed.jsonl");
  const std::map<std::string, nlohmann::json> found = results_in(results);
  ASSERT_EQ(found.size(), 60u);
  for (const auto& [id, result] : expected)
    EXPECT_TRUE(lasting(found.at(id)) == lasting(result)) << id;
  std::cout << "broken off " << broken_off << " times\n";
}

TEST_F(Batch, JobsThatAreStoppedLeaveWhatRepeatsThem) {
  const auto command = [&](const std::string& part) {
    return std::vector<std::string>{"intersect", part,          folder / "lid.brep",  "--budget",
                                    "1",         "--reproduce", folder / "again {/.}"};
  };
  std::vector<std::string> words{"batch", "--each", folder / "b*.brep", "-o", results, "--"};
  for (const std::string& word : command("{}")) words.push_back(word);
  const Finished run = blossom(words);
  ASSERT_EQ(run.code, 4);
  EXPECT_EQ(run.err, "");
  EXPECT_NE(
      results_in(results).begin()->second["messages"].dump().find("again bowl/repeat does it"),
      std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "again bowl/repeat"));
  EXPECT_FALSE(std::filesystem::exists(folder / "again {"));
}

// Without a batch there are no limits from outside.
#if !defined(BLOSSOM_ADDRESS_SANITIZER)  // which needs more memory than the limit for itself
TEST_F(Batch, WhatRepeatsAJobThatALimitStoppedHasTheLimit) {
  const Finished run =
      blossom({"batch", "--each", folder / "bowl.brep", "-o", results, "--time-limit", "0.3",
               "--memory-limit", "1024", "--", "convert", "{}", "-o", folder / "bowl.stl",
               "--deviation", "1e-9", "--reproduce", folder / "again"});
  EXPECT_EQ(run.code, 4) << run.err;
  const std::string repeat = testing::text_of(folder / "again/repeat");
  EXPECT_NE(repeat.find(" && ulimit -d 1000000 && exec blossom 'convert' "), std::string::npos)
      << repeat;
  EXPECT_TRUE(repeat.ends_with(" '--time-limit' '0.3'\n")) << repeat;
}
#endif

TEST_F(Batch, TellsWhyJobsAreStopped) {
  const Finished run =
      blossom({"batch", "--each", folder / "bowl.brep", "-o", results, "--", "intersect", "{}",
               folder / "lid.brep", "--budget", "1", "--json", "-"});
  ASSERT_EQ(run.code, 4);
  const std::string reason =
      results_in(results).begin()->second["report"]["certificate"]["reasons"][0];
  EXPECT_NE(run.out.find("bowl.brep: " + reason + "\n"), std::string::npos) << run.out;
}

TEST_F(Batch, TellsHowManyAreDoneButNotComplete) {
  testing::write({testing::bowl(), testing::lid(0.25)}, folder / "bowl.brep");
  const std::string whole = testing::text_of(folder / "bowl.brep");
  testing::write_text(folder / "bowl.brep", whole.substr(0, whole.rfind('*')));
  const Finished run =
      blossom({"batch", "--each", folder / "bowl.brep", "-o", results, "--", "check", "{}"});
  EXPECT_EQ(run.code, 3);
  EXPECT_NE(run.out.find("(exit code 3): 1 job\n"), std::string::npos) << run.out;
}

TEST_F(Batch, ShardsShareTheJobs) {
  write_jobs(7);
  std::size_t count = 0;
  for (const std::string shard : {"1/3", "2/3", "3/3"}) {
    const std::filesystem::path file = folder / ("results-" + shard.substr(0, 1) + ".jsonl");
    blossom({"batch", jobs, "-o", file, "-q", "--shard", shard});
    const std::map<std::string, nlohmann::json> found = results_in(file);
    count += found.size();
    EXPECT_TRUE(found.contains("cut " + shard.substr(0, 1)));
  }
  EXPECT_EQ(count, 7u);
}

TEST_F(Batch, ReadsStdinAndWritesStdout) {
  write_jobs(1);
  const std::string piped = "cd '" + (folder / "").string() + "' && sh -c '\"$@\" <jobs.jsonl' sh";
  const Finished run = blossom({"batch", "-", "-o", "-"}, piped);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(nlohmann::json::parse(run.out)["id"], "cut 1");
}

TEST_F(Batch, ListsWhatHasNoResult) {
  write_jobs(1);
  blossom({"batch", jobs, "-o", results, "-q"});
  write_jobs(3);
  const std::string before = testing::text_of(results);
  const Finished run = blossom({"batch", jobs, "-o", results, "--list"});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(nlohmann::json::parse(run.out.substr(0, run.out.find('\n')))["id"], "cut 2");
  EXPECT_EQ(std::ranges::count(run.out, '\n'), 2);
  EXPECT_EQ(testing::text_of(results), before);
}

TEST_F(Batch, EndsWhenNobodyReadsItsResults) {
  write_jobs(2000);
  const std::string piped =
      "cd '" + (folder / "").string() + "' && timeout 60 sh -c '\"$@\" | head -n 1' sh";
  const Finished run = blossom({"batch", "jobs.jsonl", "-o", "-"}, piped);
  EXPECT_EQ(run.code, 0);  // of head; timeout would have ended it with 124
  EXPECT_EQ(std::ranges::count(run.out, '\n'), 1);
}

TEST_F(Batch, NamesOfFilesAreTextAndNothingElse) {
  const std::string evil = "a'b\"; touch spoilt $(touch spoilt) `touch spoilt`\n.brep";
  std::filesystem::copy(folder / "bowl.brep", folder / "elsewhere" / evil);
  const std::vector<std::string> before = folder.listing();
  const Finished run = blossom({"batch", "--each", (folder / "elsewhere/*.brep").string(), "-o",
                                results, "--", "info", "{}", "--json", "-"});
  EXPECT_EQ(run.code, 0) << run.err;
  const std::map<std::string, nlohmann::json> found = results_in(results);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.begin()->second["report"]["file"], (folder / "elsewhere" / evil).string());
  EXPECT_FALSE(std::filesystem::exists(folder / "spoilt"));
  EXPECT_FALSE(std::filesystem::exists("spoilt"));
}

TEST_F(Batch, NamesOfOutputsFollowThoseOfInputs) {
  blossom({"batch", "--each", (folder / "*.brep").string(), "-o", results, "-q", "--", "convert",
           "{}", "-o", (folder / "elsewhere/{/.}.step").string()});
  EXPECT_TRUE(std::filesystem::exists(folder / "elsewhere/bowl.step"));
  EXPECT_TRUE(std::filesystem::exists(folder / "elsewhere/lid.step"));
  blossom({"batch", "--each", (folder / "*.brep").string(), "-o", folder / "second.jsonl", "-q",
           "--", "convert", "{}", "-o", "{.}.step"});
  EXPECT_TRUE(std::filesystem::exists(folder / "bowl.step"));
}

TEST_F(Batch, AnotherCommandUnderTheSameNameIsRefused) {
  write_jobs(1);
  blossom({"batch", jobs, "-o", results, "-q"});
  testing::write_text(jobs, R"({"id": "cut 1", "arguments": ["info", "bowl.brep"]})");
  const Finished run = blossom({"batch", jobs, "-o", results});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(
      run.err.find("the result of the job 'cut 1' is of other arguments; take another file for -o"),
      std::string::npos);
}

}  // namespace
}  // namespace blossom
