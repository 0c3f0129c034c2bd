// SPDX-License-Identifier: LGPL-2.1-or-later
// SISL on the curve families of bench_curves; nothing of Blossom is in this program.
//
//   bench_curves --write families.jsonl
//   bench_curves --benchmark_out=ours.json
//   sisl_curves families.jsonl ours.json
//
// Prints, for each family, the median microseconds of both, how many times faster Blossom is, and
// in how many cases SISL found too few and too many points or runs. The resolution is 1e-7, that of
// Blossom.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <sisl.h>
#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::json;

constexpr double kResolution = 1e-7;

struct Free {
  void operator()(SISLCurve* curve) const { freeCurve(curve); }
  void operator()(SISLSurf* surface) const { freeSurf(surface); }
};
using Curve = std::unique_ptr<SISLCurve, Free>;
using Surface = std::unique_ptr<SISLSurf, Free>;

std::vector<double> bezier_knots(std::size_t order) {
  std::vector<double> knots(order, 0);
  knots.insert(knots.end(), order, 1);
  return knots;
}

Curve curve_of(const Json& points, int dimension) {
  std::vector<double> coordinates;
  for (const Json& p : points)
    for (int k = 0; k < dimension; ++k)
      coordinates.push_back(p[static_cast<std::size_t>(k)].get<double>());
  const int order = static_cast<int>(points.size());
  std::vector<double> knots = bezier_knots(points.size());
  return Curve(newCurve(order, order, knots.data(), coordinates.data(), 1, dimension, 1));
}

// SISL wants u fastest.
Surface surface_of(const Json& points, std::size_t rows) {
  const std::size_t columns = points.size() / rows;
  std::vector<double> coordinates;
  for (std::size_t j = 0; j < columns; ++j)
    for (std::size_t i = 0; i < rows; ++i)
      for (const Json& x : points[i * columns + j]) coordinates.push_back(x.get<double>());
  std::vector<double> u = bezier_knots(rows), v = bezier_knots(columns);
  const int n = static_cast<int>(rows), m = static_cast<int>(columns);
  return Surface(newSurf(n, m, n, m, u.data(), v.data(), coordinates.data(), 1, 3, 1));
}

struct Answer {
  double microseconds = 0;
  int points = 0, runs = 0;
};

template <class Intersect>
Answer timed(const Intersect& intersect) {
  int points = 0, curves = 0, status = 0;
  double *at_a = nullptr, *at_b = nullptr;
  SISLIntcurve** found = nullptr;
  const auto start = std::chrono::steady_clock::now();
  intersect(&points, &at_a, &at_b, &curves, &found, &status);
  const auto stop = std::chrono::steady_clock::now();
  free(at_a);
  free(at_b);
  if (found) freeIntcrvlist(found, curves);
  return {std::chrono::duration<double, std::micro>(stop - start).count(), status < 0 ? 0 : points,
          status < 0 ? 0 : curves};
}

Answer solved(const Json& entry, int dimension) {
  const Curve a = curve_of(entry["a"], dimension);
  if (const std::size_t rows = entry["rows"]; rows > 0) {
    const Surface surface = surface_of(entry["surface"], rows);
    return timed([&](auto... out) { s1858(surface.get(), a.get(), 0, kResolution, out...); });
  }
  const Curve b = curve_of(entry["b"], dimension);
  return timed([&](auto... out) { s1857(a.get(), b.get(), 0, kResolution, out...); });
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void print_family(const Json& family, const std::string& where, int dimension,
                  const std::map<std::string, double>& ours) {
  const std::string name = "curves/" + where + "/" + family["name"].get<std::string>();
  std::vector<double> microseconds;
  int few = 0, many = 0;
  for (const Json& entry : family["cases"]) {
    const Answer answer = solved(entry, dimension);
    microseconds.push_back(answer.microseconds);
    const int points = entry["truth"], runs = entry["runs"];
    const bool too_few = answer.points < points || answer.runs < runs;
    few += too_few;
    many += !too_few && (answer.points > points || answer.runs > runs);
  }
  const double theirs = median(microseconds), us = ours.count(name) ? ours.at(name) : 0;
  std::printf("%-40s %9.1f %9.1f %8.1f %6d %6d\n", name.c_str(), us, theirs, theirs / us, few,
              many);
}

// The counter blossom_us by the name of the benchmark.
std::map<std::string, double> times_in(const std::string& file) {
  std::map<std::string, double> times;
  std::ifstream in(file);
  const Json report = Json::parse(in);
  for (const Json& row : report["benchmarks"]) times[row["name"]] = row["blossom_us"];
  return times;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: sisl_curves FAMILIES.jsonl BENCHMARK.json\n");
    return 2;
  }
  const std::map<std::string, double> ours = times_in(argv[2]);
  std::printf("%-40s %9s %9s %8s %6s %6s\n", "family", "ours us", "sisl us", "ratio", "few",
              "many");
  std::ifstream in(argv[1]);
  for (std::string line; std::getline(in, line);) {
    const Json family = Json::parse(line);
    if (family["with_surface"]) {
      print_family(family, "surface", 3, ours);
    } else {
      print_family(family, "plane", 2, ours);
      print_family(family, "space", 3, ours);
    }
  }
}
