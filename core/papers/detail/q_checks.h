// SPDX-License-Identifier: LGPL-2.1-or-later
// Preconditions of the functions on (q1,q2)-blossoms, with one wording.

#pragma once

#include <cmath>
#include <span>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/errors.h"
#include "core/forms/detail/checks.h"
#include "core/math/vec.h"
#include "core/papers/detail/q_factors.h"
#include "core/papers/q_numbers.h"

namespace blossom::detail {

template <class Scalar>
std::string text(const Scalar& value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

template <class Scalar>
bool is_finite(const Scalar& value) {
  if constexpr (std::is_floating_point_v<Scalar>)
    return std::isfinite(value);
  else
    return true;
}

/// Throws InvalidInput unless the value is finite.
template <class Scalar>
void check_finite(const char* function, const char* name, const Scalar& value) {
  if (!is_finite(value))
    throw InvalidInput(std::string(function) + ": " + name + " must be finite, got " + text(value));
}

/// Throws InvalidInput unless all coordinates are finite.
template <class Point>
void check_points(const char* function, std::span<const Point> points) {
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const auto& coordinate : points[k].coordinates)
      if (!is_finite(coordinate))
        throw InvalidInput(std::string(function) + ": point " + std::to_string(k + 1) + " of " +
                           std::to_string(points.size()) + " is not finite");
}

/// Throws InvalidInput unless both parameters are finite.
template <class Scalar>
void check_q(const char* function, const QParametersOf<Scalar>& q) {
  check_finite(function, "q1", q.q1);
  check_finite(function, "q2", q.q2);
}

/// Throws InvalidInput with the reason unless polynomials of this degree have blossoms.
template <class Scalar>
void check_blossom(const char* function, int degree, const QParametersOf<Scalar>& q) {
  check_degree(function, degree);
  check_q(function, q);
  const std::string obstacle = q_blossom_obstacle(degree, q);
  if (!obstacle.empty()) throw InvalidInput(std::string(function) + ": " + obstacle);
}

/// Throws InvalidInput with the reason unless there is a basis over the interval.
template <class Scalar>
void check_basis(const char* function, int degree, const IntervalOf<Scalar>& interval,
                 const QParametersOf<Scalar>& q) {
  check_degree(function, degree);
  check_q(function, q);
  check_finite(function, "the start of the interval", interval.from);
  check_finite(function, "the end of the interval", interval.to);
  const std::string obstacle = q_basis_obstacle(degree, interval, q);
  if (!obstacle.empty()) throw InvalidInput(std::string(function) + ": " + obstacle);
}

/// Throws InvalidInput if a divisor of Lemma 2.3 is not a normal number of the scalar.
template <class Scalar>
void check_divisors(const char* function, int degree, const QParametersOf<Scalar>& q) {
  if constexpr (std::is_floating_point_v<Scalar>)
    for (const Scalar divisor : diagonal_factors(degree, q))
      if (!std::isnormal(divisor))
        throw InvalidInput(std::string(function) + ": powers of q1 = " + text(q.q1) +
                           " and q2 = " + text(q.q2) + " leave the range of double at degree " +
                           std::to_string(degree) + "; curves depend on q1 / q2 alone");
}

/// Throws InvalidInput unless there are `degree` finite arguments (x, y).
template <class Scalar>
void check_arguments(const char* function, int degree, std::span<const Vec<Scalar, 2>> arguments) {
  if (static_cast<int>(arguments.size()) != degree)
    throw InvalidInput(std::string(function) + ": degree " + std::to_string(degree) + " takes " +
                       std::to_string(degree) + " arguments (x, y), got " +
                       std::to_string(arguments.size()));
  for (std::size_t k = 0; k < arguments.size(); ++k)
    if (!is_finite(arguments[k][0]) || !is_finite(arguments[k][1]))
      throw InvalidInput(std::string(function) + ": argument " + std::to_string(k + 1) +
                         " is not finite");
}

/// Throws InvalidInput unless these are the numbers 1..degree in some order.
inline void check_permutation(const char* function, int degree, std::span<const int> permutation) {
  std::vector<bool> seen(static_cast<std::size_t>(degree) + 1, false);
  bool valid = static_cast<int>(permutation.size()) == degree;
  for (const int sigma : permutation) {
    valid = valid && 1 <= sigma && sigma <= degree && !seen[static_cast<std::size_t>(sigma)];
    if (valid) seen[static_cast<std::size_t>(sigma)] = true;
  }
  if (valid) return;
  std::string list;
  for (const int sigma : permutation) list += (list.empty() ? "" : ", ") + std::to_string(sigma);
  throw InvalidInput(std::string(function) + ": the permutation must hold each of 1.." +
                     std::to_string(degree) + " once, got (" + list + ")");
}

}  // namespace blossom::detail
