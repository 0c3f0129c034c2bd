// SPDX-License-Identifier: LGPL-2.1-or-later
// Jobs of a batch that crash, hang, eat memory or ask for the impossible, by a program that does so
// on demand.

#include "plugin/cli/batch/driver.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/file.h>
#include <unistd.h>

#include <fcntl.h>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <set>
#include <string>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "core/base/sanitizers.h"
#include "plugin/cli/batch/libraries.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/process/supervision.h"
#include "tests/plugin/cli/program.h"

namespace blossom::cli {
namespace {

// By the function of this name.
void ask_for_much(const std::string& function) {
  constexpr std::size_t kMuch = std::size_t{1} << 40, kLine = 64;
  void* memory = nullptr;
  if (function == "malloc") memory = std::malloc(kMuch);
  if (function == "aligned_alloc") memory = std::aligned_alloc(kLine, kMuch);
  if (function == "memalign") memory = memalign(kLine, kMuch);
  // Which glibc takes as the next power of 2.
  if (function == "memalign to 48") memory = memalign(48, kMuch);
  if (function == "valloc") memory = valloc(kMuch);
  if (function == "pvalloc") memory = pvalloc(kMuch);
  if (function == "posix_memalign" && posix_memalign(&memory, kLine, kMuch) != 0) memory = nullptr;
  void* volatile const made = memory;
  std::free(made);
}

// Its argument says what it does.
int on_demand(int argc, char** argv) try {
  const std::string wish = argc > 1 ? argv[1] : "";
  enter(Phase::Working, "doing what it is told");
  if (wish == "crash") return raise(SIGSEGV);
  if (wish == "crash once" && !std::filesystem::exists(argv[2])) {
    testing::write_text(argv[2], "tried");
    return raise(SIGABRT);
  }
  if (wish == "kill all") return kill(getppid(), SIGKILL) + pause();
  if (wish == "sleep") std::this_thread::sleep_for(std::chrono::hours(1));
  if (wish == "eat")
    for (std::vector<std::string> all;;) all.emplace_back(1 << 20, 'x');
  if (wish == "go on with less") ask_for_much(argv[2]);
  if (wish == "say") std::cout << argv[2] << std::flush;
  if (wish == "complain") std::cerr << "blossom: no\n";
  return wish == "code" ? std::atoi(argv[2]) : 0;
} catch (const std::bad_alloc&) {
  report_lack_of_memory();
  return kExitFailure;
}

TEST(BatchLibraries, FollowFromTheEndingsOfAJobsWordsAlsoOfPackedFiles) {
  for (const char* word : {"a.step", "a.STP", "a.igs", "a.iges", "a.stp.gz", "a.stpZ", "a.zip",
                           "b.glb", "a.igsz", "a.IGES.gz", "a.step#1-3", "a.Step.GZ#Bolt"})
    EXPECT_EQ(libraries_for({"check", word}), (Libraries{true, false})) << word;
  EXPECT_EQ(libraries_for({"convert", "a.brep", "-o", "b.3mf"}), (Libraries{false, true}));
  EXPECT_EQ(libraries_for({"convert", "a.stp.gz", "-o", "b.3MF"}), (Libraries{true, true}));
  EXPECT_EQ(libraries_for({"check", "a.brep", "b.brep.gz", "b.brepz", "step", "c.stl"}),
            Libraries{});
}

// Counts calls; those of what is missing fail.
struct CountedLoaders {
  std::map<std::string, int> calls;
  std::set<std::string> missing;

  std::function<void()> of(const std::string& name) {
    return [this, name] {
      ++calls[name];
      if (missing.contains(name)) throw occt::Failure(name + " is missing");
    };
  }
  LibraryLoaders all() { return {of("step"), of("documents"), of("3mf")}; }
};

TEST(BatchLibraries, AreLoadedOnceAndOnlyWhenWanted) {
  CountedLoaders counted;
  Libraries loaded;
  load({}, loaded, counted.all());
  EXPECT_TRUE(counted.calls.empty());
  for (int job = 0; job < 3; ++job) load({true, false}, loaded, counted.all());
  EXPECT_EQ(counted.calls, (std::map<std::string, int>{{"step", 1}, {"documents", 1}}));
  for (int job = 0; job < 3; ++job) load({true, true}, loaded, counted.all());
  EXPECT_EQ(counted.calls, (std::map<std::string, int>{{"step", 1}, {"documents", 1}, {"3mf", 1}}));
}

TEST(BatchLibraries, AreLoadedWhateverElseIsMissingAndAsSoonAsTheyAreThere) {
  CountedLoaders counted;
  counted.missing = {"step", "documents"};
  Libraries loaded;
  load({true, true}, loaded, counted.all());
  EXPECT_EQ(counted.calls.size(), 3u);
  EXPECT_EQ(loaded, (Libraries{false, true}));
  counted.missing.clear();
  load({true, true}, loaded, counted.all());
  EXPECT_EQ(counted.calls["3mf"], 1);
  EXPECT_EQ(loaded, (Libraries{true, true}));
}

class BatchDriver : public ::testing::Test {
 protected:
  BatchDriver() { policy.setup.program = on_demand; }

  // The results of jobs with these arguments, named "1", "2", ...
  std::vector<Json> results_of(const std::vector<std::vector<std::string>>& jobs) {
    std::string lines;
    for (std::size_t i = 0; i < jobs.size(); ++i)
      lines += Json{{"id", std::to_string(i + 1)}, {"arguments", jobs[i]}}.dump() + "\n";
    testing::write_text(folder / "jobs.jsonl", lines);
    JobList list = JobList::of_file(folder / "jobs.jsonl", {});
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < list.size(); ++i) open.push_back(i);
    {
      ResultFile file(folder / "results.jsonl", [](const Result&) {});
      EXPECT_TRUE(run_jobs(list, open, policy, file, tally));
    }
    std::vector<Json> results(jobs.size());
    std::istringstream in(testing::text_of(folder / "results.jsonl"));
    for (std::string line; std::getline(in, line);) {
      Json result = Json::parse(line);
      const std::size_t number = std::stoul(result["id"].get<std::string>());
      results.at(number - 1) = std::move(result);
    }
    return results;
  }

  testing::TestFolder folder;
  BatchPolicy policy;
  Tally tally;
};

TEST_F(BatchDriver, GivesEveryJobTheExitCodeAndOutputThatItHasAlone) {
  policy.in_flight = 3;
  const std::vector<Json> results = results_of({{"code", "0"},
                                                {"code", "1"},
                                                {"code", "2"},
                                                {"code", "3"},
                                                {"code", "4"},
                                                {"code", "5"},
                                                {"say", R"({"schema": "x/1", "value": 7})"},
                                                {"say", "no JSON"},
                                                {"complain"}});
  const std::vector<std::string> statuses{"done", "failed", "failed", "done", "stopped",
                                          "done", "done",   "done",   "done"};
  for (std::size_t i = 0; i < results.size(); ++i) EXPECT_EQ(results[i]["status"], statuses[i]);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(results[i]["code"], i);
  EXPECT_EQ(results[6]["report"]["value"], 7);
  EXPECT_EQ(results[7]["output"], "no JSON");
  EXPECT_EQ(results[8]["messages"], Json::array({"blossom: no"}));
  EXPECT_EQ(tally.count(), results.size());
  EXPECT_EQ(tally.count(JobStatus::Failed), 2u);
  EXPECT_EQ(tally.exit_code(), kExitFailure);
}

TEST_F(BatchDriver, BeginsAJobThatCrashedAgain) {
  policy.retries = 2;
  const std::vector<Json> results =
      results_of({{"crash"}, {"crash once", folder / "mark"}, {"code", "1"}, {"kill all"}});
  EXPECT_EQ(results[0]["run"]["attempts"], 3);
  EXPECT_EQ(results[0]["status"], "failed");
  EXPECT_EQ(results[1]["run"]["attempts"], 2);
  EXPECT_EQ(results[1]["status"], "done");
  EXPECT_EQ(results[1]["messages"], Json::array());
  EXPECT_EQ(results[2]["run"]["attempts"], 1);
  EXPECT_EQ(results[3]["run"]["attempts"], 3);
  EXPECT_EQ(results[3]["messages"], Json::array({"blossom: the job was ended by the signal 9"}));
}

TEST_F(BatchDriver, StopsWhatIsBeyondALimitAndDoesTheRest) {
  policy.in_flight = 2;
  policy.setup.seconds = 0.3;
#if !defined(BLOSSOM_ADDRESS_SANITIZER)  // which needs more for itself
  policy.setup.megabytes = 500;
#endif
  const std::vector<Json> results = results_of({{"sleep"}, {"eat"}, {"say", "still here"}});
  EXPECT_EQ(results[0]["status"], "stopped");
  EXPECT_EQ(results[0]["code"], kExitStopped);
  EXPECT_EQ(results[0]["messages"][0],
            "blossom: the time limit of 0.3 s was reached while doing what it is told, nothing was "
            "written");
#if !defined(BLOSSOM_ADDRESS_SANITIZER)
  EXPECT_EQ(results[1]["status"], "stopped");
  EXPECT_LT(results[1]["run"]["memory_mb"], 600);
#endif
  EXPECT_EQ(results[2]["output"], "still here");
}

// Open CASCADE's repairs catch their own want of memory, and what they give is another model.
#if !defined(BLOSSOM_ADDRESS_SANITIZER)  // which needs more for itself
TEST_F(BatchDriver, StopsWhatWantedMoreMemoryAndWentOnWithLess) {
  std::vector<std::vector<std::string>> jobs;
  for (const char* function : {"malloc", "aligned_alloc", "memalign", "memalign to 48", "valloc",
                               "pvalloc", "posix_memalign"})
    jobs.push_back({"go on with less", function});
  const std::size_t all = jobs.size();
  jobs.push_back({"code", "0"});
  for (const Json& without : results_of(jobs)) EXPECT_EQ(without["status"], "done");
  std::filesystem::remove(folder / "results.jsonl");
  policy.setup.megabytes = 500;
  const std::vector<Json> within = results_of(jobs);
  for (std::size_t k = 0; k < all; ++k) {
    ASSERT_EQ(within[k]["status"], "stopped") << jobs[k][1];
    EXPECT_EQ(within[k]["messages"][0],
              "blossom: the job was stopped: it wants more memory than its limit");
  }
  EXPECT_EQ(within[all]["status"], "done");
}
#endif

TEST_F(BatchDriver, AJobDoesNotGetTheFilesOfTheBatch) {
  results_of({{"code", "0"}});
  // The lock is the last batch's, and would be held by a job that had it.
  const int descriptor = open((folder / "results.jsonl").c_str(), O_RDWR | O_CLOEXEC);
  EXPECT_EQ(flock(descriptor, LOCK_EX | LOCK_NB), 0);
  EXPECT_THROW(ResultFile(folder / "results.jsonl", [](const Result&) {}), UsageError);
  close(descriptor);
}

TEST(BatchProgress, TellsRateAndWhatIsLeft) {
  EXPECT_EQ(progress_text(0, 10, 0, 0, 0), "0 of 10 jobs");
  EXPECT_EQ(progress_text(60, 300, 1, 40, 10), "60 of 300 jobs, 1 failed; 4 a second, 60 s left");
  EXPECT_EQ(progress_text(1, 40001, 0, 1, 0.5), "1 of 40001 jobs; 2 a second, 5 h 33 min left");
  EXPECT_EQ(progress_text(1, 1201, 0, 1, 0.5), "1 of 1201 jobs; 2 a second, 10 min left");
}

}  // namespace
}  // namespace blossom::cli
