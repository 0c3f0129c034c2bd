// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves that touch, that have a part in common, and cusps. Coordinates have few binary digits, so
// that the contacts are exact.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/forms/algebra/degree.h"
#include "core/math/binomial.h"
#include "core/subdivision/curve_subdivision.h"
#include "tests/bench/curves_families.h"
#include "tests/support/random.h"
#include "tests/support/sturm.h"

namespace blossom::bench {
namespace {

using testing::ExactPolynomial;
using testing::pick;
using testing::Random;
using testing::Rational;

using Coefficients = std::vector<double>;

// The product of two Bernstein forms times a number that makes its coefficients whole multiples.
Coefficients product(const Coefficients& a, const Coefficients& b, double factor) {
  const int n = static_cast<int>(a.size()) - 1, m = static_cast<int>(b.size()) - 1;
  Coefficients result(a.size() + b.size() - 1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j)
      result[static_cast<std::size_t>(i + j)] += binomial(n, i) * binomial(m, j) *
                                                 a[static_cast<std::size_t>(i)] *
                                                 b[static_cast<std::size_t>(j)];
  for (int k = 0; k <= n + m; ++k)
    result[static_cast<std::size_t>(k)] *= factor / binomial(n + m, k);
  return result;
}

// (x - c)^order
Coefficients power(double c, int order) {
  Coefficients result;
  for (int i = 0; i <= order; ++i) {
    double value = 1;
    for (int k = 0; k < order; ++k) value *= k < i ? 1 - c : -c;
    result.push_back(value);
  }
  return result;
}

// Two graphs of degree order + 2 with a contact of an order and up to two crossings, all apart:
// their difference is k (x - c)^order (x - p) (x - q).
CurveCase touch_case(Random& random, int order) {
  const double c = pick(random, 4, 12) / 16.0;
  std::array<double, 2> crossing{};
  for (double& x : crossing) do {
      x = pick(random, -16, 32) / 16.0 + 1 / 32.0;
    } while (std::abs(x - c) < 0.2 || (&x != crossing.data() && std::abs(x - crossing[0]) < 0.1));
  constexpr std::array kWhole{3.0, 5.0, 15.0};  // least common multiples of binom(order + 2, .)
  const Coefficients difference =
      product(power(c, order), product(power(crossing[0], 1), power(crossing[1], 1), 2),
              kWhole[static_cast<std::size_t>(order - 2)]);
  Coefficients f, g;
  for (const double d : difference) {
    f.push_back(pick(random, -32, 32) / 32.0);
    g.push_back(f.back() + d);
  }
  const auto inside = [](double x) { return x > 0 && x < 1; };
  return {graph(f), graph(g), {}, 1 + inside(crossing[0]) + inside(crossing[1])};
}

// Two pieces of one graph, perhaps reversed and of a higher degree.
CurveCase shared_case(Random& random, int degree) {
  Coefficients y;
  for (int i = 0; i <= degree; ++i) y.push_back(pick(random, -32, 32) / 16.0);
  const BezierCurve whole = graph(y);
  std::array<int, 4> cut{};
  do {
    for (int& x : cut) x = pick(random, 0, 16);
    if (cut[0] > cut[1]) std::swap(cut[0], cut[1]);
    if (cut[2] > cut[3]) std::swap(cut[2], cut[3]);
  } while (cut[0] == cut[1] || cut[2] == cut[3]);
  CurveCase result{sub_curve(whole, {cut[0] / 16.0, cut[1] / 16.0}),
                   sub_curve(whole, {cut[2] / 16.0, cut[3] / 16.0}),
                   {}};
  const int common = std::min(cut[1], cut[3]) - std::max(cut[0], cut[2]);
  result.truth = common == 0;
  result.runs = common > 0;
  if (pick(random, 0, 1)) std::reverse(result.b.points.begin(), result.b.points.end());
  if (pick(random, 0, 1)) result.b = elevated(result.b, degree + pick(random, 1, 2));
  return result;
}

ExactPolynomial exact(const Coefficients& bernstein) {
  return testing::powers({bernstein.begin(), bernstein.end()});
}

ExactPolynomial sum(const ExactPolynomial& p, const Rational& s, const ExactPolynomial& q,
                    const Rational& t) {
  ExactPolynomial result(std::max(p.size(), q.size()));
  for (std::size_t i = 0; i < p.size(); ++i) result[i] += s * p[i];
  for (std::size_t i = 0; i < q.size(); ++i) result[i] += t * q[i];
  return result;
}

ExactPolynomial square(const ExactPolynomial& p) {
  ExactPolynomial result(2 * p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < p.size(); ++j) result[i + j] += p[i] * p[j];
  return result;
}

// A cubic with a cusp, 3 (t - c)^2 and (t - c)^3 sheared, and the parabola or line
// y = slope x + bend x^2 + off, which meets the cusp if off is 0.
CurveCase cusp_case(Random& random, bool straight, double off) {
  const double c = pick(random, 4, 12) / 16.0;
  Coefficients x = product(power(c, 2), {1, 1}, 3), y = power(c, 3);
  const double shear = pick(random, -3, 3);
  for (std::size_t i = 0; i < 4; ++i) y[i] += shear * x[i];
  double slope = 0;
  do slope = pick(random, -24, 24) / 4.0;
  while (slope == shear && off != 0);  // a line along the cusp's tangent beside it
  const double bend = straight ? 0 : pick(random, -4, 4) / 4.0;
  CurveCase result;
  for (std::size_t i = 0; i < 4; ++i) result.a.points.push_back({x[i], y[i], 0});
  // Over x in [-4, 4], which holds the cubic.
  const double left = -4 * slope + 16 * bend + off, right = 4 * slope + 16 * bend + off;
  if (straight)
    result.b.points = {{-4, left, 0}, {4, right, 0}};
  else
    result.b.points = {{-4, left, 0}, {0, off - 16 * bend, 0}, {4, right, 0}};
  ExactPolynomial rest = sum(exact(y), 1, exact(x), -Rational(slope));
  rest = sum(rest, 1, square(exact(x)), -Rational(bend));
  rest[0] -= Rational(off);
  result.truth = testing::count_roots(rest, 0, 1) + (testing::value(rest, 0) == 0);
  return result;
}

template <class Make>
CurveFamily family(const std::string& name, int seed, int cases, const Make& make) {
  Random random = testing::seeded(seed);
  CurveFamily result{name, false, {}};
  for (int i = 0; i < cases; ++i) result.cases.push_back(make(random));
  return result;
}

}  // namespace

std::vector<CurveFamily> contact_families(int cases) {
  std::vector<CurveFamily> families;
  for (const int order : {2, 3, 4})
    families.push_back(family("tangent/" + std::to_string(order), order, cases,
                              [&](Random& r) { return touch_case(r, order); }));
  for (const int degree : {1, 3, 5})
    families.push_back(family("overlap/" + std::to_string(degree), degree, cases,
                              [&](Random& r) { return shared_case(r, degree); }));
  for (const bool straight : {true, false})
    families.push_back(family(straight ? "cusp/line" : "cusp/parabola", 3, cases, [&](Random& r) {
      constexpr std::array kOff{0.0, 0x1p-13, -0x1p-13, 0x1p-19, -0x1p-19};
      return cusp_case(r, straight, kOff[static_cast<std::size_t>(pick(r, 0, 4))]);
    }));
  return families;
}

}  // namespace blossom::bench
