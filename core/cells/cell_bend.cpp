// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/cell_bend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bounds/value_arithmetic.h"
#include "core/cells/curve_cells.h"
#include "core/cells/net_ranges.h"

namespace blossom {
namespace {

constexpr double kBoundSlack = 1e-12;  // covers the few roundings of a sum or product of bounds

ValueRange sum(const ValueRange& a, const ValueRange& b) {
  return {a.low + b.low, a.high + b.high};
}

ValueRange minus(const ValueRange& a, const ValueRange& b) {
  return {a.low - b.high, a.high - b.low};
}

ValueRange range_of(const VectorBounds& bounds, int k) {
  return {bounds.middle[k] - bounds.radius[k], bounds.middle[k] + bounds.radius[k]};
}

ValueRange value_range_times(const Range& range, double factor) {
  return {factor * range.low, factor * range.high};
}

struct SecondValues {
  ValueRange uu, uv, vv;
};

// The ranges of the nets of a plane's second derivatives.
SecondValues seconds_of(const double* plane, const NetShape& shape) {
  const int n = shape.rows - 1, m = shape.columns - 1;
  const SecondRanges ranges = second_difference_ranges(plane, shape.rows, shape.columns);
  return {value_range_times(ranges.uu, n * (n - 1)), value_range_times(ranges.uv, n * m),
          value_range_times(ranges.vv, m * (m - 1))};
}

// The weights of a rational cell and what of them the quotient rule takes.
struct Weights {
  const double* net;
  ValueRange over;  // 1 / w
  ValueRange u, v;
  SecondValues second;
  double spread;  // errors are relative to the largest weight
};

Weights weights_of(const Cell& cell, const NetShape& shape) {
  const double* w = cell.homogeneous + 3 * shape.plane_size();
  const auto [least, most] = std::minmax_element(w, w + shape.plane_size());
  return {w,
          {(1 - kBoundSlack) / *most, (1 + kBoundSlack) / *least},
          value_range_times(difference_range_u(w, shape.rows, shape.columns), shape.rows - 1),
          value_range_times(difference_range_v(w, shape.rows, shape.columns), shape.columns - 1),
          seconds_of(w, shape),
          *most / *least};
}

// The numerators of the second derivatives over the weight, in one coordinate.
SecondValues rational_seconds(const Cell& cell, const NetShape& shape, const Weights& w, int k) {
  const int size = shape.plane_size();
  const double origin = 0.5 * (cell.low[k] + cell.high[k]);
  std::array<double, (kMaxDegree + 1) * (kMaxDegree + 1)> moved;
  for (int i = 0; i < size; ++i)
    moved[static_cast<std::size_t>(i)] = cell.homogeneous[k * size + i] - w.net[i] * origin;
  const ValueRange offset{cell.low[k] - origin, cell.high[k] - origin};
  const ValueRange su = range_of(cell.du, k), sv = range_of(cell.dv, k);
  const SecondValues x = seconds_of(moved.data(), shape);
  const auto quotient = [&](const ValueRange& second, const ValueRange& products,
                            const ValueRange& of_weights) {
    return times(minus(minus(second, products), times(offset, of_weights)), w.over);
  };
  const ValueRange uu = times(w.u, su), vv = times(w.v, sv);
  return {quotient(x.uu, sum(uu, uu), w.second.uu),
          quotient(x.uv, sum(times(w.u, sv), times(w.v, su)), w.second.uv),
          quotient(x.vv, sum(vv, vv), w.second.vv)};
}

// A second difference of the net is off by four of its margins.
SecondDerivatives polynomial_seconds(const Cell& cell, const NetShape& shape) {
  const int n = shape.rows - 1, m = shape.columns - 1;
  const auto scaled_up = [&](const VectorBounds& difference, double factor) {
    VectorBounds bound{factor * difference.middle, factor * difference.radius};
    for (int k = 0; k < 3; ++k)
      bound.radius[k] += 4 * factor * cell.margin + kBoundSlack * std::abs(bound.middle[k]);
    return bound;
  };
  return {scaled_up(cell.second[0], n * (n - 1)), scaled_up(cell.second[1], n * m),
          scaled_up(cell.second[2], m * (m - 1))};
}

}  // namespace

SecondDerivatives second_derivatives(const Cell& cell, const NetShape& shape) {
  if (shape.planes == 3) return polynomial_seconds(cell, shape);
  const Weights weights = weights_of(cell, shape);
  const int degree = std::max(shape.rows, shape.columns) - 1;
  const double rounding = 16.0 * degree * degree * weights.spread * weights.spread * cell.margin;
  SecondDerivatives bounds;
  for (int k = 0; k < 3; ++k) {
    const SecondValues values = rational_seconds(cell, shape, weights, k);
    const auto set = [&](VectorBounds& bound, const ValueRange& range) {
      bound.middle[k] = 0.5 * (range.low + range.high);
      bound.radius[k] = 0.5 * (range.high - range.low) + rounding + kBoundSlack * magnitude(range);
    };
    set(bounds.uu, values.uu), set(bounds.uv, values.uv), set(bounds.vv, values.vv);
  }
  return bounds;
}

}  // namespace blossom
