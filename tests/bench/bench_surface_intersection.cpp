// SPDX-License-Identifier: LGPL-2.1-or-later
// Surface/surface intersection beside Open CASCADE's GeomAPI_IntSS, on pairs of bicubic patches
// whose intersection is known.
//
// Every iteration does one of each, from two faces (surfaces) in memory to finished Open CASCADE
// curves. Counters: milliseconds of both, their ratio, and the number of curves each returns.
//
//   bench_surface_intersection --write FOLDER    the pairs as cases for the programs in `peers`

#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <GeomAPI_IntSS.hxx>
#include <Geom_BezierSurface.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/intersection.h"
#include "tests/support/cubic_family.h"

namespace {

using namespace blossom;
using testing::Cubic;
using testing::linear;

constexpr double kTolerance = 1e-7;

double milliseconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

struct Row {
  std::string name;
  Cubic h;  // the pair meets where it vanishes
};

std::vector<Row> rows() {
  const Cubic x = linear(-0.43, 1, 0), y = linear(-0.57, 0, 1), middle = linear(-0.5, 0, 1);
  const Cubic line = linear(-0.6, 1, 0.2);
  std::vector<Row> all{
      {"transversal", linear(-0.5, 1, 0) + 0.3 * middle + 0.4 * (middle * middle)}};
  for (const char* r : {"0.2", "0.1", "0.05", "0.02", "0.01", "0.005", "0.001"})
    all.push_back({std::string("loop_") + r, testing::loop(0.43, 0.57, std::stod(r))});
  all.push_back({"touch", testing::loop(0.43, 0.57, 0)});
  all.push_back({"tangent_curve", line * line});
  for (const char* e : {"1e-2", "1e-3", "1e-4"})
    all.push_back({std::string("near_tangent_") + e,
                   line * line + testing::constant(-std::stod(e) * std::stod(e))});
  all.push_back({"crossing", x * y});
  for (const char* d : {"1e-3", "1e-5"})
    all.push_back({std::string("near_crossing_") + d, x * y + testing::constant(-std::stod(d))});
  all.push_back({"node", y * y + -1.0 * (x * x * linear(-0.13, 1, 0))});
  all.push_back({"cusp", y * y + -1.0 * (x * x * x)});
  all.push_back({"acnode", testing::oval(0.3, 0.3, 0.6)});
  all.push_back({"oval_and_branch", testing::oval(0.2, 0.4, 0.7)});
  all.push_back({"small_oval_and_branch", testing::oval(0.3, 0.33, 0.7)});
  all.push_back({"overlap", testing::constant(0)});
  all.push_back({"near_disjoint", testing::loop(0.43, 0.57, 0) + testing::constant(1e-6)});
  return all;
}

int write(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream list(folder / "cases.jsonl");
  for (const Row& row : rows()) {
    const testing::CubicPair pair = testing::cubic_pair(row.h);
    const auto save = [&](const BezierSurface& surface, const std::string& name) {
      const TopoDS_Face face =
          BRepBuilderAPI_MakeFace(occt::to_occt(surface.patches(0, 0)), kTolerance);
      BRepTools::Write(face, (folder / name).c_str());
      return name;
    };
    list << nlohmann::json{{"name", row.name},
                           {"a", save(pair.a, row.name + ".a.brep")},
                           {"b", save(pair.b, row.name + ".b.brep")},
                           {"size", 2},
                           {"tolerance", kTolerance}}
         << "\n";
  }
  return list ? 0 : 1;
}

void compare(benchmark::State& state, const Cubic& h) {
  const testing::CubicPair pair = testing::cubic_pair(h);
  const Handle(Geom_BezierSurface) a = occt::to_occt(pair.a.patches(0, 0));
  const Handle(Geom_BezierSurface) b = occt::to_occt(pair.b.patches(0, 0));
  const std::vector<TopoDS_Face> face_a{BRepBuilderAPI_MakeFace(a, kTolerance)};
  const std::vector<TopoDS_Face> face_b{BRepBuilderAPI_MakeFace(b, kTolerance)};
  double ours = 0, theirs = 0;
  std::size_t our_curves = 0;
  int their_curves = 0;
  for (auto _ : state) {
    ours += milliseconds_of([&] {
      const auto found = occt::intersect(face_a, face_b);
      our_curves = found.pairs.empty() ? 0 : found.pairs.front().edges.size();
    });
    theirs += milliseconds_of([&] {
      const GeomAPI_IntSS found(a, b, kTolerance);
      their_curves = found.NbLines();
    });
  }
  const auto rounds = static_cast<double>(state.iterations());
  state.counters["blossom_ms"] = ours / rounds;
  state.counters["occt_ms"] = theirs / rounds;
  state.counters["times_faster"] = theirs / ours;
  state.counters["blossom_curves"] = static_cast<double>(our_curves);
  state.counters["occt_curves"] = their_curves;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "--write") return write(argv[2]);
  for (const Row& row : rows())
    benchmark::RegisterBenchmark(("surface_intersection/" + row.name).c_str(), compare, row.h);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
