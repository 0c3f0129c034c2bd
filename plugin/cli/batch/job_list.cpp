// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/job_list.h"

#include <glob.h>

#include <charconv>
#include <filesystem>
#include <iostream>
#include <unordered_set>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/process/interruption.h"

namespace blossom::cli {
namespace {

bool is_of(Shard shard, std::size_t number) { return number % shard.count == shard.number - 1; }

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

// One line, of which no more than a job may have is kept; without end, it is none.
bool next_line(std::istream& in, std::string& line) {
  line.clear();
  for (int c = in.get(); c != std::istream::traits_type::eof(); c = in.get()) {
    if (c == '\n') return true;
    if (line.size() <= kMaxJobLine) line += static_cast<char>(c);
  }
  return !line.empty();
}

// Calls use(job, place) for every job of the shard.
template <class Use>
void each_job(std::istream& in, const std::string& name, Shard shard, const Use& use) {
  std::unordered_set<std::string> ids;
  std::string line;
  std::uint64_t place = 0;
  for (std::size_t number = 1, jobs = 0; next_line(in, line); ++number) {
    const std::uint64_t next = in.eof() ? place : static_cast<std::uint64_t>(in.tellg());
    if (!is_blank(line)) {
      stop_if_interrupted();
      const std::string where = name + ":" + std::to_string(number);
      Job job = parse_job(line, where);
      if (!ids.insert(job.id).second)
        throw UsageError(where + ": a job before it has the id '" + job.id + "', too");
      if (is_of(shard, jobs++)) use(std::move(job), place);
    }
    place = next;
  }
}

std::size_t whole(std::string_view text, const std::string& all) {
  std::size_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || value < 1 ||
      value > kMaxShards)
    throw UsageError("--shard takes NUMBER/COUNT as in 3/16, not '" + all + "'");
  return value;
}

std::vector<std::string> matches(const std::string& pattern) {
  glob_t found{};
  const int code = glob(pattern.c_str(), 0, nullptr, &found);
  std::vector<std::string> files;
  if (code == 0) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  if (code == GLOB_NOSPACE || files.size() > kMaxMatches)
    throw UsageError("--each '" + pattern + "': there are more than " +
                     std::to_string(kMaxMatches) + " files");
  if (files.empty()) throw UsageError("--each '" + pattern + "': there is no such file");
  return files;
}

}  // namespace

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string_view all = text;
  const Shard shard{whole(all.substr(0, slash), text), slash == std::string::npos
                                                           ? whole("", text)
                                                           : whole(all.substr(slash + 1), text)};
  if (shard.number > shard.count)
    throw UsageError("--shard " + text + ": there is no part " + std::to_string(shard.number) +
                     " of " + std::to_string(shard.count));
  return shard;
}

JobList JobList::of_file(const std::string& file, Shard shard) {
  JobList list;
  list.name_ = file == "-" ? "stdin" : file;
  if (file == "-") {
    each_job(std::cin, list.name_, shard,
             [&](Job job, std::uint64_t) { list.jobs_.push_back(std::move(job)); });
    return list;
  }
  refuse_special(file);
  if (std::filesystem::is_directory(file)) throw occt::BadModel(file + ": is a folder");
  list.stays_in_memory_ = false;
  list.file_.open(file, std::ios::binary);
  if (!list.file_ || list.file_.peek() == std::ifstream::traits_type::eof()) {
    if (!list.file_.is_open() || list.file_.bad())
      throw occt::BadModel(file + ": cannot be opened");
    throw UsageError(file + ": has no job in it");
  }
  each_job(list.file_, file, shard,
           [&](const Job&, std::uint64_t place) { list.places_.push_back(place); });
  list.file_.clear();
  return list;
}

JobList JobList::of_pattern(const std::string& pattern, const std::vector<std::string>& command,
                            Shard shard) {
  JobList list;
  check_command(command, "--each");
  const std::vector<std::string> files = matches(pattern);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!is_of(shard, i)) continue;
    Job job{files[i], {}};
    for (const std::string& word : command) job.arguments.push_back(filled_in(word, files[i]));
    list.jobs_.push_back(std::move(job));
  }
  return list;
}

Job JobList::at(std::size_t number) {
  if (stays_in_memory_) return jobs_.at(number);
  std::string line;
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(places_.at(number)));
  if (!next_line(file_, line)) line.clear();
  return parse_job(line, name_ + " has been changed");
}

}  // namespace blossom::cli
