// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/process/many_files.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/reports/text/csv.h"

namespace blossom::cli {
namespace {

constexpr const char* kProgram = "/proc/self/exe";
constexpr const char* kNotLookedAt = "not looked at: the time limit was reached";

// The options that were given, but for those that are about all files together.
std::vector<std::string> given_options(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || option->get_positional() || name.empty() || name[0] != '-')
      continue;
    if (name == "--json" || name == "--table" || name == "--time-limit" || name == "--quiet")
      continue;
    words.push_back(name);
    if (option->get_expected_min() == 0) continue;  // a flag
    for (const std::string& value : option->results()) words.push_back(value);
  }
  return words;
}

// What a process wrote and how it ended.
struct ChildOutput {
  int code = kExitFailure;
  std::string out, err;
};

struct Pipe {
  std::array<int, 2> ends{-1, -1};

  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw occt::Failure("no pipe can be made");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(std::size_t end) {
    if (ends[end] >= 0) close(ends[end]);
    ends[end] = -1;
  }
};

[[noreturn]] void become(const std::vector<std::string>& words, const Pipe& out, const Pipe& err) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  dup2(out.ends[1], STDOUT_FILENO);
  dup2(err.ends[1], STDERR_FILENO);
  execv(kProgram, arguments.data());
  _exit(kExitFailure);
}

// Adds what is there to be read; false at the end.
bool drain(int descriptor, std::string& text) {
  std::array<char, 1 << 16> buffer{};
  const ssize_t count = read(descriptor, buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

// Reads both ends until they close. An interruption is the other process's, too.
void read_all(pid_t child, Pipe& out, Pipe& err, ChildOutput& ended) {
  bool told = false;
  while (out.ends[0] >= 0 || err.ends[0] >= 0) {
    std::array<pollfd, 2> waiting{pollfd{out.ends[0], POLLIN, 0}, pollfd{err.ends[0], POLLIN, 0}};
    constexpr int kTickMilliseconds = 100;
    poll(waiting.data(), waiting.size(), kTickMilliseconds);
    if (waiting[0].revents != 0 && !drain(out.ends[0], ended.out)) out.close_end(0);
    if (waiting[1].revents != 0 && !drain(err.ends[0], ended.err)) err.close_end(0);
    if (interrupted() && !std::exchange(told, true)) kill(child, SIGTERM);
  }
}

ChildOutput run_child(const std::vector<std::string>& words) {
  Pipe out, err;
  const pid_t child = fork();
  if (child < 0) throw occt::Failure("no process can be made");
  if (child == 0) become(words, out, err);
  out.close_end(1);
  err.close_end(1);
  ChildOutput ended;
  read_all(child, out, err, ended);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : kExitFailure;
  return ended;
}

// The last line that is an error, without the program's name.
std::string error_in(const std::string& text) {
  const std::string mark = "blossom: ";
  std::string found;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    if (line.starts_with(mark)) found = line.substr(mark.size());
    begin = end + 1;
  }
  return found;
}

FileRun run_on(const std::string& file, const ManyFiles& files,
               const std::vector<std::string>& options) {
  FileRun run{file, kExitStopped, kNotLookedAt, {}};
  std::vector<std::string> words{"blossom", files.command->get_name(), file, "--json", "-"};
  if (const double left = seconds_left(); left > 0) {
    constexpr double kMinSeconds = 1e-3;  // less is spent before a process begins
    if (left < kMinSeconds) return run;
    words.insert(words.end(), {"--time-limit", number_text(left)});
  }
  words.insert(words.end(), options.begin(), options.end());
  const ChildOutput ended = run_child(words);
  stop_if_interrupted();
  if (verbosity() != Verbosity::Quiet || ended.out.empty()) std::cerr << ended.err << std::flush;
  run.code = ended.code;
  run.report = Json::parse(ended.out, nullptr, false);
  const bool reported = run.report.is_object();
  if (!reported) run.report = nullptr;
  run.error = reported ? "" : error_in(ended.err);
  if (!reported && run.error.empty()) run.error = "nothing was told";
  return run;
}

// The place of a code among all, worse ones first.
std::ptrdiff_t place_of(int code) {
  constexpr std::array kOrder{kExitFailure,  kExitBadInput,  kExitStopped,
                              kExitFindings, kExitTolerance, kExitComplete};
  const auto* const found = std::ranges::find(kOrder, code);
  return found == kOrder.end() ? 0 : found - kOrder.begin();
}

std::string table_of(const ManyFiles& files, const std::vector<FileRun>& runs) {
  std::vector<std::string> titles{"file"};
  titles.insert(titles.end(), files.titles.begin(), files.titles.end());
  titles.insert(titles.end(), {"exit_code", "error"});
  std::string table = reports::csv_row(titles);
  for (const FileRun& run : runs) {
    std::vector<std::string> row{run.file};
    const std::vector<std::string> fields = run.report.is_null()
                                                ? std::vector<std::string>(files.titles.size())
                                                : files.fields(run.report);
    row.insert(row.end(), fields.begin(), fields.end());
    row.insert(row.end(), {std::to_string(run.code), run.error});
    table += reports::csv_row(row);
  }
  return table;
}

Json json_of(const ManyFiles& files, std::vector<FileRun>& runs, int code) {
  Json json = {{"schema", "blossom.files/1"},
               {"command", files.command->get_name()},
               {"exit_code", code},
               {"files", Json::array()}};
  for (FileRun& run : runs)
    json["files"].push_back({{"file", run.file},
                             {"exit_code", run.code},
                             {"error", run.error.empty() ? Json() : Json(run.error)},
                             {"report", std::move(run.report)}});
  return json;
}

// An error that begins with the file's name, which is told already.
std::string without_name(const std::string& error, const std::string& file) {
  const std::string name = file + ": ";
  return error.starts_with(name) ? error.substr(name.size()) : error;
}

}  // namespace

bool are_many(const std::vector<std::string>& inputs, const CommonOptions& common) {
  return inputs.size() > 1 || !common.table.empty();
}

int run_many(const ManyFiles& files) {
  const CommonOptions& common = files.common;
  if (files.inputs.size() > 1)
    for (const char* const name : {"--output", "--picture", "--html", "--glb"})
      if (const CLI::Option* const option = files.command->get_option_no_throw(name);
          option != nullptr && option->count() > 0)
        throw UsageError(std::string(name) + " is for one file, not for " +
                         std::to_string(files.inputs.size()));
  check_files(common, files.inputs);
  const std::vector<std::string> options = given_options(*files.command);
  std::vector<FileRun> runs;
  int code = kExitComplete;
  for (const std::string& input : files.inputs) {
    enter(Phase::Working, "working on " + input);
    const FileRun& run = runs.emplace_back(run_on(input, files, options));
    if (place_of(run.code) < place_of(code)) code = run.code;
    const std::string words =
        run.report.is_null() ? without_name(run.error, input) : files.words(run.report);
    print_summary(input + ": " + words + "\n", common.json);
  }
  stop_if_interrupted();
  enter(Phase::Writing, "the results");
  if (!common.table.empty()) occt::write_text(table_of(files, runs), common.table);
  if (!common.json.empty()) write_plain_json(json_of(files, runs, code), common.json);
  return code;
}

}  // namespace blossom::cli
