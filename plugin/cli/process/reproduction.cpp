// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/process/reproduction.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/cli/program.h"
#include "plugin/nets/net_json.h"

namespace blossom::cli {
namespace {

using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

constexpr std::string_view kReproduce = "--reproduce", kBatchCommand = "batch";
constexpr int kTrials = 40;
constexpr double kMinAgainSeconds = 60, kTimesAsLong = 20;

// How a command came out, as far as it has to be the same again.
struct End {
  int code = 0;
  bool crashed = false;
  bool operator==(const End&) const = default;
};

Ended ended_by(Words words, const Program& program) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int code =
      supervised([&] { return program(static_cast<int>(words.size()), arguments.data()); });
  return {code, last_ending()};
}

End end_of(Words words, const Program& program) {
  const Ended ended = ended_by(std::move(words), program);
  return {ended.code, ended.how.crashed};
}

// While it lives, nothing comes to stdout and stderr.
class Silence {
 public:
  Silence() : out_(dup(STDOUT_FILENO)), err_(dup(STDERR_FILENO)) {
    std::cout.flush();
    const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    close(nothing);
  }
  ~Silence() {
    dup2(out_, STDOUT_FILENO);
    dup2(err_, STDERR_FILENO);
    close(out_);
    close(err_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int out_, err_;
};

bool is_output(const std::string& word) {
  for (const char* option : {"-o", "--output", "--json", "--picture", "--html", "--glb", "--table",
                             "--log", "--reproduce"})
    if (word == option) return true;
  return false;
}

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

// A model among the words.
struct Part {
  std::size_t place;  // of the word
  std::filesystem::path file;
  std::string selection;    // that follows the file's name: "#Shaft", or nothing
  std::vector<int> faces;   // that may be left out; none of what is no model
  bool only_faces = false;  // these are what is selected

  std::string word() const {
    std::string text = file.string();
    if (!only_faces) return text + selection;
    for (std::size_t i = 0; i < faces.size(); ++i)
      text += (i == 0 ? "#" : ",") + std::to_string(faces[i]);
    return text;
  }
};

// How many faces a model has, by a process that may crash; 0 if it does, or the file is no model.
int face_count(const std::filesystem::path& file) {
  void* const memory =
      mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 0;
  int* const count = new (memory) int(0);
  supervised([&] {
    try {
      *count = read_and_report(file).face_count();
    } catch (const std::exception&) {  // a law or planes, say, or triangles
    }
    return 0;
  });
  const int result = *count;
  munmap(memory, sizeof(int));
  return result;
}

std::vector<int> chosen(const InputName& name) {
  std::vector<int> faces;
  const int count = face_count(name.file);
  for (const auto& [first, last] : name.faces)
    for (int face = first; face <= std::min(last, count); ++face) faces.push_back(face);
  if (name.faces.empty())
    for (int face = 1; face <= count; ++face) faces.push_back(face);
  return faces;
}

std::vector<Part> parts_of(const Words& words) {
  std::vector<Part> parts;
  for (std::size_t i = 2; i < words.size(); ++i) try {
      if (is_output(words[i - 1])) continue;
      const InputName name = parse_input(words[i]);
      if (!std::filesystem::is_regular_file(name.file)) continue;
      parts.push_back({i, name.file, words[i].substr(name.file.string().size()),
                       nets::is_net_file(name.file) ? std::vector<int>{} : chosen(name)});
    } catch (const UsageError&) {  // no input
    }
  return parts;
}

class Reduction {
 public:
  Reduction(Words words, const Program& program, End wanted, double seconds)
      : words_(std::move(words)),
        program_(program),
        wanted_(wanted),
        until_(Clock::now() +
               std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
                   std::max(kMinAgainSeconds, kTimesAsLong * seconds)))) {}

  bool repeats(const std::vector<Part>& parts) {
    if (++trials_ > kTrials || Clock::now() > until_) return false;
    Words words = words_;
    for (const Part& part : parts) words[part.place] = part.word();
    return end_of(std::move(words), program_) == wanted_;
  }

  // Halves the faces of every part as long as the command comes to the same end.
  void reduce(std::vector<Part>& parts) {
    for (bool smaller = true; smaller;) {
      smaller = false;
      for (std::size_t i = 0; i < parts.size(); ++i) smaller = halved(parts, i) || smaller;
    }
  }

 private:
  bool halved(std::vector<Part>& parts, std::size_t number) {
    const Part before = parts[number];
    const std::vector<int>& all = before.faces;
    if (all.size() < 2) return false;
    parts[number].only_faces = true;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    for (const auto& half :
         {std::vector<int>(all.begin(), middle), std::vector<int>(middle, all.end())}) {
      parts[number].faces = half;
      if (repeats(parts)) return true;
    }
    parts[number] = before;
    return false;
  }

  Words words_;
  const Program& program_;
  End wanted_;
  Clock::time_point until_;
  int trials_ = 0;
};

// In single quotes, in which a shell reads nothing but their end.
std::string quoted_word(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

// Puts the input into the folder: what is selected alone, if that comes to the same end, or the
// file.
void place(std::vector<Part>& parts, std::size_t number, const std::filesystem::path& folder,
           Reduction& reduction) {
  Part& part = parts[number];
  const Part before = part;
  const std::string stem = "input" + std::to_string(number + 1);
  if (!part.faces.empty() && before.word() != before.file.string()) {
    part = {part.place, folder / (stem + ".brep"), {}, {}};
    if (end_of({"blossom", "convert", before.word(), "-o", part.file.string(), "-q"}, run_program)
                .code != kExitFailure &&
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
                     std::vector<Part> parts, Reduction& reduction) {
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
Words smallest_command(const Words& words, const Program& program, End end, double seconds,
                       const std::filesystem::path& folder) {
  const Silence silence;
  for (const Outputs outputs : {Outputs::None, Outputs::InFolder}) {
    std::vector<std::filesystem::path> files;
    const Words command = with_outputs(words, outputs, folder, &files);
    const std::vector<Part> parts = parts_of(command);
    Reduction reduction(command, program, end, seconds);
    const bool same = reduction.repeats(parts);
    const Words result = same ? command_within(words, outputs, folder, parts, reduction) : Words();
    for (const std::filesystem::path& file : files) std::filesystem::remove(file);
    if (same) return result;
  }
  // Where it writes matters, or it comes to another end each time.
  const Words command = with_outputs(words, Outputs::Kept, folder);
  Reduction reduction(command, program, end, seconds);
  return command_within(words, Outputs::Kept, folder, parts_of(command), reduction);
}

void reproduce(const Words& words, const Program& program, End end, double seconds,
               const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const Words command = smallest_command(words, program, end, seconds, folder);
  std::ofstream script(folder / "repeat");
  script << "#!/bin/sh\ncd \"$(dirname \"$0\")\" && exec blossom";
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
    reproduce(words, program, {ended.code, ended.how.crashed},
              std::chrono::duration<double>(Clock::now() - start).count(), folder);
  } catch (const std::exception& error) {
    std::cerr << "blossom: " << folder
              << ": what repeats the command cannot be written: " << error.what() << '\n';
  }
  return ended;
}

}  // namespace blossom::cli
