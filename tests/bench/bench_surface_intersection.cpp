// SPDX-License-Identifier: LGPL-2.1-or-later
// Surface/surface intersection beside Open CASCADE's GeomAPI_IntSS, on pairs of bicubic patches
// whose intersection is known.
//
// Every iteration does one of each, from two faces (surfaces) in memory to finished Open CASCADE
// curves. Counters: milliseconds of both, their ratio, and the number of curves each returns.

#include <benchmark/benchmark.h>

#include <chrono>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <GeomAPI_IntSS.hxx>
#include <Geom_BezierSurface.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/intersection.h"
#include "adapters/occt/surfaces.h"
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
  const Cubic y = linear(-0.5, 0, 1);
  benchmark::RegisterBenchmark("surface_intersection/transversal", compare,
                               linear(-0.5, 1, 0) + 0.3 * y + 0.4 * (y * y));
  for (const double r : {0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.001})
    benchmark::RegisterBenchmark(("surface_intersection/loop/" + std::to_string(r)).c_str(),
                                 compare, testing::loop(0.43, 0.57, r));
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
