// SPDX-License-Identifier: LGPL-2.1-or-later
// Curve/curve and curve/surface intersection beside Open CASCADE's, on families whose number of
// common points is known exactly.
//
// Every iteration takes each case of a family once in both, from Open CASCADE's curves in memory to
// points with parameters; conversion counts. Counters: median microseconds of a case in both, the
// median of their ratios, and in how many cases each found too few or too many points.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
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

#include "adapters/occt/curve_queries.h"
#include "adapters/occt/curves.h"
#include "adapters/occt/surfaces.h"
#include "tests/support/curves.h"
#include "tests/support/random.h"
#include "tests/support/sturm.h"

namespace {

using namespace blossom;
using testing::ExactPolynomial;
using testing::Random;
using testing::Rational;

constexpr double kTolerance = 1e-7;
constexpr int kCases = 200;
constexpr Interval kWhole{0, 1};

// Ours and theirs for one case: number of points found.
struct Case {
  std::function<int()> ours;
  std::function<int()> theirs;
  int truth = 0;
};

double microseconds_of(const std::function<int()>& work, int& found) {
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

  void add(int found, int truth) {
    missed += found < truth;
    extra += found > truth;
  }
};

void compare(benchmark::State& state, const std::vector<Case>& cases) {
  std::vector<double> ours, theirs, ratios;
  Tally our_tally, their_tally;
  for (auto _ : state) {
    our_tally = their_tally = {};
    for (const Case& c : cases) {
      int found = 0;
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

Case plane_case(const BezierCurve& a, const BezierCurve& b, int truth) {
  const Handle(Geom2d_Curve) p = in_plane(a), q = in_plane(b);
  return {[=] {
            const auto found =
                intersect(occt::bezier_spans(p, kWhole), occt::bezier_spans(q, kWhole));
            return static_cast<int>(found.points.size());
          },
          [=] { return Geom2dAPI_InterCurveCurve(p, q, kTolerance).NbPoints(); }, truth};
}

Case space_case(const BezierCurve& a, const BezierCurve& b, int truth) {
  const Handle(Geom_Curve) p = in_space(a), q = in_space(b);
  return {[=] {
            const auto found =
                intersect(occt::bezier_spans(p, kWhole), occt::bezier_spans(q, kWhole));
            return static_cast<int>(found.points.size());
          },
          [=] {
            const GeomAPI_ExtremaCurveCurve extrema(p, q);
            int count = 0;
            for (int i = 1; i <= extrema.NbExtrema(); ++i)
              count += extrema.Distance(i) <= kTolerance;
            return count;
          },
          truth};
}

// y over x = 0..1 by its Bernstein coefficients.
BezierCurve graph(const std::vector<double>& y) {
  BezierCurve curve;
  for (std::size_t i = 0; i < y.size(); ++i)
    curve.points.push_back({static_cast<double>(i) / static_cast<double>(y.size() - 1), y[i], 0});
  return curve;
}

struct Planar {
  BezierCurve a, b;
  int truth;
};

std::vector<Planar> random_graphs(int degree) {
  Random random = testing::seeded(degree);
  std::vector<Planar> result;
  while (result.size() < kCases) {
    std::vector<double> f, g;
    std::vector<Rational> difference;
    for (int i = 0; i <= degree; ++i) {
      f.push_back(testing::pick(random, -64, 64) / 32.0);
      g.push_back(testing::pick(random, -64, 64) / 32.0);
      difference.emplace_back(f.back() - g.back());
    }
    if (f.front() == g.front() || f.back() == g.back()) continue;
    result.push_back({graph(f), graph(g), testing::count_roots(testing::powers(difference), 0, 1)});
  }
  return result;
}

// A parabola whose least value over a line at a random place is `gap`; below 0 they cross twice.
std::vector<Planar> parabolas(double gap) {
  Random random = testing::seeded(7);
  std::vector<Planar> result;
  for (int i = 0; i < kCases; ++i) {
    // y = (x - c)^2 + gap over [0, 1]
    const double c = testing::uniform(random, 0.2, 0.8);
    result.push_back({graph({c * c + gap, c * c - c + gap, (1 - c) * (1 - c) + gap}),
                      BezierCurve{{{-0.1, 0, 0}, {1.2, 0, 0}}},
                      gap < 0             ? 2
                      : gap <= kTolerance ? 1
                                          : 0});
  }
  return result;
}

// Cubics with nine crossings, T3(T3(x)) = x, of random size.
std::vector<Planar> nine_crossings() {
  Random random = testing::seeded(9);
  std::vector<Planar> result;
  for (int i = 0; i < kCases; ++i) {
    const double r = testing::uniform(random, 1.01, 1.15);
    const double t = 4 * r * r * r - 3 * r, s = 12 * r * r - 3;
    const std::vector<double> x{-r, -r / 3, r / 3, r};
    const std::vector<double> y{-t, -t + 2 * r * s / 3, t - 2 * r * s / 3, t};
    Planar pair{{}, {}, 9};
    for (std::size_t k = 0; k < 4; ++k) {
      pair.a.points.push_back({x[k], y[k], 0});
      pair.b.points.push_back({y[k], x[k], 0});
    }
    result.push_back(pair);
  }
  return result;
}

void register_planar(const std::string& name, const std::vector<Planar>& pairs) {
  std::vector<Case> plane, space;
  for (const Planar& pair : pairs) {
    plane.push_back(plane_case(pair.a, pair.b, pair.truth));
    space.push_back(space_case(pair.a, pair.b, pair.truth));
  }
  benchmark::RegisterBenchmark(("curves/plane/" + name).c_str(), compare, plane);
  benchmark::RegisterBenchmark(("curves/space/" + name).c_str(), compare, space);
}

ExactPolynomial times(const ExactPolynomial& a, const ExactPolynomial& b) {
  ExactPolynomial p(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) p[i + j] += a[i] * b[j];
  return p;
}

// Bernstein polynomial i of a degree along from + t (to - from).
ExactPolynomial bernstein(int degree, int i, const Rational& from, const Rational& to) {
  const ExactPolynomial x{from, to - from}, rest{1 - from, from - to};
  int binomial = 1;
  for (int k = 0; k < i; ++k) binomial = binomial * (degree - k) / (k + 1);
  ExactPolynomial p{Rational(binomial)};
  for (int k = 0; k < degree; ++k) p = times(p, k < i ? x : rest);
  return p;
}

// Height fields of a degree and cubics over lines of the plane.
Case pierce_case(Random& random, int degree) {
  RationalBezierPatch patch{Grid<Vec4>(degree + 1, degree + 1)};
  double end[4];
  for (double& value : end) value = testing::pick(random, 1, 31) / 32.0;
  std::vector<Rational> heights;
  BezierCurve curve;
  for (int i = 0; i <= 3; ++i) {
    const double z = testing::pick(random, -24, 24) / 8.0;
    heights.emplace_back(z);
    curve.points.push_back(
        {end[0] + (end[2] - end[0]) * i / 3, end[1] + (end[3] - end[1]) * i / 3, z});
  }
  ExactPolynomial difference = testing::powers(heights);
  difference.resize(static_cast<std::size_t>(std::max(4, 2 * degree + 1)));
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j) {
      const double z = testing::pick(random, -32, 32) / 16.0;
      patch.points(i, j) = {static_cast<double>(i) / degree, static_cast<double>(j) / degree, z, 1};
      const ExactPolynomial term = times(bernstein(degree, i, Rational(end[0]), Rational(end[2])),
                                         bernstein(degree, j, Rational(end[1]), Rational(end[3])));
      for (std::size_t k = 0; k < term.size(); ++k) difference[k] -= Rational(z) * term[k];
    }
  const Handle(Geom_Curve) c = occt::to_occt(curve_spans(curve).spans[0].curve);
  const Handle(Geom_Surface) s = occt::to_occt(patch);
  return {[=] {
            const auto found =
                intersect(occt::bezier_spans(c, kWhole), occt::bezier_surface(s, {kWhole, kWhole}));
            return static_cast<int>(found.points.size());
          },
          [=] { return GeomAPI_IntCS(c, s).NbPoints(); }, testing::count_roots(difference, 0, 1)};
}

// A parabola over the middle of a saddle's tangent plane: crossings by depth.
Case graze_case(Random& random, double gap) {
  const double c = testing::uniform(random, 0.3, 0.7);
  RationalBezierPatch patch{Grid<Vec4>(2, 2)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      patch.points(i, j) = {static_cast<double>(i), static_cast<double>(j), 0, 1};
  const BezierCurve curve{
      {{0.1, 0.3, c * c + gap}, {0.5, 0.4, c * c - c + gap}, {0.9, 0.6, (1 - c) * (1 - c) + gap}}};
  const Handle(Geom_Curve) p = occt::to_occt(curve_spans(curve).spans[0].curve);
  const Handle(Geom_Surface) s = occt::to_occt(patch);
  return {[=] {
            const auto found =
                intersect(occt::bezier_spans(p, kWhole), occt::bezier_surface(s, {kWhole, kWhole}));
            return static_cast<int>(found.points.size());
          },
          [=] { return GeomAPI_IntCS(p, s).NbPoints(); }, gap < 0 ? 2 : 1};
}

}  // namespace

int main(int argc, char** argv) {
  for (const int degree : {3, 5, 9})
    register_planar("random_graphs/" + std::to_string(degree), random_graphs(degree));
  register_planar("nine_crossings", nine_crossings());
  for (const double gap : {0.0, -1e-4, -1e-6, -1e-8})
    register_planar("parabolas/" + std::to_string(gap * 1e8), parabolas(gap));
  for (const int degree : {1, 2, 3}) {
    Random random = testing::seeded(degree);
    std::vector<Case> cases;
    for (int i = 0; i < kCases; ++i) cases.push_back(pierce_case(random, degree));
    benchmark::RegisterBenchmark(("curves/surface/random/" + std::to_string(degree)).c_str(),
                                 compare, cases);
  }
  for (const double gap : {0.0, -1e-4, -1e-6, -1e-8}) {
    Random random = testing::seeded(5);
    std::vector<Case> cases;
    for (int i = 0; i < kCases; ++i) cases.push_back(graze_case(random, gap));
    benchmark::RegisterBenchmark(("curves/surface/parabolas/" + std::to_string(gap * 1e8)).c_str(),
                                 compare, cases);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
