// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/cells/pair_model.h"

#include <algorithm>
#include <cmath>

#include "core/forms/evaluation.h"
#include "core/math/four.h"

namespace blossom {
namespace {

constexpr double kSumSlack = 1e-12;    // covers the roundings of sums of bounds, relative
constexpr double kPlaceSlack = 1e-14;  // and of places in a cell

Vec3 same(double x) { return {x, x, x}; }

// Largest absolute uu, uv, vv over a cell; of a polynomial one by the differences of its net.
std::array<Vec3, 3> largest_second(const CellTree& tree, const Cell& cell) {
  const NetShape& shape = tree.shape();
  if (shape.planes == 4) {
    const auto [uu, uv, vv] = second_derivatives(cell, shape);
    const auto of = [](const VectorBounds& x) { return absolute(x.middle) + x.radius; };
    return {of(uu), of(uv), of(vv)};
  }
  const int n = shape.rows - 1, m = shape.columns - 1;
  const Vec3 rounding = same(4 * cell.margin);  // of a second difference
  return {n * (n - 1) * (cell.second[0] + rounding), n * m * (cell.second[1] + rounding),
          m * (m - 1) * (cell.second[2] + rounding)};
}

// Of a point: of sums over both directions, the quotient by the weight, and the patch's own move.
double rounding_of(const CellTree& tree) {
  const NetShape& shape = tree.shape();
  return (evaluation_error(shape.rows) + evaluation_error(shape.columns)) * tree.scale() +
         tree.given_rounding();
}

// Of a derivative by the patch's parameters.
double slope_rounding_of(const CellTree& tree) {
  const int degree = std::max(tree.shape().rows, tree.shape().columns) - 1;
  return 8 * degree * tree.weight_spread() * rounding_of(tree);
}

// What two bounds of one vector leave of each other.
VectorBounds common(const VectorBounds& a, const VectorBounds& b) {
  VectorBounds result;
  for (int k = 0; k < 3; ++k) {
    const double low = std::max(a.middle[k] - a.radius[k], b.middle[k] - b.radius[k]);
    const double high = std::min(a.middle[k] + a.radius[k], b.middle[k] + b.radius[k]);
    result.middle[k] = 0.5 * (low + high);
    result.radius[k] = std::max(0.5 * (high - low), 0.0) + kSumSlack * std::abs(result.middle[k]);
  }
  return result;
}

}  // namespace

PairModel::PairModel(const CellTree& tree_a, const Cell& a, const CellTree& tree_b, const Cell& b)
    : patch_a_(tree_a.patch()),
      patch_b_(tree_b.patch()),
      box_{a.u, a.v, b.u, b.v},
      whole_(a, b),
      second_a_(largest_second(tree_a, a)),
      second_b_(largest_second(tree_b, b)),
      rounding_(same(rounding_of(tree_a) + rounding_of(tree_b))) {
  // Derivatives are by the patches' parameters first.
  const double of_a = slope_rounding_of(tree_a), of_b = slope_rounding_of(tree_b);
  for (std::size_t k = 0; k < 4; ++k)
    slope_rounding_[k] = same(length(box_[k]) * (k < 2 ? of_a : of_b));
}

std::array<double, 4> PairModel::parameters(const std::array<double, 4>& place) const {
  std::array<double, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = at(box_[i], place[i] + 0.5);
  return x;
}

PairJet PairModel::jet(const std::array<double, 4>& place) const {
  const auto x = parameters(place);
  const PatchJet a = jet_at(patch_a_, x[0], x[1], 1), b = jet_at(patch_b_, x[2], x[3], 1);
  return {place,
          a.point - b.point,
          {length(box_[0]) * a.u, length(box_[1]) * a.v, -length(box_[2]) * b.u,
           -length(box_[3]) * b.v}};
}

BoundedVector PairModel::gap(const std::array<double, 4>& place) const {
  const auto x = parameters(place);
  return {point_at(patch_a_, x[0], x[1]) - point_at(patch_b_, x[2], x[3]), rounding_};
}

JacobianBounds PairModel::jacobian(const PairJet& jet, const PairPart& part) const {
  return jacobian_within(jet, part, 1);
}

JacobianBounds PairModel::mean_jacobian(const PairJet& jet, const PairPart& part) const {
  return jacobian_within(jet, part, 0.5);
}

BLOSSOM_HOT JacobianBounds PairModel::jacobian_within(const PairJet& jet, const PairPart& part,
                                                      double share) const {
  std::array<double, 4> reach;
  for (std::size_t i = 0; i < 4; ++i)
    reach[i] = share * (std::abs(part.middle[i] - jet.place[i]) + part.radius[i]);
  const auto column = [&](std::size_t k, const Vec3& by_first, const Vec3& by_second) {
    const std::size_t first = k < 2 ? 0 : 2;
    const Vec3 change = reach[first] * by_first + reach[first + 1] * by_second;
    return common({jet.columns[k], (1 + kSumSlack) * change + slope_rounding_[k]},
                  whole_.column(static_cast<int>(k)));
  };
  return JacobianBounds(
      {column(0, second_a_[0], second_a_[1]), column(1, second_a_[1], second_a_[2]),
       column(2, second_b_[0], second_b_[1]), column(3, second_b_[1], second_b_[2])});
}

BLOSSOM_HOT bool narrow(PairPart& part, const Minor& minor, int left_out,
                        const VectorBounds& column, const std::array<double, 4>& place,
                        const BoundedVector& gap) {
  const auto kept = kept_columns(left_out);
  const auto out = static_cast<std::size_t>(left_out);
  const double step = part.middle[out] - place[out], reach = part.radius[out];
  PairPart next = part;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(kept[i]);
    double shift = 0, slope = 0, spread = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto axis = static_cast<int>(j);
      const auto l = static_cast<std::size_t>(kept[j]);
      const double c = minor.inverse[i][j];
      shift += c * gap.value[axis];
      slope += c * column.middle[axis];
      spread += minor.spread[i][j] * (std::abs(part.middle[l] - place[l]) + part.radius[l]) +
                std::abs(c) * (gap.error[axis] + (std::abs(step) + reach) * column.radius[axis]);
    }
    spread = (spread + std::abs(slope) * reach) * (1 + kSumSlack) + kPlaceSlack;
    const double middle = place[k] - shift - slope * step;
    const double low = std::max(middle - spread, part.middle[k] - part.radius[k]);
    const double high = std::min(middle + spread, part.middle[k] + part.radius[k]);
    if (low > high) return false;
    next.middle[k] = 0.5 * (low + high);
    next.radius[k] = 0.5 * (high - low);
  }
  part = next;
  return true;
}

}  // namespace blossom
