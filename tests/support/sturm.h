// SPDX-License-Identifier: LGPL-2.1-or-later
// The number of real roots of a polynomial, in exact arithmetic.

#pragma once

#include <vector>

#include "tests/support/exact.h"

namespace blossom::testing {

/// Coefficients by increasing power.
using ExactPolynomial = std::vector<Rational>;

inline void trim(ExactPolynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

inline Rational value(const ExactPolynomial& p, const Rational& x) {
  Rational sum = 0;
  for (auto c = p.rbegin(); c != p.rend(); ++c) sum = sum * x + *c;
  return sum;
}

inline ExactPolynomial derivative(const ExactPolynomial& p) {
  ExactPolynomial d;
  for (std::size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * static_cast<int>(i));
  return d;
}

inline ExactPolynomial remainder(ExactPolynomial p, const ExactPolynomial& q) {
  while (p.size() >= q.size()) {
    const Rational factor = p.back() / q.back();
    const std::size_t shift = p.size() - q.size();
    for (std::size_t i = 0; i < q.size(); ++i) p[shift + i] -= factor * q[i];
    p.pop_back();
    trim(p);
  }
  return p;
}

/// The number of different roots in (from, to], by Sturm's chain.
inline int count_roots(ExactPolynomial p, const Rational& from, const Rational& to) {
  trim(p);
  std::vector<ExactPolynomial> chain{p, derivative(p)};
  while (chain.back().size() > 1) {
    ExactPolynomial rest = remainder(chain[chain.size() - 2], chain.back());
    if (rest.empty()) break;
    for (Rational& c : rest) c = -c;
    chain.push_back(rest);
  }
  const auto changes = [&](const Rational& x) {
    int count = 0, last = 0;
    for (const ExactPolynomial& q : chain) {
      const int sign = value(q, x).sign();
      if (sign == 0) continue;
      count += last != 0 && sign != last;
      last = sign;
    }
    return count;
  };
  return changes(from) - changes(to);
}

/// A Bernstein form as powers.
inline ExactPolynomial powers(const std::vector<Rational>& bernstein) {
  const int n = static_cast<int>(bernstein.size()) - 1;
  ExactPolynomial p;
  std::vector<Rational> differences = bernstein;
  Rational binomial = 1;
  for (int i = 0; i <= n; ++i) {
    p.push_back(binomial * differences[0]);
    for (std::size_t k = 0; k + 1 < differences.size(); ++k)
      differences[k] = differences[k + 1] - differences[k];
    differences.pop_back();
    binomial = binomial * (n - i) / (i + 1);
  }
  return p;
}

}  // namespace blossom::testing
