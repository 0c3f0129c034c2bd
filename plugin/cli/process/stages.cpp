// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/process/stages.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <new>
#include <span>
#include <string>

#include "adapters/occt/base/errors.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/exit_code.h"

namespace blossom::cli {
namespace {

using Clock = std::chrono::steady_clock;
using reports::Json;

constexpr std::size_t kKinds = 64;  // of stages that a profile tells apart; what is more is one
constexpr std::size_t kShown = 8;   // stages that a profile names
constexpr std::size_t kName = 256;  // bytes of a stage that a profile keeps

struct StageKind {
  char name[kName] = "";
  double seconds = 0;
  std::size_t count = 0;
};

// In memory of the parent and its children.
struct StageBoard {
  char log[4096] = "";
  bool profile = false;
  char stage[4096] = "starting";
  Clock::time_point start = Clock::now(), since = start;
  std::array<StageKind, kKinds> kinds{};
  std::size_t kind_count = 0;
};

StageBoard* stages = nullptr;

double between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

template <std::size_t size>
void put_name(const std::string& text, char (&place)[size]) {
  place[text.copy(place, size - 1)] = '\0';
}

// "checking face 7 of a1.step" and "checking face 8 of a1.step" are one kind.
std::string kind_of(const std::string& stage) {
  std::string kind, word;
  const auto end_word = [&] {
    const bool number =
        !word.empty() && std::ranges::all_of(word, [](unsigned char c) { return std::isdigit(c); });
    kind += number ? "..." : word;
    word.clear();
  };
  for (const char c : stage) {
    if (c != ' ') {
      word += c;
      continue;
    }
    end_word();
    kind += c;
  }
  end_word();
  return kind.substr(0, kName - 1);
}

void count_stage(const std::string& stage, double seconds) {
  const std::string kind = kind_of(stage);
  std::size_t i = 0;
  while (i < stages->kind_count && kind != stages->kinds[i].name) ++i;
  if (i == stages->kind_count && i < kKinds) {
    put_name(i + 1 < kKinds ? kind : "others", stages->kinds[i].name);
    ++stages->kind_count;
  }
  StageKind& counted = stages->kinds[std::min(i, kKinds - 1)];
  counted.seconds += seconds;
  ++counted.count;
}

double megabytes(int who) {
  rusage used{};
  getrusage(who, &used);
  return static_cast<double>(used.ru_maxrss) * 1024 / 1e6;
}

// Of the stage that ends now.
Json end_stage(int who) {
  const Clock::time_point now = Clock::now();
  const double seconds = between(stages->since, now);
  if (stages->profile) count_stage(stages->stage, seconds);
  Json line{{"stage", stages->stage},
            {"at", between(stages->start, stages->since)},
            {"seconds", seconds},
            {"memory_mb", megabytes(who)}};
  stages->since = now;
  return line;
}

void print_profile() {
  const std::span<StageKind> kinds(stages->kinds.data(), stages->kind_count);
  std::ranges::sort(kinds, std::greater<>(), &StageKind::seconds);
  const double all = std::max(between(stages->start, stages->since), 1e-9);
  std::fprintf(stderr, "blossom: %.3f s in all\n", all);
  const auto print = [&](double seconds, const std::string& what) {
    std::fprintf(stderr, "%10.3f s %3.0f %%  %s\n", seconds, 100 * seconds / all, what.c_str());
  };
  const std::size_t shown = std::min(kinds.size(), kShown);
  for (const StageKind& kind : kinds.first(shown))
    print(kind.seconds,
          kind.name + (kind.count > 1 ? ", " + std::to_string(kind.count) + " times" : ""));
  double others = 0;
  for (const StageKind& kind : kinds.subspan(shown)) others += kind.seconds;
  if (shown < kinds.size()) print(others, std::to_string(kinds.size() - shown) + " other stages");
}

bool is_wanted() { return stages != nullptr && (stages->profile || stages->log[0] != '\0'); }

}  // namespace

void share_stages() {
  void* const memory =
      mmap(nullptr, sizeof(StageBoard), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  stages = memory == MAP_FAILED ? nullptr : new (memory) StageBoard;
}

void begin_stage(const std::string& what) {
  if (stages == nullptr) return;
  if (is_wanted() && what == stages->stage) return;
  if (is_wanted()) log_line(end_stage(RUSAGE_SELF));
  put_name(what, stages->stage);
  if (!is_wanted()) stages->since = Clock::now();
}

void end_stages(const std::string& how) {
  if (!is_wanted()) return;
  Json line = end_stage(RUSAGE_CHILDREN);
  line["ended"] = how;
  log_line(line);
  if (stages->profile) print_profile();
}

void log_stages(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension();
  if (ending != ".jsonl" && ending != ".log")  // nothing is added to a model
    throw UsageError(file + ": a log's name ends in .jsonl or .log");
  refuse_special(file);
  const int descriptor = open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw occt::Failure(file + ": cannot be written: " + std::strerror(errno));
  close(descriptor);
  if (stages == nullptr) return;
  if (file.size() >= sizeof(stages->log)) throw occt::Failure(file + ": the name is too long");
  put_name(file, stages->log);
}

void profile_stages() {
  if (stages != nullptr) stages->profile = true;
}

void log_line(const Json& line) {
  if (stages == nullptr || stages->log[0] == '\0') return;
  const std::string text = line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  const int descriptor = open(stages->log, O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor < 0) return;  // a log is not worth the work
  [[maybe_unused]] const ssize_t written = write(descriptor, text.data(), text.size());
  close(descriptor);
}

}  // namespace blossom::cli
