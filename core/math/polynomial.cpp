// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/polynomial.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace blossom {
namespace {

constexpr double kNarrowest = 1e-10;  // an interval with an undecided root this short gives up
constexpr int kBisections = 60;

class RootSearch {
 public:
  RootSearch(const Polynomial& p, double error, double slope_error)
      : p_(p), slope_(derivative(p)), error_(error), slope_error_(slope_error) {}

  bool run(double from, double to) {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    const PolynomialRange values = range(shifted(p_, middle, half));
    if (values.low > error_ || values.high < -error_) return true;
    const PolynomialRange slopes = range(shifted(slope_, middle, half));
    if (slopes.low > slope_error_ || slopes.high < -slope_error_) {
      const double a = value(p_, from), b = value(p_, to);
      if (std::abs(a) > error_ && std::abs(b) > error_) {
        if ((a > 0) != (b > 0)) roots.push_back({bisect(from, to, a), a < 0});
        return true;
      }
    }
    if (to - from < kNarrowest) return false;
    // Off the middle, where roots like to sit.
    const double cut = from + 0.4865 * (to - from);
    return run(from, cut) && run(cut, to);
  }

  std::vector<IsolatedRoot> roots;

 private:
  double bisect(double from, double to, double at_from) const {
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (from + to);
      if ((value(p_, middle) > 0) == (at_from > 0))
        from = middle;
      else
        to = middle;
    }
    return 0.5 * (from + to);
  }

  const Polynomial& p_;
  Polynomial slope_;
  double error_, slope_error_;
};

}  // namespace

double value(const Polynomial& p, double t) {
  double sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * t + p[i];
  return sum;
}

Polynomial derivative(const Polynomial& p) {
  if (p.size() < 2) return {0};
  Polynomial d(p.size() - 1);
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = static_cast<double>(i + 1) * p[i + 1];
  return d;
}

Polynomial shifted(const Polynomial& p, double m, double h) {
  Polynomial q(p);
  const std::size_t n = p.size();
  for (std::size_t i = 0; i + 1 < n; ++i)
    for (std::size_t j = n - 1; j > i; --j) q[j - 1] += m * q[j];
  double power = 1;
  for (std::size_t i = 0; i < n; ++i, power *= h) q[i] *= power;
  return q;
}

// The Bernstein coefficients of sum q_i x^i on [0, 1] are sum_i binom(j, i) q_i / binom(n, i).
PolynomialRange range(const Polynomial& p) {
  Polynomial b = shifted(p, -1, 2);  // to [0, 1]: t = 2 x - 1
  const std::size_t n = b.size() - 1;
  double inverse = 1;  // of binom(n, i)
  for (std::size_t i = 1; i <= n; ++i) {
    inverse *= static_cast<double>(i) / static_cast<double>(n + 1 - i);
    b[i] *= inverse;
  }
  for (std::size_t k = 1; k <= n; ++k)
    for (std::size_t j = n; j >= k; --j) b[j] += b[j - 1];
  const auto [low, high] = std::minmax_element(b.begin(), b.end());
  return {*low, *high};
}

std::optional<std::vector<IsolatedRoot>> isolated_roots(const Polynomial& p, double error,
                                                        double slope_error, double from,
                                                        double to) {
  RootSearch search(p, error, slope_error);
  if (!search.run(from, to)) return std::nullopt;
  return search.roots;
}

}  // namespace blossom
