// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/local_form.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/math/binomial.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

constexpr double kLargestTurn = 1.2;  // tan is bounded on discs of this radius
constexpr int kMinDegree = 5;

// Chebyshev's nodes in [0, 1] of the degree, and the matrix from values there to Bezier points.
struct Interpolation {
  std::vector<double> nodes;
  std::vector<std::vector<double>> matrix;
  double norm = 0;
};

Interpolation interpolation(int degree) {
  const auto n = static_cast<std::size_t>(degree) + 1;
  Interpolation result{{}, std::vector<std::vector<double>>(n, std::vector<double>(n)), 0};
  std::vector<std::vector<long double>> m(n, std::vector<long double>(2 * n));
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 0.5 - 0.5 * std::cos((static_cast<double>(i) + 0.5) * std::numbers::pi /
                                          static_cast<double>(n));
    result.nodes.push_back(t);
    for (std::size_t j = 0; j < n; ++j)
      m[i][j] = static_cast<long double>(binomial(degree, static_cast<int>(j))) *
                std::pow(static_cast<long double>(t), static_cast<long double>(j)) *
                std::pow(1 - static_cast<long double>(t), static_cast<long double>(n - 1 - j));
    m[i][n + i] = 1;
  }
  // Gauss and Jordan's elimination; the nodes' order keeps the pivots large.
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    std::swap(m[k], m[pivot]);
    const long double scale = 1 / m[k][k];
    for (long double& x : m[k]) x *= scale;
    for (std::size_t i = 0; i < n; ++i) {
      const long double factor = i == k ? 0 : m[i][k];
      for (std::size_t j = 0; j < 2 * n; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    double row = 0;
    for (std::size_t j = 0; j < n; ++j) {
      result.matrix[i][j] = static_cast<double>(m[i][n + j]);
      row += std::abs(result.matrix[i][j]);
    }
    result.norm = std::max(result.norm, row);
  }
  return result;
}

const Interpolation& interpolation_of(int degree) {
  static const std::array<Interpolation, kAngleDegree + 1> all = [] {
    std::array<Interpolation, kAngleDegree + 1> made;
    for (int d = 5; d <= kAngleDegree; ++d) made[static_cast<std::size_t>(d)] = interpolation(d);
    return made;
  }();
  return all[static_cast<std::size_t>(degree)];
}

double form_value(std::array<double, 6> c, double t) {
  for (std::size_t level = 5; level > 0; --level)
    for (std::size_t i = 0; i < level; ++i) c[i] = (1 - t) * c[i] + t * c[i + 1];
  return c[0];
}

// How far beyond [-1, 1], in x = 2t - 1, the form stays within kLargestTurn on complex discs
// round its points: the radius r - 1, from the sum of absolute Taylor coefficients at the middle.
double free_radius(const std::array<double, 6>& c) {
  std::array<double, 6> sizes{};
  std::array<double, 6> row = c;
  for (std::size_t k = 0; k <= 5; ++k) {
    std::array<double, 6> mean = row;
    for (std::size_t level = 5 - k; level > 0; --level)
      for (std::size_t i = 0; i < level; ++i) mean[i] = 0.5 * (mean[i] + mean[i + 1]);
    sizes[k] = binomial(5, static_cast<int>(k)) * std::abs(mean[0]) *
               std::ldexp(1.0, -static_cast<int>(k));
    for (std::size_t i = 0; i + k < 5; ++i) row[i] = row[i + 1] - row[i];
  }
  const auto turn = [&](double r) {
    double sum = 0;
    for (std::size_t k = 6; k-- > 0;) sum = sum * r + sizes[k];
    return sum;
  };
  double radius = 1;
  while (radius < 64 && turn(radius * 1.25) <= kLargestTurn) radius *= 1.25;
  return radius - 1;
}

LocalForm angle_form(const std::array<double, 6>& parameters, const Interval& span, int degree) {
  const double k = std::tan(0.25 * length(span)), middle = at(span, 0.5);
  std::array<double, 6> psi;
  for (std::size_t i = 0; i <= 5; ++i) psi[i] = 0.5 * (parameters[i] - middle);
  const double radius = free_radius(psi);
  const Interpolation& rule = interpolation_of(degree);
  // Less a linear function, so that little is left to round.
  const auto value = [&](double t) { return 0.5 + 0.5 * std::tan(form_value(psi, t)) / k; };
  const Interval ends{value(0), value(1)};
  std::vector<double> values;
  double largest = 0;
  for (const double t : rule.nodes) {
    values.push_back(value(t) - at(ends, t));
    largest = std::max(largest, std::abs(values.back()));
  }
  LocalForm result;
  result.degree = degree;
  for (std::size_t i = 0; i < rule.matrix.size(); ++i) {
    double sum = at(ends, static_cast<double>(i) / degree);
    for (std::size_t j = 0; j < values.size(); ++j) sum += rule.matrix[i][j] * values[j];
    result.coefficients[i] = sum;
  }
  const double size = 1 + std::max(std::abs(ends.from), std::abs(ends.to));
  result.rounding = (16 * size + 2 * degree * largest) * kUnitRoundoff * rule.norm;
  result.error =
      std::tan(kLargestTurn) / (2 * k) * std::pow(radius, -(degree + 1)) * std::ldexp(1.0, -degree);
  return result;
}

LocalForm linear_form(const std::array<double, 6>& parameters, const Interval& span) {
  LocalForm result;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    result.coefficients[i] = (parameters[i] - span.from) / length(span);
  return result;
}

}  // namespace

LocalForm local_form(const std::array<double, 6>& parameters, ParameterLaw law,
                     const Interval& span, int degree) {
  if (law == ParameterLaw::Linear) return linear_form(parameters, span);
  if (degree < kMinDegree || degree > kAngleDegree)
    throw InvalidInput("local_form: the degree must be 5..8, got " + std::to_string(degree));
  return angle_form(parameters, span, degree);
}

}  // namespace blossom
