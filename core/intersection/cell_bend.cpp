// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/cell_bend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/intersection/curve_cells.h"

namespace blossom {
namespace {

constexpr double kSlack = 1e-12;  // covers the few roundings of a sum or product of bounds

enum class Second { UU, UV, VV };

ValueRange times(const ValueRange& a, const ValueRange& b) {
  const auto [least, most] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {least, most};
}

ValueRange sum(const ValueRange& a, const ValueRange& b) {
  return {a.low + b.low, a.high + b.high};
}

ValueRange minus(const ValueRange& a, const ValueRange& b) {
  return {a.low - b.high, a.high - b.low};
}

ValueRange range_of(const VectorBounds& bounds, int k) {
  return {bounds.middle[k] - bounds.radius[k], bounds.middle[k] + bounds.radius[k]};
}

// Differences of a plane's values, n (n - 1), n m or m (m - 1) times: a second derivative's net.
ValueRange second_range(const double* plane, const NetShape& shape, Second which) {
  const int rows = shape.rows, columns = shape.columns, n = rows - 1, m = columns - 1;
  const int last_i = which == Second::UU ? rows - 2 : which == Second::UV ? rows - 1 : rows;
  const int last_j = which == Second::VV   ? columns - 2
                     : which == Second::UV ? columns - 1
                                           : columns;
  const int step = which == Second::UU ? columns : 1;
  const double factor = which == Second::UU   ? n * (n - 1)
                        : which == Second::UV ? n * m
                                              : m * (m - 1);
  if (last_i <= 0 || last_j <= 0) return {0, 0};
  ValueRange range{1e300, -1e300};
  for (int i = 0; i < last_i; ++i)
    for (int j = 0; j < last_j; ++j) {
      const double* p = plane + i * columns + j;
      const double d = which == Second::UV ? p[columns + 1] - p[columns] - p[1] + p[0]
                                           : p[2 * step] - 2 * p[step] + p[0];
      range = {std::min(range.low, d), std::max(range.high, d)};
    }
  return {factor * range.low, factor * range.high};
}

// First differences of the weights, as the derivative's net.
ValueRange weight_range(const double* plane, const NetShape& shape, bool along_u) {
  const int step = along_u ? shape.columns : 1;
  const int last_i = shape.rows - (along_u ? 1 : 0), last_j = shape.columns - (along_u ? 0 : 1);
  const double factor = along_u ? shape.rows - 1 : shape.columns - 1;
  ValueRange range{1e300, -1e300};
  for (int i = 0; i < last_i; ++i)
    for (int j = 0; j < last_j; ++j) {
      const double* p = plane + i * shape.columns + j;
      range = {std::min(range.low, p[step] - p[0]), std::max(range.high, p[step] - p[0])};
    }
  return {factor * range.low, factor * range.high};
}

double magnitude(const ValueRange& range) {
  return std::max(std::abs(range.low), std::abs(range.high));
}

// The weights of a rational cell and what of them the quotient rule takes.
struct Weights {
  const double* net;
  ValueRange over;  // 1 / w
  ValueRange u, v, uu, uv, vv;
  double spread;  // errors are relative to the largest weight
};

Weights weights_of(const Cell& cell, const NetShape& shape) {
  const double* w = cell.homogeneous + 3 * shape.plane_size();
  const auto [least, most] = std::minmax_element(w, w + shape.plane_size());
  return {w,
          {(1 - kSlack) / *most, (1 + kSlack) / *least},
          weight_range(w, shape, true),
          weight_range(w, shape, false),
          second_range(w, shape, Second::UU),
          second_range(w, shape, Second::UV),
          second_range(w, shape, Second::VV),
          *most / *least};
}

// The numerator of a second derivative over the weight, in one coordinate.
ValueRange rational_second(const Cell& cell, const NetShape& shape, const Weights& w, int k,
                           Second which) {
  const int size = shape.plane_size();
  const double origin = 0.5 * (cell.low[k] + cell.high[k]);
  std::array<double, (kMaxDegree + 1) * (kMaxDegree + 1)> moved;
  for (int i = 0; i < size; ++i)
    moved[static_cast<std::size_t>(i)] = cell.homogeneous[k * size + i] - w.net[i] * origin;
  const ValueRange offset{cell.low[k] - origin, cell.high[k] - origin};
  const ValueRange su = range_of(cell.du, k), sv = range_of(cell.dv, k);
  const ValueRange product = which == Second::UU   ? sum(times(w.u, su), times(w.u, su))
                             : which == Second::UV ? sum(times(w.u, sv), times(w.v, su))
                                                   : sum(times(w.v, sv), times(w.v, sv));
  const ValueRange& w2 = which == Second::UU ? w.uu : which == Second::UV ? w.uv : w.vv;
  const ValueRange x2 = second_range(moved.data(), shape, which);
  return times(minus(minus(x2, product), times(offset, w2)), w.over);
}

VectorBounds second_bounds(const Cell& cell, const NetShape& shape, const Weights* weights,
                           Second which) {
  const int degree = std::max(shape.rows, shape.columns) - 1;
  VectorBounds bounds;
  for (int k = 0; k < 3; ++k) {
    const ValueRange range = weights == nullptr
                                 ? second_range(cell.hull + k * shape.plane_size(), shape, which)
                                 : rational_second(cell, shape, *weights, k, which);
    const double spread = weights == nullptr ? 1 : weights->spread * weights->spread;
    bounds.middle[k] = 0.5 * (range.low + range.high);
    bounds.radius[k] = 0.5 * (range.high - range.low) +
                       16.0 * degree * degree * spread * cell.margin + kSlack * magnitude(range);
  }
  return bounds;
}

}  // namespace

SecondDerivatives second_derivatives(const Cell& cell, const NetShape& shape) {
  const bool rational = shape.planes == 4;
  const Weights weights = rational ? weights_of(cell, shape) : Weights{};
  const Weights* const used = rational ? &weights : nullptr;
  return {second_bounds(cell, shape, used, Second::UU),
          second_bounds(cell, shape, used, Second::UV),
          second_bounds(cell, shape, used, Second::VV)};
}

}  // namespace blossom
