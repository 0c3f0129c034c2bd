// SPDX-License-Identifier: LGPL-2.1-or-later
// The least of its inputs that brings a command to the same end.

#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "plugin/cli/process/supervision.h"

namespace blossom::cli {

/// How a command came out.
struct Ended {
  int code = 0;
  Ending how;
};

/// What runs a command line in this process, as run_program does.
using Program = std::function<int(int argc, char** argv)>;

/// Runs a command line under supervision.
Ended ended_by(std::vector<std::string> words, const Program& program);

/// How a command came out, as far as it has to be the same again.
struct End {
  int code = 0;
  bool crashed = false;
  std::string cause{};  ///< what it said last, see cause_of

  bool operator==(const End&) const = default;
};

/// An input among the words of a command.
struct Part {
  std::size_t place = 0;  ///< of the word
  std::filesystem::path file{};
  std::string selection{};                 ///< that follows the file's name: "#Shaft", or nothing
  std::vector<int> faces{};                ///< that may be left out; none of what is no model
  std::vector<std::vector<int>> bodies{};  ///< the same by closed solids, what bounds none at last
  bool only_faces = false;                 ///< these are what is selected

  std::string word() const;
};

/// Whether what follows is a file that the command writes, or a folder.
bool is_output(const std::string& word);

/// Those of a command that are files.
std::vector<Part> parts_of(const std::vector<std::string>& words);

/// The last line of what a command said on stderr that tells of itself, without what changes with
/// its inputs' names and selections: these, numbers and lists of numbers. Empty if there is none.
std::string cause_of(const std::string& said, const std::vector<Part>& parts);

/// How a command comes out; nothing comes to stdout and stderr.
End silent_end(std::vector<std::string> words, const Program& program,
               const std::vector<Part>& parts);

/// Runs a command with less and less of its inputs.
class Reduction {
 public:
  /// until   runs that are not done by then are ended, and count for nothing
  Reduction(std::vector<std::string> words, const Program& program,
            std::chrono::steady_clock::time_point until);

  /// How the command comes out with these inputs.
  End end_with(const std::vector<Part>& parts) const;

  /// What is looked for from now on.
  void want(const End& end) { wanted_ = end; }

  /// Whether it comes to that end in time.
  bool repeats(const std::vector<Part>& parts) const;

  /// Leaves out bodies, and then faces, as long as it does.
  void reduce(std::vector<Part>& parts) const;

 private:
  bool reduced(std::vector<Part>& parts, std::size_t number,
               std::vector<std::vector<int>> units) const;

  std::vector<std::string> words_;
  const Program& program_;
  std::chrono::steady_clock::time_point until_;
  End wanted_;
};

}  // namespace blossom::cli
