// SPDX-License-Identifier: GPL-3.0-or-later
// Models as triangles, beside BRepMesh_IncrementalMesh.
//
//   bench_meshes [--part P] [--angle A] [--samples N] [--no-crossings] [--faces] [--ours] FILE...
//
// A row for each model: Open CASCADE's mesh at a deflection of P of the diagonal, and ours at the
// deviation at which the measured distance is about the same: triangles, measured and proven
// distance over the deflection, processor seconds, whether it is closed, and pairs of triangles
// that cross, by CGAL. Distances are measured both ways at N samples (meshes_measure.h). The last
// columns have ours at the deflection itself. --ours has these alone. --faces lists faces of many
// triangles and of large distances.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

#include "adapters/cgal/gpl/mesh_check.h"
#include "core/base/parallel.h"
#include "tests/bench/command_line.h"
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

std::string told(const FacetMesh& mesh, double measured, double deflection,
                 const Settings& settings) {
  std::array<char, 200> text{};
  const cgal::MeshCheck check =
      settings.crossings ? cgal::check_mesh(mesh.points, mesh.triangles) : cgal::MeshCheck{};
  std::snprintf(text.data(), text.size(), "%zu | %.2f | %.2f | %.3f | %s, %d",
                mesh.triangles.size(), measured / deflection, mesh.proven / deflection,
                mesh.seconds,
                !settings.crossings ? "?"
                : check.closed      ? "closed"
                : check.manifold    ? "open"
                                    : "no manifold",
                check.self_intersections);
  std::string all = text.data();
  if (mesh.refused > 0) all += ", " + std::to_string(mesh.refused) + " refused";
  if (mesh.folded > 0) all += ", " + std::to_string(mesh.folded) + " folded";
  return all;
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
  std::printf("| %s | %s | %s | %.2f | %s |\n", std::filesystem::path(file).stem().c_str(),
              told(theirs, measured, deflection, settings).c_str(),
              told(equal, of_equal, deflection, settings).c_str(),
              static_cast<double>(equal.triangles.size()) /
                  static_cast<double>(std::max<std::size_t>(1, theirs.triangles.size())),
              told(same, of_same, deflection, settings).c_str());
  if (settings.faces) print_faces(same);
  std::fflush(stdout);
}

// Ours alone, at the deflection.
void run_ours(const std::string& file, const Settings& settings) {
  const occt::Model model = testing::repaired_model(file);
  const double deflection = settings.part * diagonal_of(model.shape());
  const FacetMesh mesh =
      our_mesh(model.shape(), {.deviation = deflection, .angle = settings.angle});
  const double measured = measured_distance(model.shape(), mesh, settings.samples);
  std::printf("| %s | %s | %.2f |\n", std::filesystem::path(file).stem().c_str(),
              told(mesh, measured, deflection, settings).c_str(),
              measured > 0 ? mesh.proven / measured : 1.0);
  std::fflush(stdout);
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
        "| model | triangles | measured | proven | s | closed, crossings | proven over measured |\n"
        "|---|---:|---:|---:|---:|---|---:|\n");
    with_threads(1, [&] {
      for (const std::string& file : settings.files) run_ours(file, settings);
    });
    return 0;
  }
  std::printf(
      "| model | BRepMesh: triangles | measured | proven | s | closed, crossings | ours at the "
      "same "
      "measured: triangles | measured | proven | s | closed, crossings | triangles, ours over "
      "theirs | ours at the same deflection: triangles | measured | proven | s | closed, crossings "
      "|\n|---|---:|---:|---:|---:|---|---:|---:|---:|---:|---|---:|---:|---:|---:|---:|---|\n");
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
