// SPDX-License-Identifier: LGPL-2.1-or-later
// Curve/curve and curve/surface intersection beside Open CASCADE's, on families whose number of
// common points and runs is known exactly.
//
//   bench_curves [--cases N] [--write FILE] [Google Benchmark's options]
//
// `--cases` says how many cases a family has, 200 unless given; `--write` only writes the families
// to a file, for other programs.
//
// Every iteration takes each case of a family once in both, from Open CASCADE's curves in memory to
// points with parameters; conversion counts. Counters: median microseconds of a case in both, the
// median of their ratios, and in how many cases each found too few or too many points or runs.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI.hxx>
#include <GeomAPI_ExtremaCurveCurve.hxx>
#include <GeomAPI_IntCS.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <gp.hxx>
#include <gp_Pln.hxx>
#include <nlohmann/json.hpp>

#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/curve_intersection.h"
#include "core/curve_surface_intersection.h"
#include "tests/bench/curves_families.h"
#include "tests/support/curves.h"

namespace {

using namespace blossom;
using bench::CurveCase;
using bench::CurveFamily;

constexpr double kTolerance = 1e-7;
constexpr Interval kWhole{0, 1};

struct Answer {
  int points = 0;
  int runs = 0;
};

// Ours and theirs for one case.
struct Case {
  std::function<Answer()> ours;
  std::function<Answer()> theirs;
  Answer truth;
};

double microseconds_of(const std::function<Answer()>& work, Answer& found) {
  const auto start = std::chrono::steady_clock::now();
  found = work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
      .count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

struct Tally {
  int missed = 0, extra = 0;

  void add(const Answer& found, const Answer& truth) {
    const bool few = found.points < truth.points || found.runs < truth.runs;
    missed += few;
    extra += !few && (found.points > truth.points || found.runs > truth.runs);
  }
};

void compare(benchmark::State& state, const std::vector<Case>& cases) {
  std::vector<double> ours, theirs, ratios;
  Tally our_tally, their_tally;
  for (auto _ : state) {
    our_tally = their_tally = {};
    for (const Case& c : cases) {
      Answer found;
      ours.push_back(microseconds_of(c.ours, found));
      our_tally.add(found, c.truth);
      theirs.push_back(microseconds_of(c.theirs, found));
      their_tally.add(found, c.truth);
      ratios.push_back(theirs.back() / ours.back());
    }
  }
  state.counters["blossom_us"] = median(ours);
  state.counters["occt_us"] = median(theirs);
  state.counters["times_faster"] = median(ratios);
  state.counters["cases"] = static_cast<double>(cases.size());
  state.counters["blossom_missed"] = our_tally.missed;
  state.counters["blossom_extra"] = our_tally.extra;
  state.counters["occt_missed"] = their_tally.missed;
  state.counters["occt_extra"] = their_tally.extra;
}

Handle(Geom_BezierCurve) in_space(const BezierCurve& curve) {
  return occt::to_occt(testing::in_space(curve_spans(curve)).spans[0].curve);
}

Handle(Geom2d_Curve) in_plane(const BezierCurve& curve) {
  TColgp_Array1OfPnt2d poles(1, curve.degree() + 1);
  for (int i = 0; i <= curve.degree(); ++i) {
    const Vec3& p = curve.points[static_cast<std::size_t>(i)];
    poles(i + 1) = gp_Pnt2d(p[0], p[1]);
  }
  return new Geom2d_BezierCurve(poles);
}

Answer counted(const CurveIntersection& found) {
  return {static_cast<int>(found.points.size()), static_cast<int>(found.overlaps.size())};
}

Case plane_case(const CurveCase& c) {
  const Handle(Geom2d_Curve) p = in_plane(c.a), q = in_plane(c.b);
  return {[=] {
            return counted(intersect(occt::bezier_spans(p, kWhole), occt::bezier_spans(q, kWhole)));
          },
          [=] {
            const Geom2dAPI_InterCurveCurve found(p, q, kTolerance);
            return Answer{found.NbPoints(), found.NbSegments()};
          },
          {c.truth, c.runs}};
}

Case space_case(const CurveCase& c) {
  const Handle(Geom_Curve) p = in_space(c.a), q = in_space(c.b);
  return {[=] {
            return counted(intersect(occt::bezier_spans(p, kWhole), occt::bezier_spans(q, kWhole)));
          },
          [=] {
            const GeomAPI_ExtremaCurveCurve extrema(p, q);
            if (extrema.IsParallel()) return Answer{0, extrema.Distance(1) <= kTolerance};
            Answer found;
            for (int i = 1; i <= extrema.NbExtrema(); ++i)
              found.points += extrema.Distance(i) <= kTolerance;
            return found;
          },
          {c.truth, c.runs}};
}

Case surface_case(const CurveCase& test) {
  const Grid<Vec3>& points = test.surface;
  RationalBezierPatch patch{Grid<Vec4>(points.rows(), points.columns())};
  for (int i = 0; i < points.rows(); ++i)
    for (int j = 0; j < points.columns(); ++j) {
      const Vec3& p = points(i, j);
      patch.points(i, j) = {p[0], p[1], p[2], 1};
    }
  const Handle(Geom_Curve) c = occt::to_occt(curve_spans(test.a).spans[0].curve);
  const Handle(Geom_Surface) s = occt::to_occt(patch);
  return {[=] {
            const auto found =
                intersect(occt::bezier_spans(c, kWhole), occt::bezier_surface(s, {kWhole, kWhole}));
            return Answer{static_cast<int>(found.points.size()), 0};
          },
          [=] {
            return Answer{GeomAPI_IntCS(c, s).NbPoints(), 0};
          },
          {test.truth, 0}};
}

void register_family(const CurveFamily& family) {
  const auto add = [&](const char* where, const auto& make) {
    std::vector<Case> cases;
    for (const CurveCase& c : family.cases) cases.push_back(make(c));
    const std::string name = std::string("curves/") + where + "/" + family.name;
    benchmark::RegisterBenchmark(name.c_str(), compare, cases);
  };
  if (family.with_surface) return add("surface", surface_case);
  add("plane", plane_case);
  add("space", space_case);
}

nlohmann::json points_of(std::span<const Vec3> list) {
  nlohmann::json points = nlohmann::json::array();
  for (const Vec3& p : list) points.push_back({p[0], p[1], p[2]});
  return points;
}

// One family a line: {name, with_surface, cases: [{a, b, surface, rows, truth, runs}]}; the points
// of a surface row by row.
void write_families(const std::string& file, int cases) {
  std::ofstream out(file);
  for (const CurveFamily& family : bench::curve_families(cases)) {
    nlohmann::json line = {{"name", family.name}, {"with_surface", family.with_surface}};
    for (const CurveCase& c : family.cases)
      line["cases"].push_back({{"a", points_of(c.a.points)},
                               {"b", points_of(c.b.points)},
                               {"surface", points_of(c.surface.values())},
                               {"rows", c.surface.rows()},
                               {"truth", c.truth},
                               {"runs", c.runs}});
    out << line << "\n";
  }
}

}  // namespace

int main(int argc, char** argv) {
  int cases = 200;
  if (argc >= 3 && std::string(argv[1]) == "--cases") {
    cases = std::max(1, std::atoi(argv[2]));
    argv[2] = argv[0];
    argv += 2;
    argc -= 2;
  }
  if (argc == 3 && std::string(argv[1]) == "--write") {
    write_families(argv[2], cases);
    return 0;
  }
  for (const CurveFamily& family : bench::curve_families(cases)) register_family(family);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
