// SPDX-License-Identifier: LGPL-2.1-or-later
// A number known to lie between two doubles: interval arithmetic.
//
// Formulas that are templates on the scalar run on it like on double, and return bounds that hold
// with all roundings. Ends are rounded outwards by the exact error of each operation, not by
// switching the processor's rounding mode: a result that is a double has width 0. (A parameter
// range is another thing: `core/math/interval.h`.)

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/errors.h"

namespace blossom {

namespace detail {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Below this the error of a product or quotient may itself underflow.
inline constexpr double kSafeProduct = 0x1p-900;

inline double next_below(double x) { return std::nextafter(x, -kInfinity); }

/// The largest double not above the sum. Source: Knuth's exact error of a sum. Where the error is
/// no number (overflow), the next double below is right too: for infinity it is the largest double.
inline double sum_below(double a, double b) {
  const double sum = a + b;
  const double from_b = sum - a;
  const double error = (a - (sum - from_b)) + (b - from_b);
  return error >= 0 ? sum : next_below(sum);
}

/// A double not above the product; the largest one unless it underflows or overflows. 0 times
/// infinity is 0: infinite ends stand for numbers without bound.
inline double product_below(double a, double b) {
  if (a == 0 || b == 0) return 0;
  const double product = a * b;
  if (!(std::abs(product) > kSafeProduct)) return next_below(product);
  return std::fma(a, b, -product) >= 0 ? product : next_below(product);
}

/// A double not above the quotient, for b != 0.
inline double quotient_below(double a, double b) {
  if (a == 0) return 0;
  const double quotient = a / b;
  if (!(std::abs(quotient) > kSafeProduct && std::abs(a) > kSafeProduct))
    return next_below(quotient);
  const double rest = std::fma(-quotient, b, a);
  return (b > 0 ? rest : -rest) >= 0 ? quotient : next_below(quotient);
}

}  // namespace detail

/// All numbers from lower() to upper(), ends included.
///
///   (1) for x in a and y in b the exact x + y, x - y, x y, x / y lie in a + b, a - b, a b, a / b
///   (2) an end is the nearest double outwards, unless it underflows or overflows
///
/// Division by a range that holds 0 gives the whole line.
class Bounded {
 public:
  /// The number 0.
  Bounded() = default;
  /// One number, exactly.
  explicit Bounded(double value) : Bounded(value, value) {}
  /// throws InvalidInput if an end is not a number or lower > upper
  Bounded(double lower, double upper) : lower_(lower), upper_(upper) {
    if (!(lower <= upper)) throw InvalidInput("Bounded: the lower end must not be above the upper");
  }

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  bool contains(double x) const { return lower_ <= x && x <= upper_; }
  bool is_positive() const { return lower_ > 0; }
  bool is_negative() const { return upper_ < 0; }

  friend bool operator==(const Bounded&, const Bounded&) = default;

  friend Bounded operator-(const Bounded& a) { return {-a.upper_, -a.lower_}; }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    return {detail::sum_below(a.lower_, b.lower_), -detail::sum_below(-a.upper_, -b.upper_)};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    return {least(detail::product_below, a, b), -least(detail::product_below, -a, b)};
  }
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    if (b.contains(0)) return {-detail::kInfinity, detail::kInfinity};
    return {least(detail::quotient_below, a, b), -least(detail::quotient_below, -a, b)};
  }
  Bounded& operator+=(const Bounded& b) { return *this = *this + b; }
  Bounded& operator-=(const Bounded& b) { return *this = *this - b; }
  Bounded& operator*=(const Bounded& b) { return *this = *this * b; }
  Bounded& operator/=(const Bounded& b) { return *this = *this / b; }

 private:
  // The least of an operation that is monotonic in each operand, so least at some pair of ends.
  template <class Operation>
  static double least(Operation below, const Bounded& a, const Bounded& b) {
    return std::min({below(a.lower_, b.lower_), below(a.lower_, b.upper_),
                     below(a.upper_, b.lower_), below(a.upper_, b.upper_)});
  }

  double lower_ = 0;
  double upper_ = 0;
};

}  // namespace blossom
