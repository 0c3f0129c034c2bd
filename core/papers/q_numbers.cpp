// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/papers/q_numbers.h"

#include <boost/multiprecision/cpp_int.hpp>

#include "core/papers/detail/q_checks.h"
#include "core/papers/detail/q_factors.h"

namespace blossom {

template <class Scalar>
Scalar q_integer(int n, const QParametersOf<Scalar>& q) {
  detail::check_degree("q_integer", n);
  detail::check_q("q_integer", q);
  return detail::q_integers(n, q).back();
}

template <class Scalar>
Scalar q_factorial(int n, const QParametersOf<Scalar>& q) {
  detail::check_degree("q_factorial", n);
  detail::check_q("q_factorial", q);
  const std::vector<Scalar> integers = detail::q_integers(n, q);
  Scalar product(1);
  for (int i = 1; i <= n; ++i) product *= integers[detail::index(i)];
  return product;
}

template <class Scalar>
std::vector<Scalar> q_binomials(int n, const QParametersOf<Scalar>& q) {
  detail::check_degree("q_binomials", n);
  detail::check_q("q_binomials", q);
  return detail::q_binomial_row(n, q);
}

template <class Scalar>
std::vector<Scalar> q_diagonal_factors(int n, const QParametersOf<Scalar>& q) {
  detail::check_degree("q_diagonal_factors", n);
  detail::check_q("q_diagonal_factors", q);
  return detail::diagonal_factors(n, q);
}

template <class Scalar>
std::string q_blossom_obstacle(int degree, const QParametersOf<Scalar>& q) {
  detail::check_degree("q_blossom_obstacle", degree);
  detail::check_q("q_blossom_obstacle", q);
  if (degree <= 1) return {};
  const std::string no_blossom =
      " and the degree is " + std::to_string(degree) + ": x^k y^(n-k) has no (q1,q2)-blossom for ";
  if (q.q1 == 0) return "q1 = 0" + no_blossom + "k >= 2";
  if (q.q2 == 0) return "q2 = 0" + no_blossom + "n - k >= 2";
  if (degree % 2 == 0 && q.q1 + q.q2 == 0)
    return "q1 = -q2 = " + detail::text(q.q1) + no_blossom + "odd k, since n is even";
  return {};
}

template <class Scalar>
std::string q_basis_obstacle(int degree, const IntervalOf<Scalar>& interval,
                             const QParametersOf<Scalar>& q) {
  const std::string no_blossom = q_blossom_obstacle(degree, q);
  if (!no_blossom.empty()) return no_blossom;
  detail::check_finite("q_basis_obstacle", "the start of the interval", interval.from);
  detail::check_finite("q_basis_obstacle", "the end of the interval", interval.to);
  const detail::QFactors<Scalar> factors(degree, q);
  for (int i = 0; i < degree; ++i) {
    if (!factors.vanishes(i, interval.from, interval.to)) continue;
    const std::string power = i == 0 ? "" : i == 1 ? " " : "^" + std::to_string(i) + " ";
    const std::string equal = i == 0 ? "a = b" : "q1" + power + "a = q2" + power + "b";
    return equal + " on [" + detail::text(interval.from) + ", " + detail::text(interval.to) +
           "] with q1 = " + detail::text(q.q1) + ", q2 = " + detail::text(q.q2) +
           ": the basis of degree " + std::to_string(degree) + " divides by their difference";
  }
  return {};
}

#define BLOSSOM_INSTANTIATE(Scalar)                                                   \
  template Scalar q_integer(int, const QParametersOf<Scalar>&);                       \
  template Scalar q_factorial(int, const QParametersOf<Scalar>&);                     \
  template std::vector<Scalar> q_binomials(int, const QParametersOf<Scalar>&);        \
  template std::vector<Scalar> q_diagonal_factors(int, const QParametersOf<Scalar>&); \
  template std::string q_blossom_obstacle(int, const QParametersOf<Scalar>&);         \
  template std::string q_basis_obstacle(int, const IntervalOf<Scalar>&,               \
                                        const QParametersOf<Scalar>&);
BLOSSOM_INSTANTIATE(double)
BLOSSOM_INSTANTIATE(boost::multiprecision::cpp_rational)
#undef BLOSSOM_INSTANTIATE

}  // namespace blossom
