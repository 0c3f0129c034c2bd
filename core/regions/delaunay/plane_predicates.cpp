// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/delaunay/plane_predicates.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

namespace blossom {
namespace {

using Rational = boost::multiprecision::cpp_rational;

template <class Scalar>
Scalar absolute(const Scalar& x) {
  return x < 0 ? Scalar(-x) : x;
}

template <class Scalar>
struct Sum {
  Scalar value;
  Scalar size;  // the same with absolute values of all products
};

template <class Scalar>
Sum<Scalar> turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Scalar left = (Scalar(b[0]) - Scalar(a[0])) * (Scalar(c[1]) - Scalar(a[1]));
  const Scalar right = (Scalar(b[1]) - Scalar(a[1])) * (Scalar(c[0]) - Scalar(a[0]));
  return {left - right, absolute(left) + absolute(right)};
}

// The determinant of the rows (x, y, x^2 + y^2) of a, b, c seen from d.
template <class Scalar>
Sum<Scalar> lifted(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2* const points[] = {&a, &b, &c};
  Scalar x[3], y[3], z[3];
  for (int k = 0; k < 3; ++k) {
    x[k] = Scalar((*points[k])[0]) - Scalar(d[0]);
    y[k] = Scalar((*points[k])[1]) - Scalar(d[1]);
    z[k] = x[k] * x[k] + y[k] * y[k];
  }
  Sum<Scalar> sum{0, 0};
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Scalar left = x[i] * y[j], right = x[j] * y[i];
    sum.value += z[k] * (left - right);
    sum.size += z[k] * (absolute(left) + absolute(right));
  }
  return sum;
}

// Roundings of a term: two differences, a product and the last difference; and of a term of the
// circle's sign: 2 + 2 differences, squares and their sum, products, sums. One more for this bound.
constexpr double kTurnRoundings = 8;
constexpr double kLiftedRoundings = 24;
constexpr double kMinSize = 0x1p-900;  // above it an underflow is far below the error bound

int sign_of(const auto& x) { return (x > 0) - (x < 0); }

// Whether the sum, of that many roundings a term, has the sign of the exact one. Nothing is
// rounded where all products are 0.
template <class Scalar>
bool decides(const Sum<Scalar>& sum, double roundings) {
  constexpr Scalar kUnit = std::numeric_limits<Scalar>::epsilon() / 2;
  return sum.size > Scalar(kMinSize) && absolute(sum.value) > Scalar(roundings) * kUnit * sum.size;
}

// Points in a row along an axis.
bool is_axis_line(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (a[0] == b[0] && a[0] == c[0]) || (a[1] == b[1] && a[1] == c[1]);
}

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Sum<double> sum = turn<double>(a, b, c);
  if (decides(sum, kTurnRoundings)) return sign_of(sum.value);
  if (is_axis_line(a, b, c)) return 0;
  const Sum<long double> longer = turn<long double>(a, b, c);
  if (decides(longer, kTurnRoundings)) return sign_of(longer.value);
  return sign_of(turn<Rational>(a, b, c).value);
}

int in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Sum<double> sum = lifted<double>(a, b, c, d);
  if (decides(sum, kLiftedRoundings)) return sign_of(sum.value);
  const Sum<long double> longer = lifted<long double>(a, b, c, d);
  if (decides(longer, kLiftedRoundings)) return sign_of(longer.value);
  return sign_of(lifted<Rational>(a, b, c, d).value);
}

}  // namespace blossom
