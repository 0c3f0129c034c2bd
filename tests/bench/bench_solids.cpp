// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole solids combined with moved copies of themselves, beside BRepAlgoAPI_Cut, _Common, _Fuse.
//
//   bench_solids [--limit SECONDS] [--no-peer] [--axis X,Y,Z] [--copy c1|c2] FILE...
//
// c1 is turned by 23 degrees and moved by 6 % of the size, c2 by 2 degrees and 0.4 %. A job is one
// model and one copy; it is right when all three results are valid by BRepCheck_Analyzer, and
// V(fuse) + V(common) = V(part) + V(copy) and V(cut) + V(common) = V(part) within 1e-6 relative,
// volumes integrated over the faces of the results. Of ours the first obstacles are printed.
//
// Each operation works in one thread of a process of its own with a limit of processor time; its
// seconds are processor time, without integration.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/solid_trim.h"
#include "core/base/errors.h"
#include "tests/bench/apart.h"
#include "tests/bench/command_line.h"
#include "tests/bench/moved_copy.h"
#include "tests/support/models.h"

namespace blossom::bench {
namespace {

constexpr double kVolumesAgree = 1e-6;  // relative
constexpr std::array kOperations{occt::SolidOperation::Cut, occt::SolidOperation::Common,
                                 occt::SolidOperation::Fuse};
constexpr std::array kNames{"cut", "common", "fuse"};

struct Settings {
  double limit = 60;
  bool peer = true;
  Vec3 axis{0.3, 0.5, 0.81};
  std::string copy;  // one kind only
  std::vector<std::string> files;
};

// One operation of one side; plain values, so that it can be passed between processes.
struct Combined {
  Ending ending = Ending::Died;
  bool refused = false, valid = true;
  double volume = 0, seconds = 0;
  int solids = 0, faces = 0;
  std::array<char, 1500> obstacles{};

  bool usable() const { return ending == Ending::Done && !refused; }
};

double volume_of(const TopoDS_Shape& shape, const Vec3& apex) {
  double sum = 0;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    for (TopExp_Explorer it(solid.Current(), TopAbs_FACE); it.More(); it.Next())
      sum += occt::cone_volume(TopoDS::Face(it.Current()), apex);
  return sum;
}

void judge(const TopoDS_Shape& shape, const Vec3& apex, Combined& result) {
  TopTools_IndexedMapOfShape solids, faces;
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  result.solids = solids.Extent();
  result.faces = faces.Extent();
  result.valid = BRepCheck_Analyzer(shape).IsValid();
  result.volume = volume_of(shape, apex);
}

// What is no closed solid is an obstacle like others here.
occt::SolidTrimResult combined(const TopoDS_Shape& part, const TopoDS_Shape& tool,
                               std::size_t operation, const IntersectionOptions& options) {
  try {
    return occt::trim_solids(occt::trim_tool(part), {occt::trim_tool(tool)}, kOperations[operation],
                             options);
  } catch (const InvalidInput& error) {
    occt::SolidTrimResult none;
    none.obstacles.emplace_back(error.what());
    return none;
  }
}

Combined by_blossom(const TopoDS_Shape& part, const TopoDS_Shape& tool, std::size_t operation,
                    const Settings& settings) {
  IntersectionOptions options;
  options.threads = 1;
  options.time_limit = settings.limit;
  Combined result;
  const double start = processor_seconds();
  const occt::SolidTrimResult made = combined(part, tool, operation, options);
  result.seconds = processor_seconds() - start;
  result.refused = !made.obstacles.empty();
  std::string words;
  for (const std::string& obstacle : made.obstacles) words += "\n        " + obstacle;
  if (words.size() >= result.obstacles.size() && made.obstacles.size() > 1)
    words = "\n        " + std::to_string(made.obstacles.size()) +
            " obstacles, the first of them:" + words;
  words.copy(result.obstacles.data(), result.obstacles.size() - 1);
  judge(occt::compound_of(made.solids), sized_by_box(part).middle, result);
  return result;
}

std::unique_ptr<BRepAlgoAPI_BooleanOperation> occt_operation(std::size_t operation) {
  if (operation == 0) return std::make_unique<BRepAlgoAPI_Cut>();
  if (operation == 1) return std::make_unique<BRepAlgoAPI_Common>();
  return std::make_unique<BRepAlgoAPI_Fuse>();
}

Combined by_occt(const TopoDS_Shape& part, const TopoDS_Shape& tool, std::size_t operation) {
  TopTools_ListOfShape parts, tools;
  parts.Append(part);
  tools.Append(tool);
  Combined result;
  const double start = processor_seconds();
  const auto work = occt_operation(operation);
  work->SetArguments(parts);
  work->SetTools(tools);
  work->SetRunParallel(false);
  work->Build();
  result.seconds = processor_seconds() - start;
  result.refused = !work->IsDone();
  if (!result.refused) judge(work->Shape(), sized_by_box(part).middle, result);
  return result;
}

Combined measured(double limit, const std::function<Combined()>& work) {
  Combined result;
  const Ending ending = apart<Combined>(2 * limit, result, work);
  if (ending != Ending::Done) result = {};
  result.ending = ending;
  if (ending == Ending::Done && result.seconds > limit) result.ending = Ending::OutOfTime;
  return result;
}

struct Job {
  std::array<Combined, 3> by;  // cut, common, fuse
  double part = 0;             // volumes
  double tool = 0;

  double cut_error() const { return std::abs(by[0].volume + by[1].volume - part) / part; }
  double fuse_error() const {
    return std::abs(by[2].volume + by[1].volume - part - tool) / (part + tool);
  }
  bool usable() const {
    return std::all_of(by.begin(), by.end(), [](const Combined& each) { return each.usable(); });
  }
  bool right() const {
    return usable() && cut_error() <= kVolumesAgree && fuse_error() <= kVolumesAgree &&
           std::all_of(by.begin(), by.end(), [](const Combined& each) { return each.valid; });
  }
  double seconds() const { return by[0].seconds + by[1].seconds + by[2].seconds; }
};

std::string words(const Combined& each) {
  if (each.ending == Ending::OutOfTime) return "out of time";
  if (each.ending == Ending::Died) return "died";
  char text[100];
  std::snprintf(text, sizeof text,
                each.refused ? "refused %.2f s" : "%.2f s (%s, %d solids, %d faces)", each.seconds,
                each.valid ? "valid" : "INVALID", each.solids, each.faces);
  return text;
}

void print(const std::string& name, const char* side, const Job& job) {
  std::printf("%-24s %-8s", name.c_str(), side);
  for (std::size_t i = 0; i < job.by.size(); ++i)
    std::printf("  %s %s", kNames[i], words(job.by[i]).c_str());
  if (job.usable())
    std::printf("  errors %.1e cut, %.1e fuse  %s", job.cut_error(), job.fuse_error(),
                job.right() ? "right" : "WRONG");
  for (std::size_t i = 0; i < job.by.size(); ++i)
    if (job.by[i].obstacles[0] != 0) {
      std::printf("%s", job.by[i].obstacles.data());
      break;
    }
  std::printf("\n");
  std::fflush(stdout);
}

struct Copy {
  const char* kind;
  double degrees;
  double part;
};
constexpr std::array kCopies{Copy{"c1", 23, 0.06}, Copy{"c2", 2, 0.004}};

struct Totals {
  int jobs = 0, right = 0, usable = 0, their_right = 0, their_usable = 0;
  int unread = 0;  // files
};

void run_file(const std::string& file, const Settings& settings, Totals& totals) try {
  const TopoDS_Shape part = testing::repaired_model(file).shape();
  const Vec3 apex = sized_by_box(part).middle;
  for (const Copy& copy : kCopies) {
    if (!settings.copy.empty() && settings.copy != copy.kind) continue;
    const TopoDS_Shape tool = moved_copy(part, copy.degrees, copy.part, settings.axis);
    const std::string name = std::filesystem::path(file).stem().string() + " " + copy.kind;
    Job ours, theirs;
    ours.part = theirs.part = volume_of(part, apex);
    ours.tool = theirs.tool = volume_of(tool, apex);
    for (std::size_t i = 0; i < kOperations.size(); ++i)
      ours.by[i] = measured(settings.limit, [&] { return by_blossom(part, tool, i, settings); });
    print(name, "blossom", ours);
    ++totals.jobs;
    totals.right += ours.right();
    totals.usable += ours.usable();
    if (!settings.peer) continue;
    for (std::size_t i = 0; i < kOperations.size(); ++i)
      theirs.by[i] = measured(settings.limit, [&] { return by_occt(part, tool, i); });
    print(name, "occt", theirs);
    totals.their_right += theirs.right();
    totals.their_usable += theirs.usable();
    if (ours.usable() && theirs.usable())
      std::printf("%-24s ratio of times %.2f\n", name.c_str(), theirs.seconds() / ours.seconds());
  }
} catch (const occt::BadModel& error) {
  ++totals.unread;
  std::printf("%s\n", error.what());
}

std::optional<Settings> settings_from(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? argv[++i] : "0"; };
    if (word == "--limit")
      settings.limit = std::atof(value());
    else if (word == "--copy")
      settings.copy = value();
    else if (word == "--axis") {
      double x = 0, y = 0, z = 0;
      if (std::sscanf(value(), "%lf,%lf,%lf", &x, &y, &z) != 3) return std::nullopt;
      settings.axis = {x, y, z};
    } else if (word == "--no-peer")
      settings.peer = false;
    else
      settings.files.push_back(word);
  }
  if (settings.files.empty()) return std::nullopt;
  return settings;
}

int run_all(const Settings& settings) {
  Totals totals;
  for (const std::string& file : settings.files) run_file(file, settings, totals);
  std::printf("%d jobs: %d right, %d wrong, %d without a result", totals.jobs, totals.right,
              totals.usable - totals.right, totals.jobs - totals.usable);
  if (settings.peer)
    std::printf("; Open CASCADE: %d right, %d wrong, %d without a result", totals.their_right,
                totals.their_usable - totals.their_right, totals.jobs - totals.their_usable);
  if (totals.unread > 0) std::printf("; %d files that cannot be read", totals.unread);
  std::printf("\n");
  return totals.usable > totals.right || totals.unread > 0 ? 1 : 0;
}

}  // namespace
}  // namespace blossom::bench

int main(int argc, char** argv) {
  using namespace blossom::bench;
  return run_command(settings_from(argc, argv),
                     "bench_solids [--limit SECONDS] [--no-peer] [--axis X,Y,Z] [--copy c1|c2] "
                     "FILE...",
                     run_all);
}
