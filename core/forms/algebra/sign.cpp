// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/algebra/sign.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <span>
#include <string>

#include "core/base/errors.h"
#include "core/forms/algebra/detail/sign.h"
#include "core/forms/detail/checks.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

using Rational = boost::multiprecision::cpp_rational;

// A double with the sum of the absolute values of all terms that went into it.
struct Filtered {
  double value = 0;
  double size = 0;

  explicit Filtered(double x) : value(x), size(std::abs(x)) {}
  Filtered(double x, double s) : value(x), size(s) {}
  friend Filtered operator+(const Filtered& a, const Filtered& b) {
    return {a.value + b.value, a.size + b.size};
  }
  friend Filtered operator-(const Filtered& a, const Filtered& b) {
    return {a.value - b.value, a.size + b.size};
  }
  friend Filtered operator*(const Filtered& a, const Filtered& b) {
    return {a.value * b.value, a.size * b.size};
  }
};

// With parts of parameters below 2 and at most 2 kMaxProductDegree levels, an error of 2^-1075 by
// underflow grows to at most 2^-820; above this size that is nothing.
constexpr double kMinSize = 0x1p-500;

void check_finite(std::span<const double> values, const char* function) {
  for (const double value : values)
    if (!std::isfinite(value))
      throw InvalidInput(std::string(function) + ": a coefficient is not finite");
}

void check(const BezierFunction& f, const char* function) {
  detail::check_degree(function, f.degree(), kMaxProductDegree);
  check_finite(f.points, function);
}

void check(const BezierFunction2& f, const char* function) {
  detail::check_degree(function, f.degree_u(), kMaxProductDegree);
  detail::check_degree(function, f.degree_v(), kMaxProductDegree);
  check_finite(f.points.values(), function);
}

void check(const Ratio& t) {
  if (std::isfinite(t.numerator) && std::isfinite(t.denominator) && t.denominator != 0) return;
  throw InvalidInput("sign_at: a parameter must be finite, got " + detail::text(t.numerator) +
                     " / " + detail::text(t.denominator));
}

int sign_of(const auto& value) { return (value > 0) - (value < 0); }

// The sign of b^n.
int sign_of_power(double b, int n) { return b < 0 && n % 2 != 0 ? -1 : 1; }

// The same quotient of numbers below 2, by a power of two; nothing if that is not exact.
std::optional<Ratio> below_two(const Ratio& t) {
  const int exponent = std::ilogb(std::max(std::abs(t.numerator), std::abs(t.denominator)));
  const Ratio result{std::scalbn(t.numerator, -exponent), std::scalbn(t.denominator, -exponent)};
  if (std::scalbn(result.numerator, exponent) == t.numerator &&
      std::scalbn(result.denominator, exponent) == t.denominator)
    return result;
  return std::nullopt;
}

// The sign of a value after `levels` levels of de Casteljau, or nothing. b - a, a product and
// a sum round 3 times a level; one rounding more covers those of the size and of this bound.
std::optional<int> decided(const Filtered& f, int levels) {
  if (!(f.size > kMinSize && std::isfinite(f.size))) return std::nullopt;
  const double bound = (4 * levels + 4) * kUnitRoundoff * f.size;
  if (std::abs(f.value) > bound) return sign_of(f.value);
  return std::nullopt;
}

template <class Scalar>
std::vector<Scalar> line_as(const std::vector<double>& values) {
  std::vector<Scalar> result;
  for (const double value : values) result.push_back(Scalar(value));
  return result;
}

template <class Scalar>
Grid<Scalar> net_as(const Grid<double>& values) {
  Grid<Scalar> result(values.rows(), values.columns(), Scalar(0));
  for (int i = 0; i < values.rows(); ++i)
    for (int j = 0; j < values.columns(); ++j) result(i, j) = Scalar(values(i, j));
  return result;
}

template <class Scalar>
Scalar value_at(const BezierFunction& f, const Ratio& t) {
  return detail::homogeneous_value(line_as<Scalar>(f.points), Scalar(t.numerator),
                                   Scalar(t.denominator));
}

template <class Scalar>
Scalar value_at(const BezierFunction2& f, const Ratio& u, const Ratio& v) {
  return detail::homogeneous_value(net_as<Scalar>(f.points), Scalar(u.numerator),
                                   Scalar(u.denominator), Scalar(v.numerator),
                                   Scalar(v.denominator));
}

// True if every coefficient is at least `margin`, and those of the ends or corners are above.
bool all_above(std::span<const double> all, std::span<const double> ends, double margin) {
  return std::all_of(all.begin(), all.end(), [&](double c) { return c >= margin; }) &&
         std::all_of(ends.begin(), ends.end(), [&](double c) { return c > margin; });
}

std::optional<int> common_sign(std::vector<double> all, std::vector<double> ends, double margin) {
  if (!(margin >= 0))
    throw InvalidInput("sign_on_domain: the margin must not be negative, got " +
                       detail::text(margin));
  if (all_above(all, ends, margin)) return 1;
  if (margin == 0 && std::count(all.begin(), all.end(), 0.0) == std::ssize(all)) return 0;
  for (double& c : all) c = -c;
  for (double& c : ends) c = -c;
  if (all_above(all, ends, margin)) return -1;
  return std::nullopt;
}

}  // namespace

int sign_at(const BezierFunction& f, double t) { return sign_at(f, Ratio{t, 1}); }

int sign_at(const BezierFunction& f, const Ratio& t) {
  check(f, "sign_at");
  check(t);
  const int outer = sign_of_power(t.denominator, f.degree());
  if (const auto small = below_two(t))
    if (const auto sign = decided(value_at<Filtered>(f, *small), f.degree())) return outer * *sign;
  return outer * sign_of(value_at<Rational>(f, t));
}

int sign_at(const BezierFunction2& f, double u, double v) {
  return sign_at(f, Ratio{u, 1}, Ratio{v, 1});
}

int sign_at(const BezierFunction2& f, const Ratio& u, const Ratio& v) {
  check(f, "sign_at");
  check(u);
  check(v);
  const int outer =
      sign_of_power(u.denominator, f.degree_u()) * sign_of_power(v.denominator, f.degree_v());
  const int levels = f.degree_u() + f.degree_v();
  const auto small_u = below_two(u), small_v = below_two(v);
  if (small_u && small_v)
    if (const auto sign = decided(value_at<Filtered>(f, *small_u, *small_v), levels))
      return outer * *sign;
  return outer * sign_of(value_at<Rational>(f, u, v));
}

std::optional<int> sign_on_domain(const BezierFunction& f, double margin) {
  check(f, "sign_on_domain");
  return common_sign(f.points, {f.points.front(), f.points.back()}, margin);
}

std::optional<int> sign_on_domain(const BezierFunction2& f, double margin) {
  check(f, "sign_on_domain");
  const auto values = f.points.values();
  const int n = f.degree_u(), m = f.degree_v();
  return common_sign({values.begin(), values.end()},
                     {f.points(0, 0), f.points(0, m), f.points(n, 0), f.points(n, m)}, margin);
}

}  // namespace blossom
