// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole models beside Open CASCADE's BRepAlgoAPI_Section, and how time grows with the input.
//
//   bench_models [--limit SECONDS] [--sections] [--moved] [--equal] [--growth] [--threads]
//                [FILE...]
//
// Without files: those of BLOSSOM_TEST_DATA/models. Without a part: all of them.
//
// sections   each model cut by three planes through the middle of its box
// moved      each model against a copy turned by 23 degrees and moved by 6 % of its size, and by
//            2 degrees and 0.4 %
// equal      each model against an identical copy
// growth     height fields of n x n spans that cross along one curve: time against n
// threads    the largest of these, and each model against its first copy, with 1 and 2 threads,
//            beside a loop of multiply-adds
//
// Both work in one thread, each in a process of its own with a limit of processor time; seconds
// are processor time, which other programs of the machine disturb least (`threads`: of the clock,
// since there is nothing else to measure there).

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Section.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/plane_section.h"
#include "adapters/occt/shapes.h"
#include "tests/bench/models_growth.h"
#include "tests/bench/models_measure.h"
#include "tests/bench/moved_copy.h"
#include "tests/support/models.h"

namespace blossom::bench {
namespace {

struct Settings {
  std::string csv;    // for the table of growth
  double limit = 60;  // seconds of processor time
  std::set<std::string> parts;
  std::vector<std::string> files;
};

IntersectionOptions options_for(double size) {
  IntersectionOptions options;
  options.tolerances.point = std::max(1e-7, 1e-9 * size);
  options.threads = 1;
  return options;
}

Outcome by_occt(const std::function<void(BRepAlgoAPI_Section&)>& load) {
  BRepAlgoAPI_Section section;
  load(section);
  section.SetRunParallel(false);
  section.Approximation(true);
  section.ComputePCurveOn1(true);
  section.Build();
  Outcome outcome;
  outcome.failed = !section.IsDone();
  if (!outcome.failed) outcome.length = length_of(section.Shape());
  return outcome;
}

void print_row(const std::string& name, const Outcome& ours, const Outcome& theirs) {
  const auto seconds = [](const Outcome& o) {
    char text[32];
    std::snprintf(text, sizeof text, o.ended ? "%9.3f" : ">%8.1f", o.seconds);
    return o.failed ? std::string("   failed") : std::string(text);
  };
  std::printf("%-34s %s %s %8.2f %13.6g %13.6g %-9s %6ld %5ld %5ld\n", name.c_str(),
              seconds(ours).c_str(), seconds(theirs).c_str(), theirs.seconds / ours.seconds,
              ours.length, theirs.length, to_string(ours.status), ours.pairs, ours.curves,
              ours.places);
  std::fflush(stdout);
}

void print_head(const char* part) {
  std::printf("\n%s\n%-34s %9s %9s %8s %13s %13s %-9s %6s %5s %5s\n", part, "model", "blossom",
              "occt", "ratio", "length", "length occt", "status", "pairs", "curves", "places");
}

// --- sections

Outcome section_of(const TopoDS_Shape& shape, const occt::Plane& plane, double size) {
  const occt::PlaneSection found =
      occt::plane_section(occt::faces_of(shape), plane, options_for(size));
  Outcome outcome;
  outcome.status = found.status;
  outcome.pairs = found.faces_searched;
  outcome.curves = static_cast<long>(found.curves.size());
  outcome.places = static_cast<long>(found.places.size());
  for (const occt::SectionWire& wire : found.wires) {
    outcome.length += wire.length;
    outcome.open += !wire.closed;
  }
  return outcome;
}

void cut_by_planes(const Settings& settings, const std::string& file) {
  const TopoDS_Shape shape = testing::repaired_model(file).shape();
  const Sized box = sized_by_box(shape);
  int number = 0;
  for (const Vec3& normal : {Vec3{1, 0.02, 0.01}, Vec3{0.3, 1, -0.2}, Vec3{-0.4, 0.5, 1}}) {
    const occt::Plane plane{box.middle + 0.013 * box.size * unit(normal), normal};
    const Outcome ours =
        measured(settings.limit, [&] { return section_of(shape, plane, box.size); });
    const Outcome theirs = measured(settings.limit, [&] {
      return by_occt([&](BRepAlgoAPI_Section& section) {
        const Vec3& p = plane.point;
        section.Init1(shape);
        section.Init2(gp_Pln(gp_Pnt(p[0], p[1], p[2]), gp_Dir(normal[0], normal[1], normal[2])));
      });
    });
    const std::string stem = std::filesystem::path(file).filename().string();
    std::string name = stem + " plane " + std::to_string(++number);
    if (ours.open > 0) name += ", " + std::to_string(ours.open) + " open";
    print_row(name, ours, theirs);
  }
}

// --- moved copies

Outcome intersection_of(const TopoDS_Shape& a, const TopoDS_Shape& b, double size, double limit) {
  IntersectionOptions options = options_for(size);
  options.time_limit = limit;
  const occt::ShapeIntersection found =
      occt::intersect(occt::faces_of(a), occt::faces_of(b), options);
  Outcome outcome;
  outcome.status = found.status;
  outcome.pairs = found.face_pairs;
  for (const occt::FaceIntersection& pair : found.pairs) {
    outcome.curves += static_cast<long>(pair.found.curves.size());
    outcome.places += static_cast<long>(pair.found.places.size());
    for (const IntersectionCurve& curve : pair.found.curves) outcome.length += curve.length;
  }
  return outcome;
}

void meet(const Settings& settings, const std::string& name, const TopoDS_Shape& shape,
          const TopoDS_Shape& copy) {
  const double size = sized_by_box(shape).size;
  const Outcome ours = measured(2 * settings.limit,
                                [&] { return intersection_of(shape, copy, size, settings.limit); });
  const Outcome theirs = measured(settings.limit, [&] {
    return by_occt([&](BRepAlgoAPI_Section& section) {
      section.Init1(shape);
      section.Init2(copy);
      section.ComputePCurveOn2(true);
    });
  });
  print_row(name, ours, theirs);
}

void meet_copies(const Settings& settings, const std::string& file) {
  const TopoDS_Shape shape = testing::repaired_model(file).shape();
  const std::string name = std::filesystem::path(file).filename().string();
  meet(settings, name + " 23 deg", shape, moved_copy(shape, 23, 0.06));
  meet(settings, name + " 2 deg", shape, moved_copy(shape, 2, 0.004));
}

void meet_itself(const Settings& settings, const std::string& file) {
  const TopoDS_Shape shape = testing::repaired_model(file).shape();
  const std::string name = std::filesystem::path(file).filename().string();
  meet(settings, name + " copy", shape, BRepBuilderAPI_Copy(shape).Shape());
}

// --- threads

std::vector<ThreadJob> copies_by_threads(const Settings& settings) {
  std::vector<ThreadJob> jobs;
  for (const std::string& file : settings.files) {
    const TopoDS_Shape shape = testing::repaired_model(file).shape();
    const double size = sized_by_box(shape).size;
    jobs.push_back({std::filesystem::path(file).filename().string(),
                    [size, a = occt::faces_of(shape),
                     b = occt::faces_of(moved_copy(shape, 23, 0.06))](int threads) {
                      IntersectionOptions options = options_for(size);
                      options.threads = threads;
                      occt::intersect(a, b, options);
                    }});
  }
  return jobs;
}

// --- all of it

std::vector<std::string> models_of_test_data() {
  std::vector<std::string> files;
  const char* data = std::getenv("BLOSSOM_TEST_DATA");
  if (data == nullptr) return files;
  const std::set<std::string> endings{".stp", ".step", ".brep", ".iges", ".igs"};
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(data) / "models"))
    if (endings.contains(entry.path().extension().string())) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

Settings settings_of(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--limit" && i + 1 < argc)
      settings.limit = std::strtod(argv[++i], nullptr);
    else if (argument == "--csv" && i + 1 < argc)
      settings.csv = argv[++i];
    else if (argument.starts_with("--"))
      settings.parts.insert(argument.substr(2));
    else
      settings.files.push_back(argument);
  }
  if (settings.parts.empty()) settings.parts = {"sections", "moved", "equal", "growth", "threads"};
  if (settings.files.empty()) settings.files = models_of_test_data();
  return settings;
}

}  // namespace

int run(int argc, char** argv) {
  occt::quiet_messages();
  const Settings settings = settings_of(argc, argv);
  const auto for_all = [&](const char* part, const char* head, auto work) {
    if (!settings.parts.contains(part)) return;
    print_head(head);
    for (const std::string& file : settings.files) work(settings, file);
  };
  for_all("sections", "Plane sections (seconds of processor time, one thread)", cut_by_planes);
  for_all("moved", "Model against a moved copy (likewise)", meet_copies);
  for_all("equal", "Model against an identical copy (likewise)", meet_itself);
  if (settings.parts.contains("growth")) print_growth(settings.csv);
  if (settings.parts.contains("threads")) print_threads(copies_by_threads(settings));
  return 0;
}

}  // namespace blossom::bench

int main(int argc, char** argv) { return blossom::bench::run(argc, argv); }
