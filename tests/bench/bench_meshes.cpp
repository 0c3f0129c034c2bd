// SPDX-License-Identifier: GPL-3.0-or-later
// Models as triangles, beside BRepMesh_IncrementalMesh.
//
//   bench_meshes [--part P] [--angle A] [--samples N] [--no-crossings] [--faces] [--ours] FILE...
//
// A row for each model: Open CASCADE's mesh at a deflection of P of the diagonal, and ours at the
// deviation at which the measured distance is about the same: triangles, measured and proven
// distance over the deflection, processor seconds, megabytes, whether each solid is closed, and
// pairs of its triangles that cross, by CGAL. Distances are measured both ways at N samples
// (meshes_measure.h). The last columns have ours at the deflection itself. --ours has these alone,
// and counts in the end what holds of how many models. --faces lists faces of many triangles and of
// large distances.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

#include "core/base/parallel.h"
#include "tests/bench/command_line.h"
#include "tests/bench/meshes_judged.h"
#include "tests/bench/meshes_measure.h"
#include "tests/support/models.h"

namespace blossom::bench {
namespace {

constexpr std::size_t kListedFaces = 6;
constexpr int kTries = 4;  // to find the deviation with the same measured distance

struct Settings {
  double part = 1e-3;
  double angle = 0.5;
  int samples = 100'000;
  bool crossings = true, faces = false, ours = false;
  std::vector<std::string> files;
};

double diagonal_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return std::sqrt(box.SquareExtent());
}

std::string told(const FacetMesh& mesh, double measured, double deflection, double memory,
                 const std::optional<MeshVerdict>& verdict) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), "%zu | %.2f | %.2f | %.3f | %.0f | %s, %d",
                mesh.triangles.size(), measured / deflection, mesh.proven / deflection,
                mesh.seconds, memory,
                !verdict            ? "?"
                : verdict->closed   ? "closed"
                : verdict->manifold ? "open"
                                    : "no manifold",
                verdict ? verdict->crossings : 0);
  std::string all = text.data();
  if (mesh.refused > 0) all += ", " + std::to_string(mesh.refused) + " refused";
  if (mesh.folded > 0) all += ", " + std::to_string(mesh.folded) + " folded";
  return all;
}

std::optional<MeshVerdict> verdict_of(const TopoDS_Shape& shape, const FacetMesh& mesh,
                                      const Settings& settings) {
  if (!settings.crossings) return {};
  return judged_mesh(shape, mesh);
}

double our_memory(const TopoDS_Shape& shape, const FacetOptions& options) {
  return peak_megabytes([&] { our_mesh(shape, options); });
}

// The faces with the most triangles, and those with the largest distances.
void print_faces(const FacetMesh& mesh) {
  std::vector<int> count(mesh.of_face.size(), 0), order;
  for (const int face : mesh.face) ++count[static_cast<std::size_t>(face)];
  for (std::size_t f = 0; f < count.size(); ++f) order.push_back(static_cast<int>(f));
  const auto print_first = [&](const auto& value) {
    std::ranges::sort(order, std::ranges::greater(), value);
    for (std::size_t k = 0; k < order.size() && k < kListedFaces; ++k) {
      const auto f = static_cast<std::size_t>(order[k]);
      std::printf("  face %zu: %d triangles within %g\n", f + 1, count[f], mesh.of_face[f]);
    }
  };
  print_first([&](int f) { return static_cast<double>(count[static_cast<std::size_t>(f)]); });
  print_first([&](int f) { return mesh.of_face[static_cast<std::size_t>(f)]; });
}

void run(const std::string& file, const Settings& settings) {
  const occt::Model model = testing::repaired_model(file);
  const TopoDS_Shape& shape = model.shape();
  const double deflection = settings.part * diagonal_of(shape);
  const FacetMesh theirs = occt_mesh(shape, deflection, settings.angle);
  const double measured = measured_distance(shape, theirs, settings.samples);
  FacetOptions options{.deviation = deflection, .angle = settings.angle};
  const FacetMesh same = our_mesh(shape, options);
  const double of_same = measured_distance(shape, same, settings.samples);
  FacetMesh equal = same;
  double of_equal = of_same;
  for (int k = 0; k < kTries && std::abs(of_equal / measured - 1) > 0.05; ++k) {
    options.deviation *= std::clamp(measured / of_equal, 0.2, 5.0);
    equal = our_mesh(shape, options);
    of_equal = measured_distance(shape, equal, settings.samples);
  }
  const auto ours = [&](const FacetMesh& mesh, double of_mesh, double deviation) {
    const double memory = our_memory(shape, {.deviation = deviation, .angle = settings.angle});
    return told(mesh, of_mesh, deflection, memory, verdict_of(shape, mesh, settings));
  };
  const double memory = peak_megabytes([&] { occt_mesh(shape, deflection, settings.angle); });
  std::printf(
      "| %s | %s | %s | %.2f | %s |\n", std::filesystem::path(file).stem().c_str(),
      told(theirs, measured, deflection, memory, verdict_of(shape, theirs, settings)).c_str(),
      ours(equal, of_equal, options.deviation).c_str(),
      static_cast<double>(equal.triangles.size()) /
          static_cast<double>(std::max<std::size_t>(1, theirs.triangles.size())),
      ours(same, of_same, deflection).c_str());
  if (settings.faces) print_faces(same);
  std::fflush(stdout);
}

struct Counts {
  int models = 0, closed = 0, without_crossings = 0, never_above = 0, near = 0;
};

constexpr double kNear = 3;  // proven over measured
// Distances below this, in model units, are rounding.
constexpr double kRoundedGap = 1e-9;

// Ours alone, at the deflection.
void run_ours(const std::string& file, const Settings& settings, Counts& counts) {
  const occt::Model model = testing::repaired_model(file);
  const double deflection = settings.part * diagonal_of(model.shape());
  const FacetOptions options{.deviation = deflection, .angle = settings.angle};
  const FacetMesh mesh = our_mesh(model.shape(), options);
  const double measured = measured_distance(model.shape(), mesh, settings.samples);
  const std::optional<MeshVerdict> verdict = verdict_of(model.shape(), mesh, settings);
  std::printf("| %s | %s | %.2f |\n", std::filesystem::path(file).stem().c_str(),
              told(mesh, measured, deflection, our_memory(model.shape(), options), verdict).c_str(),
              measured > 0 ? mesh.proven / measured : 1.0);
  if (settings.faces) print_faces(mesh);
  std::fflush(stdout);
  ++counts.models;
  counts.closed += verdict && verdict->closed;
  counts.without_crossings += verdict && verdict->manifold && verdict->crossings == 0;
  counts.never_above += measured <= mesh.proven + kRoundedGap;
  counts.near += mesh.proven <= kNear * measured + kRoundedGap;
}

std::optional<Settings> settings_from(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? argv[++i] : "0"; };
    if (word == "--part")
      settings.part = std::atof(value());
    else if (word == "--angle")
      settings.angle = std::atof(value());
    else if (word == "--samples")
      settings.samples = std::atoi(value());
    else if (word == "--no-crossings")
      settings.crossings = false;
    else if (word == "--faces")
      settings.faces = true;
    else if (word == "--ours")
      settings.ours = true;
    else
      settings.files.push_back(word);
  }
  if (settings.files.empty() || !(settings.part > 0)) return std::nullopt;
  return settings;
}

int run_all(const Settings& settings) {
  if (settings.ours) {
    std::printf(
        "| model | triangles | measured | proven | s | MB | closed, crossings | proven over "
        "measured |\n"
        "|---|---:|---:|---:|---:|---:|---|---:|\n");
    Counts counts;
    with_threads(1, [&] {
      for (const std::string& file : settings.files) run_ours(file, settings, counts);
    });
    std::printf(
        "\n%d models: %d closed, %d without crossings, %d measured within what is proven, %d "
        "proven "
        "within %.0f times the measured\n",
        counts.models, counts.closed, counts.without_crossings, counts.never_above, counts.near,
        kNear);
    return 0;
  }
  std::printf(
      "| model | BRepMesh: triangles | measured | proven | s | MB | closed, crossings | ours at "
      "the "
      "same "
      "measured: triangles | measured | proven | s | MB | closed, crossings | triangles, ours over "
      "theirs | ours at the same deflection: triangles | measured | proven | s | MB | closed, "
      "crossings "
      "|\n|---|---:|---:|---:|---:|---:|---|---:|---:|---:|---:|---|---:|---:|---:|---:|---:|---:|-"
      "--|\n");
  with_threads(1, [&] {
    for (const std::string& file : settings.files) run(file, settings);
  });
  return 0;
}

}  // namespace
}  // namespace blossom::bench

int main(int argc, char** argv) {
  using namespace blossom::bench;
  return run_command(settings_from(argc, argv),
                     "bench_meshes [--part P] [--angle A] [--samples N] [--no-crossings] [--faces] "
                     "[--ours] FILE...",
                     run_all);
}
