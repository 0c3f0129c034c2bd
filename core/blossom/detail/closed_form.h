// SPDX-License-Identifier: LGPL-2.1-or-later
// Blossoms of monomials over any scalar: at arbitrary arguments, and in closed form at the
// corners of a triangle.

#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/forms/algebra/detail/conversion.h"
#include "core/forms/triangle.h"

namespace blossom::detail {

/// sigma_i(t1..tn) / binom(n, i) for i = 0..n: the blossoms of 1, x, .., x^n. Source: formula (2)
/// of Vlachkova 2025; the coefficients of (1 + t1 x) .. (1 + tn x) instead of sums over subsets.
template <class Scalar>
std::vector<Scalar> monomial_blossoms(std::span<const Scalar> arguments) {
  const int n = static_cast<int>(arguments.size());
  std::vector<Scalar> sigma(index(n + 1), Scalar(0));
  sigma[0] = Scalar(1);
  for (int k = 0; k < n; ++k)
    for (int i = k + 1; i > 0; --i) sigma[index(i)] += arguments[index(k)] * sigma[index(i - 1)];
  for (int i = 0; i <= n; ++i) sigma[index(i)] /= Scalar(binomial(n, i));
  return sigma;
}

/// The blossoms of x^i y^j, i = 0..n, j = 0..m, at N arguments (x_k, y_k): coefficient of p^i q^j
/// in (1 + x_1 p + y_1 q) .. (1 + x_N p + y_N q), over the trinomial coefficient; 0 for
/// i + j > N. Source: formula (13), over ordered pairs of disjoint subsets.
template <class Scalar>
Grid<Scalar> triangle_blossoms(std::span<const Vec<Scalar, 2>> arguments, int n, int m) {
  const int total = static_cast<int>(arguments.size());
  Grid<Scalar> sigma(n + 1, m + 1, Scalar(0));
  sigma(0, 0) = Scalar(1);
  for (const Vec<Scalar, 2>& argument : arguments)
    for (int i = n; i >= 0; --i)
      for (int j = m; j >= 0; --j) {
        if (i > 0) sigma(i, j) += argument[0] * sigma(i - 1, j);
        if (j > 0) sigma(i, j) += argument[1] * sigma(i, j - 1);
      }
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m && i + j <= total; ++j) sigma(i, j) /= Scalar(trinomial(total, i, j));
  return sigma;
}

/// Powers of the coordinates of the three corners; [0] is the first coordinate's.
template <class Scalar>
struct CornerPowers {
  std::array<std::vector<Scalar>, 2> a, b, c;

  CornerPowers(const std::array<Vec<Scalar, 2>, 3>& corners, int highest) {
    for (int x = 0; x < 2; ++x) {
      a[index(x)] = powers(corners[0][x], highest);
      b[index(x)] = powers(corners[1][x], highest);
      c[index(x)] = powers(corners[2][x], highest);
    }
  }
};

/// How many of the N arguments of a blossom are a, b and c.
struct Copies {
  int nu, mu, lambda;
};

/// The two inner sums of formula (14), those over j_alpha and j_beta, times the three binomials
/// of i. What is left of the copies after i_alpha, i_beta, i_gamma of them is `left`.
template <class Scalar>
Scalar inner_sum(const CornerPowers<Scalar>& power, const Copies& left, int j, double count) {
  Scalar sum(0);
  for (int j_alpha = std::max(0, j - left.mu - left.lambda); j_alpha <= std::min(j, left.nu);
       ++j_alpha) {
    Scalar partial(0);
    for (int j_beta = std::max(0, j - j_alpha - left.lambda);
         j_beta <= std::min(j - j_alpha, left.mu); ++j_beta) {
      const int j_gamma = j - j_alpha - j_beta;
      const Scalar number(count * binomial(left.nu, j_alpha) * binomial(left.mu, j_beta) *
                          binomial(left.lambda, j_gamma));
      partial += number * (power.b[1][index(j_beta)] * power.c[1][index(j_gamma)]);
    }
    sum += partial * power.a[1][index(j_alpha)];
  }
  return sum;
}

/// The blossom of x^i y^j at nu copies of a, mu of b and lambda of c, times N! / (i! j! (N-i-j)!).
/// Source: Vlachkova 2025, formula (14), with the last three factors as in its first print.
template <class Scalar>
Scalar triangle_sum(const CornerPowers<Scalar>& power, const Copies& copies, int i, int j) {
  const auto [nu, mu, lambda] = copies;
  Scalar sum(0);
  for (int i_alpha = std::max(0, i - mu - lambda); i_alpha <= std::min(i, nu); ++i_alpha) {
    Scalar partial(0);
    for (int i_beta = std::max(0, i - i_alpha - lambda); i_beta <= std::min(i - i_alpha, mu);
         ++i_beta) {
      const int i_gamma = i - i_alpha - i_beta;
      const double count = binomial(nu, i_alpha) * binomial(mu, i_beta) * binomial(lambda, i_gamma);
      const Copies left{nu - i_alpha, mu - i_beta, lambda - i_gamma};
      const Scalar corners = power.b[0][index(i_beta)] * power.c[0][index(i_gamma)];
      partial += corners * inner_sum(power, left, j, count);
    }
    sum += partial * power.a[0][index(i_alpha)];
  }
  return sum;
}

/// The Bezier points of degree N over the triangle a, b, c of the plain parameters.
template <class Point>
std::vector<Point> triangle_points(
    const Grid<Point>& coefficients,
    const std::array<Vec<typename Point::scalar_type, 2>, 3>& corners, int degree) {
  using Scalar = typename Point::scalar_type;
  const int n = coefficients.rows() - 1, m = coefficients.columns() - 1;
  const CornerPowers<Scalar> power(corners, std::max(n, m));
  std::vector<Point> points;
  for (int nu = 0; nu <= degree; ++nu)
    for (int mu = 0; nu + mu <= degree; ++mu) {
      Point point{};
      for (int i = 0; i <= std::min(n, degree); ++i)
        for (int j = 0; j <= std::min(m, degree - i); ++j) {
          const Scalar sum = triangle_sum(power, {nu, mu, degree - nu - mu}, i, j);
          const Scalar weight = sum / Scalar(trinomial(degree, i, j));
          point += coefficients(i, j) * weight;
        }
      points.push_back(point);
    }
  return points;
}

}  // namespace blossom::detail
