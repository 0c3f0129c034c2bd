// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/delaunay/plane_predicates.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace blossom {
namespace {

using Integer = boost::multiprecision::cpp_int;

template <class Scalar>
using PlanePoint = Vec<Scalar, 2>;

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
Sum<Scalar> turn(const std::array<PlanePoint<Scalar>, 3>& points) {
  const auto& [a, b, c] = points;
  const Scalar left = (b[0] - a[0]) * (c[1] - a[1]);
  const Scalar right = (b[1] - a[1]) * (c[0] - a[0]);
  return {left - right, absolute(left) + absolute(right)};
}

// The determinant of the rows (x, y, x^2 + y^2) of the first three points seen from the last.
template <class Scalar>
Sum<Scalar> lifted(const std::array<PlanePoint<Scalar>, 4>& points) {
  Scalar x[3], y[3], z[3];
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = points[k][0] - points[3][0];
    y[k] = points[k][1] - points[3][1];
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

template <std::size_t Count>
std::array<PlanePoint<long double>, Count> longer(const std::array<Vec2, Count>& points) {
  std::array<PlanePoint<long double>, Count> made;
  for (std::size_t k = 0; k < Count; ++k) made[k] = {points[k][0], points[k][1]};
  return made;
}

// All coordinates over one power of two, which does not matter for signs: fractions would have to
// be reduced.
template <std::size_t Count>
std::array<PlanePoint<Integer>, Count> whole(const std::array<Vec2, Count>& points) {
  constexpr int kDigits = std::numeric_limits<double>::digits;
  int least = std::numeric_limits<int>::max();
  for (const Vec2& p : points)
    for (const double x : p.coordinates)
      if (x != 0) least = std::min(least, std::ilogb(x) + 1 - kDigits);
  std::array<PlanePoint<Integer>, Count> made;
  for (std::size_t k = 0; k < Count; ++k)
    for (int axis = 0; axis < 2; ++axis) {
      int exponent = 0;
      const double part = std::frexp(points[k][axis], &exponent);
      if (part == 0) continue;
      made[k][axis] = static_cast<std::int64_t>(std::ldexp(part, kDigits));
      made[k][axis] <<= exponent - kDigits - least;
    }
  return made;
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
  const std::array points{a, b, c};
  const Sum<double> sum = turn(points);
  if (decides(sum, kTurnRoundings)) return sign_of(sum.value);
  if (is_axis_line(a, b, c)) return 0;
  const Sum<long double> of_longer = turn(longer(points));
  if (decides(of_longer, kTurnRoundings)) return sign_of(of_longer.value);
  return sign_of(turn(whole(points)).value);
}

int in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const std::array points{a, b, c, d};
  const Sum<double> sum = lifted(points);
  if (decides(sum, kLiftedRoundings)) return sign_of(sum.value);
  const Sum<long double> of_longer = lifted(longer(points));
  if (decides(of_longer, kLiftedRoundings)) return sign_of(of_longer.value);
  return sign_of(lifted(whole(points)).value);
}

}  // namespace blossom
