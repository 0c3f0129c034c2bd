// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/bench/curves_families.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tests/support/random.h"
#include "tests/support/sturm.h"

namespace blossom::bench {
namespace {

using testing::ExactPolynomial;
using testing::Random;
using testing::Rational;

constexpr std::array kGaps{0.0, -1e-4, -1e-6, -1e-8};

std::vector<CurveCase> random_graphs(int degree, int cases) {
  Random random = testing::seeded(degree);
  std::vector<CurveCase> result;
  while (static_cast<int>(result.size()) < cases) {
    std::vector<double> f, g;
    std::vector<Rational> difference;
    for (int i = 0; i <= degree; ++i) {
      f.push_back(testing::pick(random, -64, 64) / 32.0);
      g.push_back(testing::pick(random, -64, 64) / 32.0);
      difference.emplace_back(f.back() - g.back());
    }
    if (f.front() == g.front() || f.back() == g.back()) continue;
    result.push_back(
        {graph(f), graph(g), {}, testing::count_roots(testing::powers(difference), 0, 1)});
  }
  return result;
}

// A parabola whose least value over a line at a random place is `gap`: 0 for a touch, below it they
// cross twice.
std::vector<CurveCase> parabolas(double gap, int cases) {
  Random random = testing::seeded(7);
  std::vector<CurveCase> result;
  for (int i = 0; i < cases; ++i) {
    // y = (x - c)^2 + gap over [0, 1]
    const double c = testing::uniform(random, 0.2, 0.8);
    result.push_back({graph({c * c + gap, c * c - c + gap, (1 - c) * (1 - c) + gap}),
                      BezierCurve{{{-0.1, 0, 0}, {1.2, 0, 0}}},
                      {},
                      gap < 0 ? 2 : 1});
  }
  return result;
}

// Cubics with nine crossings, T3(T3(x)) = x, of random size.
std::vector<CurveCase> nine_crossings(int cases) {
  Random random = testing::seeded(9);
  std::vector<CurveCase> result;
  for (int i = 0; i < cases; ++i) {
    const double r = testing::uniform(random, 1.01, 1.15);
    const double t = 4 * r * r * r - 3 * r, s = 12 * r * r - 3;
    const std::vector<double> x{-r, -r / 3, r / 3, r};
    const std::vector<double> y{-t, -t + 2 * r * s / 3, t - 2 * r * s / 3, t};
    CurveCase pair{{}, {}, {}, 9};
    for (std::size_t k = 0; k < 4; ++k) {
      pair.a.points.push_back({x[k], y[k], 0});
      pair.b.points.push_back({y[k], x[k], 0});
    }
    result.push_back(pair);
  }
  return result;
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
CurveCase pierce_case(Random& random, int degree) {
  CurveCase result;
  result.surface = Grid<Vec3>(degree + 1, degree + 1);
  double end[4];
  for (double& value : end) value = testing::pick(random, 1, 31) / 32.0;
  std::vector<Rational> heights;
  for (int i = 0; i <= 3; ++i) {
    const double z = testing::pick(random, -24, 24) / 8.0;
    heights.emplace_back(z);
    result.a.points.push_back(
        {end[0] + (end[2] - end[0]) * i / 3, end[1] + (end[3] - end[1]) * i / 3, z});
  }
  ExactPolynomial difference = testing::powers(heights);
  difference.resize(static_cast<std::size_t>(std::max(4, 2 * degree + 1)));
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j) {
      const double z = testing::pick(random, -32, 32) / 16.0;
      result.surface(i, j) = {static_cast<double>(i) / degree, static_cast<double>(j) / degree, z};
      const ExactPolynomial term = times(bernstein(degree, i, Rational(end[0]), Rational(end[2])),
                                         bernstein(degree, j, Rational(end[1]), Rational(end[3])));
      for (std::size_t k = 0; k < term.size(); ++k) difference[k] -= Rational(z) * term[k];
    }
  result.truth = testing::count_roots(difference, 0, 1);
  return result;
}

// A parabola over the unit square: crossings by depth.
CurveCase graze_case(Random& random, double gap) {
  const double c = testing::uniform(random, 0.3, 0.7);
  CurveCase result;
  result.surface = Grid<Vec3>(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      result.surface(i, j) = {static_cast<double>(i), static_cast<double>(j), 0};
  result.a.points = {
      {0.1, 0.3, c * c + gap}, {0.5, 0.4, c * c - c + gap}, {0.9, 0.6, (1 - c) * (1 - c) + gap}};
  result.truth = gap < 0 ? 2 : 1;
  return result;
}

template <class Make>
std::vector<CurveCase> cases_of(int seed, int cases, const Make& make) {
  Random random = testing::seeded(seed);
  std::vector<CurveCase> result;
  for (int i = 0; i < cases; ++i) result.push_back(make(random));
  return result;
}

}  // namespace

BezierCurve graph(const std::vector<double>& y) {
  BezierCurve curve;
  for (std::size_t i = 0; i < y.size(); ++i)
    curve.points.push_back({static_cast<double>(i) / static_cast<double>(y.size() - 1), y[i], 0});
  return curve;
}

std::vector<CurveFamily> curve_families(int cases) {
  std::vector<CurveFamily> families;
  for (const int degree : {3, 5, 9})
    families.push_back(
        {"random_graphs/" + std::to_string(degree), false, random_graphs(degree, cases)});
  families.push_back({"nine_crossings", false, nine_crossings(cases)});
  for (const double gap : kGaps)
    families.push_back({"parabolas/" + std::to_string(gap * 1e8), false, parabolas(gap, cases)});
  for (CurveFamily& family : contact_families(cases)) families.push_back(std::move(family));
  for (const int degree : {1, 2, 3})
    families.push_back(
        {"random/" + std::to_string(degree), true,
         cases_of(degree, cases, [&](Random& r) { return pierce_case(r, degree); })});
  for (const double gap : kGaps)
    families.push_back({"parabolas/" + std::to_string(gap * 1e8), true,
                        cases_of(5, cases, [&](Random& r) { return graze_case(r, gap); })});
  return families;
}

}  // namespace blossom::bench
