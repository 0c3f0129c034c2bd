// SPDX-License-Identifier: LGPL-2.1-or-later
// Powers, Bernstein polynomials and the matrices of Theorem 1, over any scalar.
//
// The scalar may be double or exact; it needs + - * / and construction from double.

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/math/binomial.h"
#include "core/math/grid.h"
#include "core/math/interval.h"

namespace blossom::detail {

constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// 1, x, .., x^highest, with 0^0 = 1.
template <class Scalar>
std::vector<Scalar> powers(const Scalar& x, int highest) {
  std::vector<Scalar> power(index(highest + 1), Scalar(1));
  for (int i = 1; i <= highest; ++i) power[index(i)] = power[index(i - 1)] * x;
  return power;
}

/// B_0^n(t) .. B_n^n(t) by the triangle of affine combinations, which keeps small values
/// accurate: for t in [0, 1] each has at most 3n roundings, relative to itself. `values` is used
/// again, so that a row of calls allocates once.
template <class Scalar>
void bernstein(int n, const Scalar& t, std::vector<Scalar>& values) {
  const Scalar rest = Scalar(1) - t;
  values.resize(index(n + 1));
  values[0] = Scalar(1);
  for (int level = 1; level <= n; ++level) {
    values[index(level)] = t * values[index(level - 1)];
    for (int i = level - 1; i > 0; --i) {
      Scalar left = t * values[index(i - 1)];
      Scalar right = rest * values[index(i)];
      values[index(i)] = left + right;
    }
    values[0] = rest * values[0];
  }
}

template <class Scalar>
std::vector<Scalar> bernstein(int n, const Scalar& t) {
  std::vector<Scalar> values;
  bernstein(n, t, values);
  return values;
}

/// M(nu, i) = 1 / binom(n, i) sum_k binom(nu, k) binom(n - nu, i - k) b^k a^(i - k): the blossom
/// of x^i at nu copies of b and n - nu of a. Source: Vlachkova 2025, formula (3).
template <class Scalar>
Grid<Scalar> monomial_matrix(int n, const IntervalOf<Scalar>& interval) {
  const std::vector<Scalar> a = powers(interval.from, n);
  const std::vector<Scalar> b = powers(interval.to, n);
  Grid<Scalar> matrix(n + 1, n + 1);
  for (int nu = 0; nu <= n; ++nu)
    for (int i = 0; i <= n; ++i) {
      Scalar sum(0);
      for (int k = std::max(0, i + nu - n); k <= std::min(i, nu); ++k) {
        const Scalar count(binomial(nu, k) * binomial(n - nu, i - k));
        sum += count * (b[index(k)] * a[index(i - k)]);
      }
      matrix(nu, i) = sum / Scalar(binomial(n, i));
    }
  return matrix;
}

/// S(nu, i) = sum_k B_k^nu(b) B_(i - k)^(n - nu)(a): the blossom of B_i^n at nu copies of b and
/// n - nu of a. Source: Vlachkova 2025, Theorem 1, with Bernstein polynomials for monomials.
template <class Scalar>
Grid<Scalar> subdivision_matrix(int n, const IntervalOf<Scalar>& piece) {
  Grid<Scalar> matrix(n + 1, n + 1);
  std::vector<Scalar> at_a, at_b;
  at_a.reserve(index(n + 1));
  at_b.reserve(index(n + 1));
  for (int nu = 0; nu <= n; ++nu) {
    bernstein(nu, piece.to, at_b);
    bernstein(n - nu, piece.from, at_a);
    for (int i = 0; i <= n; ++i) {
      Scalar sum(0);
      for (int k = std::max(0, i + nu - n); k <= std::min(i, nu); ++k)
        sum += at_b[index(k)] * at_a[index(i - k)];
      matrix(nu, i) = sum;
    }
  }
  return matrix;
}

}  // namespace blossom::detail
