// SPDX-License-Identifier: LGPL-2.1-or-later
// What reading models costs beside Open CASCADE's plain readers: `read_model`, repairs of all faces
// after it, and the whole of `blossom info`. Each in a process of its own, processor time.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <oneapi/tbb/global_control.h>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/shapes.h"
#include "plugin/cli/commands/commands.h"
#include "tests/bench/apart.h"

namespace blossom::bench {
namespace {

constexpr double kLimit = 120;  // seconds
constexpr int kRepetitions = 3;

void read_plainly(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  TopoDS_Shape shape;
  if (ending == ".brep") {
    const BRep_Builder builder;
    BRepTools::Read(shape, file.c_str(), builder);
  } else if (ending == ".iges" || ending == ".igs") {
    IGESControl_Reader reader;
    reader.ReadFile(file.c_str());
    reader.TransferRoots();
    shape = reader.OneShape();
  } else {
    STEPControl_Reader reader;
    reader.ReadFile(file.c_str());
    reader.TransferRoots();
    shape = reader.OneShape();
  }
}

void read(const std::filesystem::path& file) { occt::read_model(file); }

void read_and_repair(const std::filesystem::path& file) { occt::read_model(file).repair(); }

void tell(const std::filesystem::path& file) {
  // Time is counted for one thread: let it do all of the work.
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  CLI::App app;
  int code = 0;
  cli::add_info(app, code);
  std::vector<std::string> words = {"/dev/null", "--json", "-q", file.string(), "info"};
  app.parse(words);  // from the last one on
}

// The best of some runs; none if one did not end well.
double seconds(const std::function<void(const std::filesystem::path&)>& work,
               const std::filesystem::path& file) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRepetitions; ++i) {
    double took = 0;
    const Ending ending = apart<double>(kLimit, took, [&] {
      const double start = thread_seconds();
      work(file);
      return thread_seconds() - start;
    });
    if (ending != Ending::Done) return std::nan("");
    best = std::min(best, took);
  }
  return best;
}

double median(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::vector<std::filesystem::path> files_in(int count, char** arguments) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < count; ++i) {
    if (!std::filesystem::is_directory(arguments[i])) {
      files.emplace_back(arguments[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(arguments[i]))
      for (const char* const ending : {".step", ".stp", ".iges", ".igs", ".brep"})
        if (entry.path().extension() == ending) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

int run(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(stderr, "usage: bench_reading FILE_OR_FOLDER...\n");
    return 2;
  }
  occt::quiet_messages();
  std::printf("%-24s %10s %8s %8s %8s\n", "file", "plain, ms", "read", "repaired", "info");
  std::vector<double> reading, repairing, telling;
  for (const std::filesystem::path& file : files_in(count, arguments)) {
    const double plain = seconds(read_plainly, file);
    reading.push_back(seconds(read, file) / plain);
    repairing.push_back(seconds(read_and_repair, file) / plain);
    telling.push_back(seconds(tell, file) / plain);
    std::printf("%-24s %10.1f %8.2f %8.2f %8.2f\n", file.filename().c_str(), 1e3 * plain,
                reading.back(), repairing.back(), telling.back());
    std::fflush(stdout);
  }
  std::printf("%-24s %10s %8.2f %8.2f %8.2f\n", "median", "", median(reading), median(repairing),
              median(telling));
  return 0;
}

}  // namespace
}  // namespace blossom::bench

int main(int count, char** arguments) { return blossom::bench::run(count, arguments); }
