// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/node_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math/binomial.h"

namespace blossom {
namespace {

constexpr int kLowestOrder = 3;        // nodes of the second order are what valleys show
constexpr int kRootSteps = 12;         // of Newton's method: of a form alone the first one is exact
constexpr double kSettledMove = 1e-8;  // of the reach; the next step is its square
constexpr double kOneLine = 1e-12;     // square of the sine between both slopes: 1e-6 radians
constexpr int kHalfTurn = 360;         // directions of a form that are looked at
constexpr int kSpokes = 24;            // on which the gap is compared with it,
constexpr double kAlikeForm = 0.5;     // of the form: it may differ by so much
constexpr int kDiscHalvings = 8;       // of a disc in which it differs by more

// The terms of one degree: sum c_j x^(degree - j) y^j.
struct Form {
  int degree;
  std::array<double, kTaylorDegree + 1> c{};

  Form(const TaylorPolynomial& p, int n) : degree(n) {
    std::copy_n(p.begin() + static_cast<std::ptrdiff_t>(taylor_index(n, 0)), n + 1, c.begin());
  }

  double operator()(double x, double y) const {
    double sum = 0, power = 1;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(degree); ++j) {
      double term = c[j] * power;
      for (int i = degree; i > static_cast<int>(j); --i) term *= x;
      sum += term;
      power *= y;
    }
    return sum;
  }
};

double bombieri(const Form& f, const Form& g) {
  double sum = 0;
  for (int j = 0; j <= f.degree; ++j)
    sum +=
        f.c[static_cast<std::size_t>(j)] * g.c[static_cast<std::size_t>(j)] / binomial(f.degree, j);
  return sum;
}

template <class Visit>
void for_directions(int count, double turn, const Visit& visit) {
  for (int i = 0; i < count; ++i) {
    const double t = turn * i / count;
    visit(std::cos(t), std::sin(t));
  }
}

// So far from the node the valleys between the form's lines stay within tolerance.
double radius_of(const Form& form, double tolerance, double widest) {
  std::array<double, kHalfTurn> values;
  std::size_t i = 0;
  for_directions(kHalfTurn, std::numbers::pi,
                 [&](double x, double y) { values[i++] = std::abs(form(x, y)); });
  double radius = 0;
  for (i = 0; i < kHalfTurn; ++i) {
    const double before = values[(i + kHalfTurn - 1) % kHalfTurn];
    if (values[i] < before || values[i] < values[(i + 1) % kHalfTurn]) continue;
    const double here = std::pow(kDiscGap * tolerance / values[i], 1.0 / form.degree);
    if (here <= widest) radius = std::max(radius, here);
  }
  return radius;
}

// True if the gap is like the form within the radius.
bool follows(const TaylorPolynomial& gap, const Form& form, double radius, double slack) {
  bool alike = true;
  for_directions(kSpokes, 2 * std::numbers::pi, [&](double x, double y) {
    for (const double part : {0.3, 0.6, 1.0}) {
      const double r = part * radius, model = form(r * x, r * y);
      alike = alike &&
              std::abs(value(gap, r * x, r * y) - model) <= slack + kAlikeForm * std::abs(model);
    }
  });
  return alike;
}

// The most that the terms below the form's degree add up to within the radius.
double lower_terms(const TaylorPolynomial& gap, int degree, double radius) {
  double sum = 0, power = 1;
  for (int k = 0; k < degree; ++k, power *= radius) {
    const Form form(gap, k);
    double most = 0;
    for_directions(kSpokes, 2 * std::numbers::pi,
                   [&](double x, double y) { most = std::max(most, std::abs(form(x, y))); });
    sum += most * power;
  }
  return sum;
}

// Where the terms of degree n - 1 vanish.
std::optional<Vec2> root_of(const TaylorPolynomial& gap, int n, double reach) {
  Vec2 at{};
  for (int step = 0; step < kRootSteps; ++step) {
    const TaylorPolynomial here = moved(gap, at);
    const Form form(here, n - 1), by_x(derivative_x(here), n - 1), by_y(derivative_y(here), n - 1);
    const double xx = bombieri(by_x, by_x), xy = bombieri(by_x, by_y), yy = bombieri(by_y, by_y);
    const double x = bombieri(by_x, form), y = bombieri(by_y, form), det = xx * yy - xy * xy;
    if (!(det > kOneLine * xx * yy)) return std::nullopt;
    const Vec2 move{(x * yy - y * xy) / det, (y * xx - x * xy) / det};
    at = at - move;
    if (!(norm(at) <= reach)) return std::nullopt;
    if (norm(move) <= kSettledMove * reach) return at;
  }
  return std::nullopt;
}

}  // namespace

std::optional<NodeForm> node_form(const TaylorPolynomial& gap, double rest, double reach,
                                  double tolerance, double widest) {
  const double slack = kDiscGap * tolerance - rest;
  for (int n = kLowestOrder; n <= kTaylorDegree; ++n) {
    const auto at = root_of(gap, n, reach);
    if (!at) continue;
    const TaylorPolynomial here = moved(gap, *at);
    const Form form(here, n);
    double radius = std::min(radius_of(form, tolerance, widest), reach);
    for (int i = 0; i < kDiscHalvings && !follows(here, form, radius, slack); ++i) radius *= 0.5;
    if (radius > 0 && follows(here, form, radius, slack) &&
        lower_terms(here, n, radius) <= tolerance)
      return NodeForm{*at, n, radius};
  }
  return std::nullopt;
}

}  // namespace blossom
