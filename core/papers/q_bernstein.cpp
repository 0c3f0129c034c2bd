// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/papers/q_bernstein.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <string>

#include "core/papers/detail/q_checks.h"
#include "core/papers/detail/q_factors.h"

namespace blossom {
namespace {

using detail::index;
using detail::QFactors;

template <class Scalar>
void check(const char* function, int n, const Scalar& x, const IntervalOf<Scalar>& interval,
           const QParametersOf<Scalar>& q) {
  detail::check_basis(function, n, interval, q);
  detail::check_finite(function, "x", x);
}

// Each of the m factors above is divided by one below, so that products stay in range.
template <class Scalar>
std::vector<Scalar> partial_basis(int n, int m, const Scalar& x, const IntervalOf<Scalar>& interval,
                                  const QParametersOf<Scalar>& q) {
  const auto& [a, b] = interval;
  const QFactors<Scalar> factors(n, q);
  std::vector<Scalar> values = detail::q_binomial_row(m, q);
  for (int k = 0; k <= m; ++k)
    for (int i = 0; i < m; ++i) {
      Scalar above = i < k ? factors.difference(n - m + i, a, x) : factors.difference(i - k, x, b);
      values[index(k)] *= above / factors.difference(n - m + i, a, b);
    }
  return values;
}

}  // namespace

template <class Scalar>
std::vector<Scalar> q_bernstein(int n, const Scalar& x, const IntervalOf<Scalar>& interval,
                                const QParametersOf<Scalar>& q) {
  check("q_bernstein", n, x, interval, q);
  return partial_basis(n, n, x, interval, q);
}

template <class Scalar>
std::vector<Scalar> q_partial_bernstein(int n, int m, const Scalar& x,
                                        const IntervalOf<Scalar>& interval,
                                        const QParametersOf<Scalar>& q) {
  check("q_partial_bernstein", n, x, interval, q);
  if (m < 0 || m > n)
    throw InvalidInput("q_partial_bernstein: m must be 0.." + std::to_string(n) + ", got " +
                       std::to_string(m));
  return partial_basis(n, m, x, interval, q);
}

template <class Scalar>
std::vector<Scalar> q_bernstein_by(QRecurrence recurrence, int n, const Scalar& x,
                                   const IntervalOf<Scalar>& interval,
                                   const QParametersOf<Scalar>& q) {
  check("q_bernstein_by", n, x, interval, q);
  const auto& [a, b] = interval;
  const QFactors<Scalar> factors(n, q);
  const bool forward = recurrence == QRecurrence::Forward;
  std::vector<Scalar> values(index(n + 1), Scalar(0));
  values[0] = Scalar(1);
  for (int level = 1; level <= n; ++level) {
    const Scalar divisor = factors.difference(level - 1, a, b);
    for (int k = level; k >= 0; --k) {
      Scalar sum(0);
      if (k > 0) {
        const Scalar& power = forward ? factors.q1(level - k) : factors.q2(level - k);
        sum += power * factors.difference(k - 1, a, x) * values[index(k - 1)];
      }
      if (k < level) {
        const Scalar& power = forward ? factors.q2(k) : factors.q1(k);
        sum += power * factors.difference(level - k - 1, x, b) * values[index(k)];
      }
      values[index(k)] = sum / divisor;
    }
  }
  return values;
}

template <class Scalar>
std::vector<Scalar> q_marsden_terms(int n, const Scalar& t, const Scalar& x,
                                    const IntervalOf<Scalar>& interval,
                                    const QParametersOf<Scalar>& q) {
  check("q_marsden_terms", n, x, interval, q);
  detail::check_finite("q_marsden_terms", "t", t);
  if (q.q1 == 0 || q.q2 == 0)
    throw InvalidInput("q_marsden_terms: q1 and q2 must not be 0, got " + detail::text(q.q1) +
                       " and " + detail::text(q.q2));
  const QParametersOf<Scalar> inverse{Scalar(1) / q.q1, Scalar(1) / q.q2};
  const Scalar ratio = q.q1 / q.q2, product = q.q1 * q.q2;
  const IntervalOf<Scalar> stretched{
      detail::powers(ratio, n)[index(n > 0 ? n - 1 : 0)] * interval.from, interval.to};
  const std::vector<Scalar> of_x = partial_basis(n, n, x, stretched, inverse);
  const std::vector<Scalar> binomials = detail::q_binomial_row(n, inverse);
  const std::vector<Scalar> triangular = detail::triangular_powers(product, n);
  const Scalar step = detail::powers(q.q2, n)[index(n > 0 ? n - 1 : 0)];
  std::vector<Scalar> terms = partial_basis(n, n, t, interval, q);
  Scalar power(1);
  for (int k = 0; k <= n; ++k, power *= -step)
    terms[index(k)] *= triangular[index(k)] * of_x[index(n - k)] / (power * binomials[index(k)]);
  return terms;
}

template <class Scalar>
Scalar q_marsden_product(int n, const Scalar& t, const Scalar& x,
                         const IntervalOf<Scalar>& interval, const QParametersOf<Scalar>& q) {
  check("q_marsden_product", n, x, interval, q);
  detail::check_finite("q_marsden_product", "t", t);
  const QFactors<Scalar> factors(n, q);
  Scalar product(1);
  for (int i = 0; i < n; ++i)
    product *= factors.difference(i, t, x) / factors.difference(i, interval.from, interval.to);
  return product;
}

#define BLOSSOM_INSTANTIATE(Scalar)                                                                \
  template std::vector<Scalar> q_bernstein(int, const Scalar&, const IntervalOf<Scalar>&,          \
                                           const QParametersOf<Scalar>&);                          \
  template std::vector<Scalar> q_partial_bernstein(                                                \
      int, int, const Scalar&, const IntervalOf<Scalar>&, const QParametersOf<Scalar>&);           \
  template std::vector<Scalar> q_bernstein_by(                                                     \
      QRecurrence, int, const Scalar&, const IntervalOf<Scalar>&, const QParametersOf<Scalar>&);   \
  template std::vector<Scalar> q_marsden_terms(                                                    \
      int, const Scalar&, const Scalar&, const IntervalOf<Scalar>&, const QParametersOf<Scalar>&); \
  template Scalar q_marsden_product(int, const Scalar&, const Scalar&, const IntervalOf<Scalar>&,  \
                                    const QParametersOf<Scalar>&);
BLOSSOM_INSTANTIATE(double)
BLOSSOM_INSTANTIATE(boost::multiprecision::cpp_rational)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
