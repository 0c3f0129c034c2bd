// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom batch JOBS -o RESULTS`: many command lines, each in a process of its own.

#include <sched.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "adapters/occt/kept_models.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/batch/driver.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/cli/version.h"

namespace blossom::cli {
namespace {

constexpr long kMaxInFlight = 4096, kMaxRetries = 100;

struct BatchCommand {
  std::vector<std::string> words;  // a list of jobs, or the command of --each
  std::string each;
  std::string output;
  std::string json;
  std::string folder;
  std::string shard = "1/1";
  bool list = false;
  int in_flight = 0;
  int threads = 0;
  BatchPolicy policy;
};

// That this process may use.
int processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof(set), &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

// What the user gave, made whole.
BatchPolicy policy_of(const BatchCommand& options) {
  BatchPolicy policy = options.policy;
  const int jobs = options.in_flight > 0 ? options.in_flight : processors();
  policy.in_flight = static_cast<std::size_t>(jobs);
  policy.setup.threads = options.threads > 0 ? options.threads : std::max(1, processors() / jobs);
  policy.setup.folder = options.folder;
  if (options.folder.empty() && options.each.empty() && options.words.front() != "-")
    policy.setup.folder = std::filesystem::path(options.words.front()).parent_path();
  std::error_code ignored;
  if (!policy.setup.folder.empty() && !std::filesystem::is_directory(policy.setup.folder, ignored))
    throw UsageError(policy.setup.folder + ": there is no such folder");
  occt::keep_models_in(policy.setup.cache, build_name());  // jobs' processes have it from this one
  return policy;
}

JobList jobs_of(const BatchCommand& options) {
  if (options.words.empty() && options.each.empty())
    throw UsageError("batch needs a list of jobs, or --each PATTERN");
  if (options.output.empty()) throw UsageError("batch needs --output FILE (results)");
  const Shard shard = parse_shard(options.shard);
  if (!options.each.empty()) {
    if (options.words.empty())
      throw UsageError("batch --each needs a command: -- info {} --json -");
    return JobList::of_pattern(options.each, options.words, shard);
  }
  if (options.words.size() > 1)
    throw UsageError("'" + options.words[1] + "' is one too many; batch takes no more than JOBS");
  return JobList::of_file(options.words.front(), shard);
}

void check_outputs(const BatchCommand& options) {
  std::vector<std::string> files;  // that the report may not replace
  std::error_code ignored;
  const std::string list = options.each.empty() ? options.words.front() : "";
  for (const std::string& file : {options.output, list})
    if (std::filesystem::exists(file, ignored)) files.push_back(file);
  CommonOptions common;
  common.json = options.json;
  check_files(common, files);
  if (std::filesystem::equivalent(options.output, list, ignored))
    throw UsageError(options.output + ": is the list of jobs, which the results would spoil");
}

// The jobs of the list without a result; the results of the others go into the tally.
std::vector<std::size_t> open_jobs(JobList& list, const std::vector<Result>& known, Tally& tally,
                                   const std::string& file) {
  std::unordered_map<std::string, const Result*> by_id;

  for (const Result& result : known)
    if (!by_id.emplace(result.id, &result).second)
      throw UsageError(file + ": has two results of the job '" + result.id + "'");
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (by_id.empty()) {
      open.push_back(i);
      continue;
    }
    stop_if_interrupted();
    const Job job = list.at(i);
    const auto found = by_id.find(job.id);
    if (found == by_id.end())
      open.push_back(i);
    else if (found->second->arguments != hash_of(job.arguments))
      throw UsageError(file + ": the result of the job '" + job.id +
                       "' is of other arguments; take another file for -o");
    else
      tally.add(*found->second);
  }
  return open;
}

std::string summary(const Tally& tally, std::size_t before, std::size_t jobs, double seconds) {
  std::string text = counted(jobs, "job") + ": " + std::to_string(tally.count(JobStatus::Done)) +
                     " done, " + std::to_string(tally.count(JobStatus::Stopped)) + " stopped, " +
                     std::to_string(tally.count(JobStatus::Failed)) + " failed";
  if (before > 0) text += "; " + std::to_string(before) + " of them before";
  return text + "; " + seconds_text(seconds) + "\n" + tally.text(verbosity() == Verbosity::Verbose);
}

void print_open(JobList& list, const std::vector<std::size_t>& open) {
  for (const std::size_t number : open) {
    const Job job = list.at(number);
    print(Json{{"id", job.id}, {"arguments", job.arguments}}.dump(-1, ' ', false,
                                                                  Json::error_handler_t::replace) +
          "\n");
  }
}

int run(const BatchCommand& options) {
  const auto start = std::chrono::steady_clock::now();
  enter(Phase::Working, "looking at the jobs");
  JobList list = jobs_of(options);
  const BatchPolicy policy = policy_of(options);
  check_outputs(options);
  std::vector<Result> known;
  ResultFile results(options.output, [&](const Result& result) { known.push_back(result); });
  Tally tally;
  const std::vector<std::size_t> open = open_jobs(list, known, tally, options.output);
  if (options.list) {
    print_open(list, open);
    return kExitComplete;
  }
  const std::size_t before = tally.count();
  enter(Phase::Working, "running the jobs");
  const bool all = run_jobs(list, open, policy, results, tally);
  results.keep(true);
  if (!all) {
    note("interrupted; " + std::to_string(tally.count()) + " of " + counted(list.size(), "job") +
         " have results, and the same command does the others");
    return kExitInterrupted;
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Json report{{"schema", "blossom.batch/1"}};
  report.update(tally.json());
  report["seconds"] = rounded(seconds);
  if (!options.json.empty()) write_json(report, options.json);
  print_summary(summary(tally, before, list.size(), seconds),
                options.output == "-" ? "-" : options.json);
  return tally.exit_code();
}

void add_limits(CLI::App& command, JobSetup& limits) {
  command.add_option("--time-limit", limits.seconds, "stop a job after so many seconds")
      ->check(positive_number())
      ->type_name("S");
  command.add_option("--memory-limit", limits.megabytes, "megabytes of data that a job may have")
      ->check(positive_number())
      ->type_name("MB");
}

void add_saying(CLI::App& command) {
  CLI::Option* const verbose = command.add_flag_callback(
      "-v,--verbose", [] { set_verbosity(Verbosity::Verbose); }, "name all that failed");
  command
      .add_flag_callback(
          "-q,--quiet", [] { set_verbosity(Verbosity::Quiet); }, "say nothing but errors")
      ->excludes(verbose);
}

}  // namespace

void add_batch(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand(
      "batch", "many commands, or one on many files, each in a process of its own");
  const auto options = std::make_shared<BatchCommand>();
  command
      ->add_option("jobs", options->words,
                   "list of jobs (JSON lines, - is stdin); or the command of --each after --")
      ->type_name("JOBS");
  command->add_option("-o,--output", options->output, "results (JSON lines, - is stdout), added to")
      ->type_name("FILE");
  command
      ->add_option("--each", options->each,
                   "a job for each file; {} in the command is its name, "
                   "{.} without the ending, {/.} without the folder, too")
      ->type_name("PATTERN");
  command
      ->add_option("-j,--jobs", options->in_flight, "jobs at a time; 0 is one for each processor")
      ->check(whole_number(0, kMaxInFlight))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--threads", options->threads, "of a job; 0 is its share of the processors")
      ->check(whole_number(0, kMaxInFlight))
      ->type_name("N")
      ->capture_default_str();
  add_limits(*command, options->policy.setup);
  command
      ->add_option("--retries", options->policy.retries,
                   "how often a job that crashed begins again")
      ->check(whole_number(0, kMaxRetries))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--shard", options->shard, "do only a part of the jobs, such as 3/16")
      ->type_name("I/N");
  command->add_option("--folder", options->folder, "where the jobs work; else where the list is")
      ->type_name("DIR");
  command
      ->add_option("--cache", options->policy.setup.cache,
                   "keep models that were read, for other jobs")
      ->type_name("DIR");
  command->add_flag("--list", options->list, "only print the jobs that have no result");
  command->add_option("--json", options->json, "write a report; - is stdout")->type_name("FILE");
  add_saying(*command);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
