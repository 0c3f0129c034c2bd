// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/plane_predicates.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

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
constexpr double kTurnError = 8 * 0x1p-53;
constexpr double kLiftedError = 24 * 0x1p-53;
constexpr double kMinSize = 0x1p-900;  // above it an underflow is far below the error bound

int sign_of(const auto& x) { return (x > 0) - (x < 0); }

bool decides(const Sum<double>& sum, double error) {
  return sum.size > kMinSize && std::abs(sum.value) > error * sum.size;
}

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Sum<double> sum = turn<double>(a, b, c);
  return decides(sum, kTurnError) ? sign_of(sum.value) : sign_of(turn<Rational>(a, b, c).value);
}

int in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Sum<double> sum = lifted<double>(a, b, c, d);
  return decides(sum, kLiftedError) ? sign_of(sum.value)
                                    : sign_of(lifted<Rational>(a, b, c, d).value);
}

}  // namespace blossom
