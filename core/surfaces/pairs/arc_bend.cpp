// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/arc_bend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/index.h"

namespace blossom {
namespace {

constexpr double kProductSlack = 1e-12;  // covers the roundings of sums of bounds, relative

// Of a number: middle +- radius.
struct Number {
  double middle = 0;
  double radius = 0;
};

Number product(const Number& x, const Number& y) {
  const double middle = x.middle * y.middle;
  const double radius = std::abs(x.middle) * y.radius + x.radius * (std::abs(y.middle) + y.radius);
  return {middle, radius + kProductSlack * (std::abs(middle) + radius)};
}

void add(VectorBounds& sum, const Number& factor, const VectorBounds& of) {
  for (int k = 0; k < 3; ++k) {
    const Number term = product(factor, {of.middle[k], of.radius[k]});
    sum.middle[k] += term.middle;
    sum.radius[k] += term.radius;
  }
}

// All solutions y of J y = r for the matrices of a regular minor: y = C r + (I - C J) y, so that
// |y - C r| <= E |y|, and the largest |y| is no more than that of C r over 1 - |E|.
std::optional<std::array<Number, 3>> solutions(const Minor& minor, const VectorBounds& r) {
  std::array<Number, 3> y;
  double largest = 0, spread = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double row = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const int axis = static_cast<int>(j);
      const Number term = product({minor.inverse[i][j], 0}, {r.middle[axis], r.radius[axis]});
      y[i].middle += term.middle;
      y[i].radius += term.radius;
      row += minor.spread[i][j];
    }
    largest = std::max(largest, std::abs(y[i].middle) + y[i].radius);
    spread = std::max(spread, row);
  }
  if (!(spread < 1)) return std::nullopt;
  largest *= (1 + kProductSlack) / (1 - spread);
  for (std::size_t i = 0; i < 3; ++i)
    y[i].radius += (minor.spread[i][0] + minor.spread[i][1] + minor.spread[i][2]) * largest;
  return y;
}

// The second derivative of F along z'.
VectorBounds second_along(const std::array<Number, 4>& z, const SecondDerivatives& a,
                          const SecondDerivatives& b) {
  const auto times = [](double factor, const Number& x, const Number& y) {
    const Number xy = product(x, y);
    return Number{factor * xy.middle, std::abs(factor) * xy.radius};
  };
  VectorBounds sum{};
  add(sum, times(1, z[0], z[0]), a.uu);
  add(sum, times(2, z[0], z[1]), a.uv);
  add(sum, times(1, z[1], z[1]), a.vv);
  add(sum, times(-1, z[2], z[2]), b.uu);
  add(sum, times(-2, z[2], z[3]), b.uv);
  add(sum, times(-1, z[3], z[3]), b.vv);
  return sum;
}

VectorBounds negative(const VectorBounds& x) { return {-x.middle, x.radius}; }

}  // namespace

std::optional<Interval> bend_over(const PairModel& model, const ArcStretch& stretch, int along,
                                  int parameter) {
  if (stretch.empty) return std::nullopt;
  const Minor minor = stretch.bounds->minor(along);
  if (!minor.regular) return std::nullopt;
  const auto kept = kept_columns(along);
  const auto slopes = solutions(minor, negative(stretch.bounds->column(along)));
  if (!slopes) return std::nullopt;
  std::array<Number, 4> z;
  z[index(along)] = {1, 0};
  for (std::size_t i = 0; i < 3; ++i) z[index(kept[i])] = (*slopes)[i];
  const auto bends =
      solutions(minor, negative(second_along(z, model.second_a(), model.second_b())));
  if (!bends) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i)
    if (kept[i] == parameter) {
      const Number& bend = (*bends)[i];
      return Interval{bend.middle - bend.radius, bend.middle + bend.radius};
    }
  return Interval{0, 0};
}

}  // namespace blossom
