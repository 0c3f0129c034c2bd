// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/functions/polynomial.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/math/functions/sign_change.h"

namespace blossom {
namespace {

constexpr double kNarrowest = 1e-10;  // an interval with an undecided root this short gives up
constexpr double kRootWidth = 0x1p-52;
constexpr double kCut = 0.4865;  // off the middle, where roots like to sit

constexpr std::size_t kTerms = kPolynomialDegree + 1;

constexpr std::array<double, kTerms> kBinomials = [] {
  std::array<double, kTerms> b{1};
  for (std::size_t i = 1; i < kTerms; ++i)
    b[i] = b[i - 1] * static_cast<double>(kTerms - i) / static_cast<double>(i);
  return b;
}();

// Bernstein coefficients over an interval.
using Coefficients = std::array<double, kTerms>;

// Of sum q_i x^i on [0, 1] they are sum_i binom(j, i) q_i / binom(n, i).
Coefficients coefficients_on(const Polynomial& p, double from, double to) {
  Coefficients b = p;
  for (std::size_t i = 0; i + 1 < kTerms; ++i)
    for (std::size_t j = kTerms - 1; j > i; --j) b[j - 1] += from * b[j];
  double power = 1;
  for (std::size_t i = 1; i < kTerms; ++i) {
    power *= to - from;
    b[i] *= power / kBinomials[i];
  }
  for (std::size_t k = 1; k < kTerms; ++k)
    for (std::size_t j = kTerms - 1; j >= k; --j) b[j] += b[j - 1];
  return b;
}

PolynomialRange range_of(const Coefficients& b) {
  const auto [low, high] = std::minmax_element(b.begin(), b.end());
  return {*low, *high};
}

// Those of the part before the cut; `b` becomes those of the part behind it. Source: de Casteljau.
Coefficients cut_off(Coefficients& b) {
  Coefficients before;
  for (std::size_t k = 0; k < kTerms; ++k) {
    before[k] = b[0];
    for (std::size_t i = 0; i + k + 1 < kTerms; ++i) b[i] += kCut * (b[i + 1] - b[i]);
  }
  return before;
}

class RootSearch {
 public:
  RootSearch(const Polynomial& p, double error, double slope_error)
      : p_(p), error_(error), slope_error_(slope_error) {}

  bool run(Coefficients b, double from, double to) {
    const PolynomialRange values = range_of(b);
    if (values.low > error_ || values.high < -error_) return true;
    if (is_monotone(b, to - from) && std::abs(b.front()) > error_ && std::abs(b.back()) > error_) {
      if ((b.front() > 0) != (b.back() > 0)) roots.push_back(root(b.front(), b.back(), from, to));
      return true;
    }
    if (to - from < kNarrowest) return false;
    const Coefficients before = cut_off(b);
    const double cut = from + kCut * (to - from);
    return run(before, from, cut) && run(b, cut, to);
  }

  std::vector<IsolatedRoot> roots;

 private:
  bool is_monotone(const Coefficients& b, double width) const {
    const double least = slope_error_ * width / kPolynomialDegree;
    bool rises = true, falls = true;
    for (std::size_t i = 0; i + 1 < kTerms; ++i) {
      rises = rises && b[i + 1] - b[i] > least;
      falls = falls && b[i + 1] - b[i] < -least;
    }
    return rises || falls;
  }

  IsolatedRoot root(double first, double last, double from, double to) const {
    const auto f = [this](double t) { return value(p_, t); };
    const bool rises = first < 0;
    const SignChange ends = rises ? SignChange{from, to} : SignChange{to, from};
    const auto [below, above] =
        narrowed(f, ends, std::min(first, last), std::max(first, last), kRootWidth);
    return {0.5 * (below + above), rises};
  }

  const Polynomial& p_;
  double error_, slope_error_;
};

}  // namespace

double value(const Polynomial& p, double t) {
  double sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * t + p[i];
  return sum;
}

PolynomialJet jet_at(const Polynomial& p, double t) {
  PolynomialJet jet{};
  for (std::size_t i = p.size(); i-- > 0;) {
    jet.slope = jet.slope * t + jet.value;
    jet.value = jet.value * t + p[i];
  }
  return jet;
}

PolynomialRange range(const Polynomial& p) { return range_of(coefficients_on(p, -1, 1)); }

std::optional<std::vector<IsolatedRoot>> isolated_roots(const Polynomial& p, double error,
                                                        double slope_error, double from,
                                                        double to) {
  RootSearch search(p, error, slope_error);
  if (!search.run(coefficients_on(p, from, to), from, to)) return std::nullopt;
  return search.roots;
}

}  // namespace blossom
