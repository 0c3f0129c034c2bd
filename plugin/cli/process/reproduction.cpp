// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/process/reproduction.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plugin/cli/arguments/values.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/cli/program.h"

namespace blossom::cli {
namespace {

using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

constexpr std::string_view kReproduce = "--reproduce", kBatchCommand = "batch";
constexpr double kMinAgainSeconds = 60, kTimesAsLong = 20;

/// What becomes of the files that a command writes.
enum class Outputs {
  None,      ///< it writes none
  InFolder,  ///< under other names, in a folder
  Kept,      ///< where they were
};

/// Where a command is to write a file; nothing if it is not to.
std::optional<std::string> output(Outputs outputs, const std::string& option,
                                  const std::string& file, const std::string& name) {
  if (outputs == Outputs::None || option == "--log" || option == kReproduce) return std::nullopt;
  if (file == "-") return file;
  return outputs == Outputs::Kept ? std::filesystem::absolute(file).string() : name;
}

/// The words of a command that writes in another way.
///
/// folder   for Outputs::InFolder
/// files    gets what is written there, if not null
Words with_outputs(const Words& words, Outputs outputs, const std::filesystem::path& folder,
                   std::vector<std::filesystem::path>* files = nullptr) {
  Words rest;
  int number = 0;
  const auto add = [&](const std::string& option, const std::string& file, const std::string& tie) {
    const std::string file_name = std::filesystem::path(file).filename().string();
    const std::string name =
        folder / ("output" + std::to_string(++number) +
                  file_name.substr(std::min(file_name.find('.'), file_name.size())));
    const std::optional<std::string> there = output(outputs, option, file, name);
    if (there && *there == name && files != nullptr) files->emplace_back(name);
    if (there && tie.empty()) rest.insert(rest.end(), {option, *there});
    if (there && !tie.empty()) rest.push_back(option + tie + *there);
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t tie = words[i].find('=');
    if (is_output(words[i]) && i + 1 < words.size())
      add(words[i], words[i + 1], ""), ++i;
    else if (tie != std::string::npos && is_output(words[i].substr(0, tie)))
      add(words[i].substr(0, tie), words[i].substr(tie + 1), "=");
    else
      rest.push_back(words[i]);
  }
  return rest;
}

std::string folder_in(const Words& words) {
  const auto option = std::ranges::find(words, kReproduce);
  if (option != words.end() && option + 1 != words.end()) return option[1];
  const std::string start = std::string(kReproduce) + "=";
  for (const std::string& word : words)
    if (word.starts_with(start)) return word.substr(start.size());
  return {};
}

// In single quotes, in which a shell reads nothing but their end.
std::string quoted_word(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

// Puts the input into the folder: what is selected alone, if that comes to the same end, or the
// file.
void place(std::vector<Part>& parts, std::size_t number, const std::filesystem::path& folder,
           const Reduction& reduction) {
  Part& part = parts[number];
  const Part before = part;
  const std::string stem = "input" + std::to_string(number + 1);
  if (!part.faces.empty() && before.word() != before.file.string()) {
    part = {part.place, folder / (stem + ".brep")};
    const Words convert{"blossom", "convert", before.word(), "-o", part.file.string(), "-q"};
    if (silent_end(convert, run_program, {}).code != kExitFailure &&
        std::filesystem::exists(part.file) && reduction.repeats(parts))
      return;
    std::filesystem::remove(part.file);
  }
  part = before;
  part.file = folder / (stem + before.file.extension().string());
  std::filesystem::copy_file(before.file, part.file,
                             std::filesystem::copy_options::overwrite_existing);
}

// Brings the inputs of a command to the folder.
// returns   its words, with names in the folder
Words command_within(const Words& words, Outputs outputs, const std::filesystem::path& folder,
                     std::vector<Part> parts, const Reduction& reduction) {
  if (outputs != Outputs::Kept) reduction.reduce(parts);
  for (std::size_t i = 0; i < parts.size(); ++i) place(parts, i, folder, reduction);
  Words command = with_outputs(words, outputs, {});
  for (Part& part : parts) {
    part.file = part.file.filename();
    command[part.place] = part.word();
  }
  return command;
}

// The command in the folder: one that writes nothing, or only there, if that comes to the same end.
// What it says then is what less of its inputs has to bring it to say.
Words smallest_command(const Words& words, const Program& program, const Ended& ended,
                       Clock::time_point until, const std::filesystem::path& folder) {
  for (const Outputs outputs : {Outputs::None, Outputs::InFolder}) {
    std::vector<std::filesystem::path> files;
    const Words command = with_outputs(words, outputs, folder, &files);
    const std::vector<Part> parts = parts_of(command);
    Reduction reduction(command, program, until);
    const End end = reduction.end_with(parts);
    const bool same = end.code == ended.code && end.crashed == ended.how.crashed;
    reduction.want(end);
    const Words result = same ? command_within(words, outputs, folder, parts, reduction) : Words();
    for (const std::filesystem::path& file : files) std::filesystem::remove(file);
    if (same) return result;
  }
  // Where it writes matters, or it comes to another end each time: it is not tried again.
  const Words command = with_outputs(words, Outputs::Kept, folder);
  return command_within(words, Outputs::Kept, folder, parts_of(command),
                        Reduction(command, program, Clock::now()));
}

// The same with the time limit that it had from outside, where its own is no shorter one.
Words with_time_limit(Words command) {
  const double limit = greatest_time_limit();
  if (!(limit > 0)) return command;
  const std::string option = "--time-limit", tied = option + "=";
  for (std::size_t i = 0; i < command.size(); ++i) {
    const bool is_tied = command[i].starts_with(tied);
    if (!is_tied && (command[i] != option || i + 1 == command.size())) continue;
    std::string& own = command[is_tied ? i : i + 1];
    if (std::stod(is_tied ? own.substr(tied.size()) : own) > limit)
      own = (is_tied ? tied : "") + number_text(limit);
    return command;
  }
  command.insert(std::ranges::find(command, "--"), {option, number_text(limit)});
  return command;
}

// What gives a shell the limit on memory that this process has; empty if there is none.
std::string memory_limit_command() {
  constexpr rlim_t kUnit = 1024;  // bytes
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
  return "ulimit -d " + std::to_string(limit.rlim_cur / kUnit) + " && ";
}

void reproduce(const Words& words, const Program& program, const Ended& ended, double seconds,
               const std::filesystem::path& folder) {
  const auto until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
                         std::max(kMinAgainSeconds, kTimesAsLong * seconds)));
  std::filesystem::create_directories(folder);
  const Words command = with_time_limit(smallest_command(words, program, ended, until, folder));
  std::ofstream script(folder / "repeat");
  script << "#!/bin/sh\ncd \"$(dirname \"$0\")\" && " << memory_limit_command() << "exec blossom";
  for (std::size_t i = 1; i < command.size(); ++i) script << ' ' << quoted_word(command[i]);
  script << '\n';
  script.close();
  std::filesystem::permissions(folder / "repeat", std::filesystem::perms::owner_exec,
                               std::filesystem::perm_options::add);
  std::cerr << "blossom: " << (folder / "repeat").string() << " does it again\n";
}

}  // namespace

Ended run_reproducibly(const Words& words, const Program& program,
                       const std::function<void(const Ended&)>& told) {
  const auto start = Clock::now();
  const Ended ended = ended_by(words, program);
  const bool is_batch = words.size() > 1 && words[1] == kBatchCommand;
  const std::string folder = is_batch ? "" : folder_in(words);
  const bool wanted = ended.code == kExitFailure || ended.code == kExitStopped || ended.how.crashed;
  if (folder.empty() || !wanted) return ended;
  if (told) told(ended);
  try {
    reproduce(words, program, ended, std::chrono::duration<double>(Clock::now() - start).count(),
              folder);
  } catch (const std::exception& error) {
    std::cerr << "blossom: " << folder
              << ": what repeats the command cannot be written: " << error.what() << '\n';
  }
  return ended;
}

}  // namespace blossom::cli
