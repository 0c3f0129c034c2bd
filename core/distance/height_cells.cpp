// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/height_cells.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/math/value_range.h"

namespace blossom {
namespace {

// De Casteljau's triangle at 1/2 over a row of a net: `high` is the row, then its upper half.
void halve(double* low, double* high, int count, int stride) {
  for (int level = 1; level < count; ++level) {
    for (int i = 0; i < count - level; ++i)
      high[i * stride] = 0.5 * (high[i * stride] + high[(i + 1) * stride]);
    low[level * stride] = high[0];
  }
}

// A net of heights above a level, times their weights.
struct RaisedNet {
  const double* heights;
  const double* weights;  // null: they are 1
  double level;

  double operator[](int k) const {
    return weights ? heights[k] - level * weights[k] : heights[k] - level;
  }
};

// Differences of neighbours in one direction of a net.
struct HeightSlopes {
  ValueRange raised{kInfinity, -kInfinity}, weights{0, 0};
  double most = 0;
};

HeightSlopes slopes(const RaisedNet& net, int rows, int columns, bool along_u) {
  HeightSlopes result;
  const int step = along_u ? columns : 1;
  for (int i = 0; i < (along_u ? rows - 1 : rows); ++i)
    for (int j = 0; j < (along_u ? columns : columns - 1); ++j) {
      const int k = i * columns + j;
      const double slope = net[k + step] - net[k];
      result.raised = {std::min(result.raised.low, slope), std::max(result.raised.high, slope)};
      if (!net.weights) continue;
      const double turn = net.weights[k + step] - net.weights[k];
      result.weights = {std::min(result.weights.low, turn), std::max(result.weights.high, turn)};
    }
  result.most = std::max(result.raised.high, -result.raised.low);
  return result;
}

// With g = w (f - level) the derivative of f is (w g' - g w') / w^2. Where f is above the level,
// 0 <= g <= top: there it has the sign of g' if w' cannot make up for it.
bool has_one_sign(const HeightSlopes& of, double top, double least_weight, double rounding) {
  const double up = (of.raised.low - rounding) * least_weight - top * of.weights.high;
  const double down = (-of.raised.high - rounding) * least_weight + top * of.weights.low;
  return (of.raised.low > rounding && up > 0) || (of.raised.high < -rounding && down > 0);
}

}  // namespace

std::size_t HeightCells::room_for(std::size_t numbers) {
  const auto power = static_cast<std::size_t>(std::bit_width(numbers - 1));
  if (!free_[power].empty()) {
    const std::size_t at = free_[power].back();
    free_[power].pop_back();
    return at;
  }
  const std::size_t at = store_.size();
  store_.resize(at + (std::size_t{1} << power));
  return at;
}

void HeightCells::release(const HeightNet& net) {
  free_[static_cast<std::size_t>(std::bit_width(net.numbers() - 1))].push_back(net.at);
}

HeightNet HeightCells::load(const RationalBezierPatch& patch, bool rational, bool is_curve,
                            int axis, double sign) {
  HeightNet net{0, patch.points.rows(), is_curve ? 1 : patch.points.columns(), rational};
  net.at = room_for(net.numbers());
  double* heights = store_.data() + net.at;
  double* weights = heights + net.size();
  for (int i = 0; i < net.rows; ++i)
    for (int j = 0; j < net.columns; ++j) {
      const Vec4& point = patch.points(i, j);
      *heights++ = sign * point[axis];
      if (rational) *weights++ = point[3];
    }
  return net;
}

HeightNet HeightCells::split(const HeightNet& net, bool along_u) {
  HeightNet upper = net;
  upper.at = room_for(net.numbers());
  double* low = store_.data() + net.at;
  double* high = store_.data() + upper.at;
  std::copy_n(low, net.numbers(), high);
  const int count = along_u ? net.rows : net.columns;
  const int stride = along_u ? net.columns : 1;
  for (int first = 0; first < static_cast<int>(net.numbers()); first += net.size())
    for (int row = 0; row < net.size() / count; ++row) {
      const int at = first + (along_u ? row : row * net.columns);
      halve(low + at, high + at, count, stride);
    }
  return upper;
}

HeightBounds HeightCells::bounds(const HeightNet& net, double wanted,
                                 const std::array<bool, 2>& across, double rounding) const {
  const double* heights = store_.data() + net.at;
  const double* weights = net.rational ? heights + net.size() : nullptr;
  ValueRange range{kInfinity, -kInfinity},
      of_weights{net.rational ? kInfinity : 1, net.rational ? 0.0 : 1.0};
  double largest = 0;
  for (int k = 0; k < net.size(); ++k) {
    const double height = weights ? heights[k] / weights[k] : heights[k];
    range = {std::min(range.low, height), std::max(range.high, height)};
    largest = std::max(largest, std::abs(heights[k]));
    if (weights)
      of_weights = {std::min(of_weights.low, weights[k]), std::max(of_weights.high, weights[k])};
  }
  // All of the cell is above its least coefficient: a level that is no lower serves as well.
  const double level = std::max(wanted, range.low);
  const double error = rounding * (largest + std::abs(level) * of_weights.high);
  HeightBounds result{range.high + error / of_weights.low};
  if (result.upper <= wanted) return result;
  const RaisedNet raised{heights, weights, level};
  const double top = (result.upper - level) * of_weights.high;
  const HeightSlopes along_u = slopes(raised, net.rows, net.columns, true);
  result.may_be_highest = !across[0] || !has_one_sign(along_u, top, of_weights.low, 2 * error);
  if (net.columns == 1 || !result.may_be_highest) return result;
  const HeightSlopes along_v = slopes(raised, net.rows, net.columns, false);
  result.may_be_highest = !across[1] || !has_one_sign(along_v, top, of_weights.low, 2 * error);
  result.varies_along_u = along_u.most * (net.rows - 1) >= along_v.most * (net.columns - 1);
  return result;
}

double HeightCells::corner(const HeightNet& net, bool last_row, bool last_column) const {
  const int k = (last_row ? (net.rows - 1) * net.columns : 0) + (last_column ? net.columns - 1 : 0);
  const double* heights = store_.data() + net.at;
  return net.rational ? heights[k] / heights[net.size() + k] : heights[k];
}

}  // namespace blossom
