// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/series/taylor_curve.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "core/math/binomial.h"
#include "core/math/four.h"

namespace blossom {
namespace {

constexpr int kOrder = kTaylorDegree;
constexpr int kDegree = AlongCurve::kDegree;
constexpr int kPadded = AlongCurve::kPadded;
constexpr int kFours = kPadded / 4;
static_assert(kPadded % 4 == 0);

using Row = std::array<double, kPadded>;

// Bernstein coefficients on [-1, 1] of t^i, by degree kDegree, one row for each i: those of
// (1 - t)^(n - nu) (1 + t)^nu, over binom(n, i). The last repeats.
constexpr auto kBernstein = [] {
  std::array<Row, kDegree + 1> table{};
  for (int i = 0; i <= kDegree; ++i)
    for (int nu = 0; nu < kPadded; ++nu) {
      const int k = nu < kDegree ? nu : kDegree;
      double sum = 0;
      for (int l = 0; l <= i; ++l)
        if (l <= kDegree - k && i - l <= k)
          sum += (l % 2 == 0 ? 1 : -1) * binomial(kDegree - k, l) * binomial(k, i - l);
      table[static_cast<std::size_t>(i)][static_cast<std::size_t>(nu)] = sum / binomial(kDegree, i);
    }
  return table;
}();

[[gnu::always_inline]] inline void add_multiple(double* sum, double factor, const double* row,
                                                int fours) {
  for (int k = 0; k < 4 * fours; k += 4) {
    Four s, r;
    std::memcpy(&s, sum + k, sizeof s);
    std::memcpy(&r, row + k, sizeof r);
    s += factor * r;
    std::memcpy(sum + k, &s, sizeof s);
  }
}

// p(x(t), y(t)) by Horner's rule in x, from `result` = 0.
BLOSSOM_HOT void compose(const TaylorPolynomial& p, const std::array<double, 2>& x,
                         const std::array<Row, kOrder + 1>& y_powers, double* result) {
  for (int i = kOrder; i >= 0; --i) {
    double last = 0;  // what a step leaves of the coefficient below
    for (int k = 0; i < kOrder && k <= 3 * (kOrder - i); ++k) {
      const double own = result[k];
      result[k] = x[0] * own + x[1] * last;
      last = own;
    }
    for (int j = 0; i + j <= kOrder; ++j)
      add_multiple(result, p[taylor_index(i, j)], y_powers[static_cast<std::size_t>(j)].data(),
                   j * 3 / 4 + 1);
  }
}

BLOSSOM_HOT void bernstein_from_powers(const Row& powers, Row& result) {
  Four b[kFours] = {};
  for (int i = 0; i <= kDegree; ++i)
    for (int k = 0; k < kFours; ++k) {
      Four r;
      std::memcpy(&r, kBernstein[static_cast<std::size_t>(i)].data() + 4 * k, sizeof r);
      b[k] += powers[static_cast<std::size_t>(i)] * r;
    }
  std::memcpy(result.data(), b, sizeof b);
}

// De Casteljau's triangle: its left and its right side.
BLOSSOM_HOT void cut(const Row& whole, double t, Row& before, Row& after) {
  std::array<double, kPadded + 1> row{};
  std::copy(whole.begin(), whole.end(), row.begin());
  for (std::size_t i = 0; i <= kDegree; ++i) {
    before[i] = row[0];
    after[kDegree - i] = row[kDegree - i];
    for (std::size_t k = 0; k + i < kDegree; k += 4) {
      Four p, q;
      std::memcpy(&p, row.data() + k, sizeof p);
      std::memcpy(&q, row.data() + k + 1, sizeof q);
      p += t * (q - p);
      std::memcpy(row.data() + k, &p, sizeof p);
    }
  }
  before.back() = before[kDegree];
  after.back() = after[kDegree];
}

}  // namespace

TaylorCurve::TaylorCurve(const std::array<double, 2>& x, const std::array<double, 4>& y) : x_(x) {
  y_powers_[0][0] = 1;
  for (std::size_t j = 1; j <= kOrder; ++j)
    for (std::size_t k = 0; k <= 3 * (j - 1); ++k)
      for (std::size_t l = 0; l < y.size(); ++l) y_powers_[j][k + l] += y_powers_[j - 1][k] * y[l];
}

AlongCurve TaylorCurve::along(const TaylorPolynomial& p) const {
  Row powers{};
  compose(p, x_, y_powers_, powers.data());
  AlongCurve result;
  bernstein_from_powers(powers, result.coefficients);
  return result;
}

PolynomialRange AlongCurve::range() const {
  Four low, high;
  std::memcpy(&low, coefficients.data(), sizeof low);
  high = low;
  for (std::size_t k = 4; k < kPadded; k += 4) {
    Four c;
    std::memcpy(&c, coefficients.data() + k, sizeof c);
    low = c < low ? c : low;
    high = c > high ? c : high;
  }
  return {std::min(std::min(low[0], low[1]), std::min(low[2], low[3])),
          std::max(std::max(high[0], high[1]), std::max(high[2], high[3]))};
}

std::array<AlongCurve, 2> AlongCurve::parts(double t) const {
  std::array<AlongCurve, 2> result;
  cut(coefficients, t, result[0].coefficients, result[1].coefficients);
  return result;
}

}  // namespace blossom
