// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/math/series/taylor_series.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "core/base/unbounded.h"
#include "core/math/four.h"
#include "core/math/functions/quadratic.h"

namespace blossom {
namespace {

constexpr int K = kTaylorDegree;
constexpr double kRoundoff = 2e-15;  // of a majorant: covers the sums that make it

constexpr std::size_t start(int degree) { return taylor_index(degree, 0); }

// Of a lambda, so that it follows a function of several versions.
#define INLINED __attribute__((always_inline))

// Factor of z^k after d derivatives.
constexpr double falling(int k, int d) {
  double product = 1;
  for (int i = 0; i < d; ++i) product *= k - i;
  return product;
}

// Calls f with the constants First..Last, in this order.
template <int First, int Last, class F>
[[gnu::always_inline]] inline void for_constants(const F& f) {
  if constexpr (First <= Last) {
    f(std::integral_constant<int, First>());
    for_constants<First + 1, Last>(f);
  }
}

// The terms of total degree `Degree` of a b, where a and b have none below `LeastA` and `LeastB`.
// All loops are of fixed length.
template <int Degree, int LeastA = 0, int LeastB = 0>
[[gnu::always_inline]] inline std::array<double, Degree + 1> product_terms(
    const TaylorPolynomial& a, const TaylorPolynomial& b) {
  std::array<double, Degree + 1> sum{};
  for_constants<LeastA, Degree - LeastB>([&]<int P>(std::integral_constant<int, P>) INLINED {
    for (std::size_t i = 0; i <= P; ++i)
      for (std::size_t j = 0; j <= Degree - P; ++j)
        sum[i + j] += a[start(P) + i] * b[start(Degree - P) + j];
  });
  return sum;
}

TaylorPolynomial times(const TaylorPolynomial& a, const TaylorPolynomial& b) {
  TaylorPolynomial c;
  for_constants<0, K>([&]<int Degree>(std::integral_constant<int, Degree>) INLINED {
    const auto terms = product_terms<Degree>(a, b);
    std::copy(terms.begin(), terms.end(), c.begin() + start(Degree));
  });
  return c;
}

[[gnu::always_inline]] inline std::array<double, 4> product_totals(const std::array<double, 4>& a,
                                                                   const std::array<double, 4>& b) {
  return {a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2 * a[1] * b[1] + a[0] * b[2],
          a[3] * b[0] + 3 * a[2] * b[1] + 3 * a[1] * b[2] + a[0] * b[3]};
}

// The majorant of terms that nothing is left out of.
[[gnu::always_inline]] inline void make_majorants(TaylorSeries& f) {
  f.total = {};
  for_constants<0, K>([&]<int Degree>(std::integral_constant<int, Degree>) INLINED {
    double sum = 0;
    for (std::size_t j = 0; j <= Degree; ++j) sum += std::abs(f.terms[start(Degree) + j]);
    f.low[Degree] = sum;
    for (int d = 0; d < 4; ++d) f.total[static_cast<std::size_t>(d)] += falling(Degree, d) * sum;
  });
}

// The majorant of a b from degree LeastA + LeastB on, where a and b have none below.
template <int LeastA = 0, int LeastB = 0>
[[gnu::always_inline]] inline void make_product_majorants(TaylorSeries& c, const TaylorSeries& a,
                                                          const TaylorSeries& b) {
  for_constants<LeastA + LeastB, K>([&]<int Degree>(std::integral_constant<int, Degree>) INLINED {
    double sum = 0;
    for (std::size_t i = LeastA; i <= Degree - LeastB; ++i) sum += a.low[i] * b.low[Degree - i];
    c.low[Degree] = sum;
  });
  c.total = product_totals(a.total, b.total);
}

using BernsteinRow = std::array<Four, 2>;  // K + 1 values, and the last one again

// Bernstein coefficients on [-1, 1] of x^i, by degree K: [i][nu].
const std::array<BernsteinRow, K + 1>& bernstein_of_powers() {
  static const auto table = [] {
    std::array<BernsteinRow, K + 1> t{};
    const auto binomial = [](int n, int k) {
      double b = 1;
      for (int i = 1; i <= k; ++i) b = b * (n - k + i) / i;
      return b;
    };
    for (int i = 0; i <= K; ++i)
      for (int at = 0; at < 8; ++at) {
        const int nu = std::min(at, K);
        double sum = 0;  // [x^i] (1 - x)^(K - nu) (1 + x)^nu
        for (int l = std::max(0, i - nu); l <= std::min(i, K - nu); ++l)
          sum += (l % 2 == 0 ? 1 : -1) * binomial(K - nu, l) * binomial(nu, i - l);
        t[static_cast<std::size_t>(i)][static_cast<std::size_t>(at / 4)][at % 4] =
            sum / binomial(K, i);
      }
    return t;
  }();
  return table;
}

}  // namespace

double TaylorSeries::tail(int d) const {
  double kept = 0;
  for (int k = d; k <= K; ++k) kept += falling(k, d) * low[static_cast<std::size_t>(k)];
  const double all = total[static_cast<std::size_t>(d)];
  return std::max(all - kept, 0.0) + kRoundoff * all;
}

TaylorSeries taylor_series(const double* c, int rows, int columns) {
  TaylorSeries f{};
  for (int k = 0; k <= rows + columns - 2; ++k) {
    double sum = 0;
    for (int i = std::max(0, k - columns + 1); i <= std::min(k, rows - 1); ++i) {
      const double value = c[i * columns + k - i];
      if (k <= K) f.terms[taylor_index(i, k - i)] = value;
      sum += std::abs(value);
    }
    if (k <= K) f.low[static_cast<std::size_t>(k)] = sum;
    for (int d = 0; d < 4; ++d, sum *= k + 1 - d) f.total[static_cast<std::size_t>(d)] += sum;
  }
  return f;
}

TaylorSeries taylor_series(const TaylorPolynomial& polynomial) {
  TaylorSeries f;
  f.terms = polynomial;
  make_majorants(f);
  return f;
}

TaylorSeries operator+(TaylorSeries a, const TaylorSeries& b) {
  for (std::size_t i = 0; i < a.terms.size(); ++i) a.terms[i] += b.terms[i];
  for (std::size_t i = 0; i < a.low.size(); ++i) a.low[i] += b.low[i];
  for (std::size_t i = 0; i < a.total.size(); ++i) a.total[i] += b.total[i];
  return a;
}

TaylorSeries operator-(TaylorSeries a, const TaylorSeries& b) {
  for (std::size_t i = 0; i < a.terms.size(); ++i) a.terms[i] -= b.terms[i];
  for (std::size_t i = 0; i < a.low.size(); ++i) a.low[i] += b.low[i];
  for (std::size_t i = 0; i < a.total.size(); ++i) a.total[i] += b.total[i];
  return a;
}

TaylorSeries operator*(double s, TaylorSeries a) {
  for (double& c : a.terms) c *= s;
  for (double& c : a.low) c *= std::abs(s);
  for (double& c : a.total) c *= std::abs(s);
  return a;
}

TaylorSeries operator*(const TaylorSeries& a, const TaylorSeries& b) {
  TaylorSeries c;
  c.terms = times(a.terms, b.terms);
  make_product_majorants(c, a, b);
  return c;
}

TaylorSeries reciprocal(const TaylorSeries& f, bool& exists) {
  const double f0 = f.terms[0];
  const double rest = f.total[0] - f.low[0];
  exists = std::isfinite(1 / f0) && rest < 0.999 * std::abs(f0);
  TaylorSeries r{};
  if (!exists) return r;
  // With f = f0 (1 + d): r (1 + d) = 1 / f0, degree by degree.
  TaylorPolynomial d{};
  for (std::size_t i = 1; i < d.size(); ++i) d[i] = f.terms[i] / f0;
  r.terms[0] = 1 / f0;
  for (int k = 1; k <= K; ++k) {
    const TaylorPolynomial product = times(d, r.terms);
    for (int j = 0; j <= k; ++j) {
      const std::size_t at = start(k) + static_cast<std::size_t>(j);
      r.terms[at] = -product[at];
    }
  }
  // Majorant 1 / (|f0| (1 - d^(z))).
  std::array<double, K + 1> m{};
  for (std::size_t k = 1; k <= K; ++k) m[k] = f.low[k] / std::abs(f0);
  r.low[0] = 1 / std::abs(f0);
  for (std::size_t k = 1; k <= K; ++k)
    for (std::size_t j = 1; j <= k; ++j) r.low[k] += m[j] * r.low[k - j];
  const double s = 1 / (1 - rest / std::abs(f0)), scale = 1 / std::abs(f0);
  const double d1 = f.total[1] * scale, d2 = f.total[2] * scale, d3 = f.total[3] * scale;
  r.total = {scale * s, scale * d1 * s * s, scale * (d2 * s * s + 2 * d1 * d1 * s * s * s),
             scale * (d3 * s * s + 6 * d1 * d2 * s * s * s + 6 * d1 * d1 * d1 * s * s * s * s)};
  return r;
}

namespace {

struct PowersOf {
  std::array<const TaylorPolynomial*, 2> right, bent;
  std::array<TaylorSeries, kTaylorTerms>& powers;
};

// The terms of one degree of all powers, which are made of lower ones of x and y, and with them
// those of x and y.
template <int Degree>
[[gnu::always_inline]] inline void solve_degree(const PowersOf& of) {
  auto& powers = of.powers;
  std::array<std::array<double, Degree + 1>, 2> solved;
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t k = 0; k <= Degree; ++k) solved[c][k] = (*of.right[c])[start(Degree) + k];
  for_constants<2, Degree>([&]<int M>(std::integral_constant<int, M>) INLINED {
    for (int j = 0; j <= M; ++j) {
      const std::size_t at = taylor_index(M - j, j);
      const TaylorSeries& factor = powers[j < M ? 1 : 2];
      const TaylorSeries& below = powers[j < M ? taylor_index(M - 1 - j, j) : start(M) - 1];
      const auto sum = product_terms<Degree, 1, M - 1>(factor.terms, below.terms);
      for (std::size_t k = 0; k <= Degree; ++k) powers[at].terms[start(Degree) + k] = sum[k];
      for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t k = 0; k <= Degree; ++k) solved[c][k] -= (*of.bent[c])[at] * sum[k];
    }
  });
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t k = 0; k <= Degree; ++k) powers[c + 1].terms[start(Degree) + k] = solved[c][k];
}

BLOSSOM_HOT void solve_powers(const PowersOf& of) {
  auto& powers = of.powers;
  powers[0] = {};
  powers[0].terms[0] = powers[0].low[0] = powers[0].total[0] = 1;
  powers[1].terms[0] = powers[2].terms[0] = 0;
  for_constants<1, K>([&]<int Degree>(std::integral_constant<int, Degree>)
                          INLINED { solve_degree<Degree>(of); });
  make_majorants(powers[1]);
  make_majorants(powers[2]);
  for_constants<2, K>([&]<int M>(std::integral_constant<int, M>) INLINED {
    for (int j = 0; j <= M; ++j) {
      const TaylorSeries& below = powers[j < M ? taylor_index(M - 1 - j, j) : start(M) - 1];
      make_product_majorants<1, M - 1>(powers[taylor_index(M - j, j)], powers[j < M ? 1 : 2],
                                       below);
    }
  });
}

// f of the powers but for what f leaves out.
BLOSSOM_HOT void add_composed(const std::array<TaylorSeries, kTaylorTerms>& powers,
                              const TaylorSeries& f, TaylorSeries& sum) {
  // A power of total degree M has no terms below it.
  for_constants<0, K>([&]<int M>(std::integral_constant<int, M>) INLINED {
    for (std::size_t i = start(M); i < start(M + 1); ++i) {
      const TaylorSeries& power = powers[i];
      const double factor = f.terms[i], size = std::abs(factor);
      for (std::size_t k = start(M); k < sum.terms.size(); ++k)
        sum.terms[k] += factor * power.terms[k];
      for (std::size_t k = M; k < sum.low.size(); ++k) sum.low[k] += size * power.low[k];
      for (std::size_t k = 0; k < sum.total.size(); ++k) sum.total[k] += size * power.total[k];
    }
  });
}

}  // namespace

TaylorPowers::TaylorPowers(const TaylorPolynomial& u, const TaylorPolynomial& v,
                           const TaylorPolynomial& p, const TaylorPolynomial& q) {
  solve_powers({{&u, &v}, {&p, &q}, powers_});
}

TaylorSeries TaylorPowers::compose(const TaylorSeries& f) const {
  TaylorSeries r{};
  add_composed(powers_, f, r);
  // The terms f leaves out, by the chain rule on their bounds.
  const auto most = [&](std::size_t d) {
    return std::max(powers_[1].total[d], powers_[2].total[d]);
  };
  const double p1 = most(1), p2 = most(2), p3 = most(3);
  const double f0 = f.tail(0), f1 = f.tail(1), f2 = f.tail(2), f3 = f.tail(3);
  r.total[0] += f0;
  r.total[1] += f1 * p1;
  r.total[2] += f2 * p1 * p1 + f1 * p2;
  r.total[3] += f3 * p1 * p1 * p1 + 3 * f2 * p1 * p2 + f1 * p3;
  return r;
}

double value(const TaylorPolynomial& p, double x, double y) {
  double sum = 0;
#pragma GCC unroll 8
  for (int i = K; i >= 0; --i) {
    double row = 0;
#pragma GCC unroll 8
    for (int j = K - i; j >= 0; --j) row = row * y + p[taylor_index(i, j)];
    sum = sum * x + row;
  }
  return sum;
}

Polynomial along_y(const TaylorPolynomial& p, double x) {
  Polynomial row{};
#pragma GCC unroll 8
  for (int j = 0; j <= K; ++j)
#pragma GCC unroll 8
    for (int i = K - j; i >= 0; --i) {
      double& sum = row[static_cast<std::size_t>(j)];
      sum = sum * x + p[taylor_index(i, j)];
    }
  return row;
}

TaylorPolynomial derivative_x(const TaylorPolynomial& p) {
  TaylorPolynomial d{};
  for (int i = 1; i <= K; ++i)
    for (int j = 0; i + j <= K; ++j) d[taylor_index(i - 1, j)] = i * p[taylor_index(i, j)];
  return d;
}

TaylorPolynomial derivative_y(const TaylorPolynomial& p) {
  TaylorPolynomial d{};
  for (int j = 1; j <= K; ++j)
    for (int i = 0; i + j <= K; ++i) d[taylor_index(i, j - 1)] = j * p[taylor_index(i, j)];
  return d;
}

namespace {

using Form = std::array<double, K + 1>;  // sum c_i s^(n - i) t^i, of degree n

// f (a s + b t) for f of the given degree.
void multiply(Form& f, std::size_t degree, double a, double b) {
  f[degree + 1] = b * f[degree];
  for (std::size_t i = degree; i > 0; --i) f[i] = a * f[i] + b * f[i - 1];
  f[0] *= a;
}

}  // namespace

// The terms of each total degree n among themselves: those of x^(n - j) y^j by Horner's scheme.
TaylorPolynomial turned(const TaylorPolynomial& p, const Vec2& s_axis, const Vec2& t_axis) {
  std::array<Form, K + 1> y_powers{};
  y_powers[0][0] = 1;
  for (std::size_t j = 0; j < K; ++j) {
    y_powers[j + 1] = y_powers[j];
    multiply(y_powers[j + 1], j, s_axis[1], t_axis[1]);
  }
  TaylorPolynomial result;
  for (int n = 0; n <= K; ++n) {
    Form form{p[start(n)]};
    for (std::size_t j = 1; j <= static_cast<std::size_t>(n); ++j) {
      multiply(form, j - 1, s_axis[0], t_axis[0]);
      for (std::size_t i = 0; i <= j; ++i) form[i] += p[start(n) + j] * y_powers[j][i];
    }
    std::copy_n(form.begin(), n + 1, result.begin() + static_cast<std::ptrdiff_t>(start(n)));
  }
  return result;
}

// By repeated Horner's scheme, along x and then along y.
TaylorPolynomial moved(const TaylorPolynomial& p, const Vec2& by) {
  TaylorPolynomial result = p;
  for (int j = 0; j < K; ++j)
    for (int k = 0; k < K - j; ++k)
      for (int i = K - j - 1; i >= k; --i)
        result[taylor_index(i, j)] += by[0] * result[taylor_index(i + 1, j)];
  for (int i = 0; i < K; ++i)
    for (int k = 0; k < K - i; ++k)
      for (int j = K - i - 1; j >= k; --j)
        result[taylor_index(i, j)] += by[1] * result[taylor_index(i, j + 1)];
  return result;
}

// With s = 1 the terms of all total degrees fall together.
Polynomial along_line(const TaylorPolynomial& p, const Vec2& begin, const Vec2& step) {
  static_assert(kPolynomialDegree == K);
  const TaylorPolynomial forms = turned(p, begin, step);
  Polynomial result{};
  for (std::size_t n = 0; n <= K; ++n)
    for (std::size_t i = 0; i <= n; ++i) result[i] += forms[start(static_cast<int>(n)) + i];
  return result;
}

BLOSSOM_HOT TaylorRange range(const TaylorPolynomial& p, double rx, double ry) {
  const BernsteinRow* table = bernstein_of_powers().data();
  const double* terms = p.data();
  BernsteinRow rows[K + 1];  // [i][mu]
  double x = 1;
  for (int i = 0; i <= K; ++i, x *= rx) {
    Four low{}, high{};
    double y = x;
    for (int j = 0; i + j <= K; ++j, y *= ry) {
      const double factor = terms[taylor_index(i, j)] * y;
      low += factor * table[j].front();
      high += factor * table[j].back();
    }
    rows[i] = {low, high};
  }
  Four least = Four{} + kUnbounded, most = -least;
  for (int nu = 0; nu <= K; ++nu) {
    Four low{}, high{};
    for (int i = 0; i <= K; ++i) {
      const double factor = table[i][nu / 4][nu % 4];
      low += factor * rows[i].front();
      high += factor * rows[i].back();
    }
    least = low < least ? low : least;
    least = high < least ? high : least;
    most = low > most ? low : most;
    most = high > most ? high : most;
  }
  TaylorRange result{least[0], most[0]};
  for (int k = 1; k < 4; ++k)
    result = {std::min(result.low, least[k]), std::max(result.high, most[k])};
  return result;
}

TaylorRange close_range(const TaylorPolynomial& p) {
  const TaylorRange all = range(p, 1, 1);
  const PolynomialRange quadratic =
      range(Quadratic{p[0], p[1], p[2], p[3], p[4], p[5]}, {-1, 1}, {-1, 1});
  double rest = 0, size = 0;
  for (std::size_t i = 0; i < p.size(); ++i) (i < 6 ? size : rest) += std::abs(p[i]);
  rest += kRoundoff * (size + rest);
  return {std::max(all.low, quadratic.low - rest), std::min(all.high, quadratic.high + rest)};
}

}  // namespace blossom
