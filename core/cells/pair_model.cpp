// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/pair_model.h"

#include <algorithm>
#include <cmath>

#include "core/cells/net_ranges.h"
#include "core/forms/evaluation.h"
#include "core/math/four.h"
#include "core/math/functions/quadratic.h"

namespace blossom {
namespace {

constexpr double kSumSlack = 1e-12;    // covers the roundings of sums of bounds, relative
constexpr double kPlaceSlack = 1e-14;  // and of places in a cell

Vec3 same(double x) { return {x, x, x}; }

// Largest absolute uu, uv, vv.
std::array<Vec3, 3> largest(const SecondDerivatives& second) {
  const auto of = [](const VectorBounds& x) { return absolute(x.middle) + x.radius; };
  return {of(second.uu), of(second.uv), of(second.vv)};
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

// How far a cell lies at most from the plane by its middle's derivatives.
Vec3 bend_of(const std::array<Vec3, 3>& most) { return 0.125 * (most[0] + 2 * most[1] + most[2]); }

// A parameter of b over the point (z1, z2) of a: constant + slope . z +- error.
struct Foot {
  double constant;
  std::array<double, 2> slope;
  double error;
};

// Narrows z to where the foot may lie in b; false if it does nowhere.
bool clip(const Foot& foot, std::array<Interval, 2>& z) {
  const double reach = 0.5 + foot.error + kSumSlack;
  for (std::size_t k = 0; k < 2; ++k) {
    const double slope = foot.slope[k], other = foot.slope[1 - k];
    const auto [least, most] = std::minmax({other * z[1 - k].from, other * z[1 - k].to});
    const auto [low, high] = std::minmax(
        {(-reach - foot.constant - most) / slope, (reach - foot.constant - least) / slope});
    if (!std::isfinite(low) || !std::isfinite(high)) continue;
    z[k] = {std::max(z[k].from, low - kSumSlack), std::min(z[k].to, high + kSumSlack)};
    if (z[k].from > z[k].to) return false;
  }
  return true;
}

// Adds factor z3 z4, by its feet, to f; returns how far the true product may be off.
double add_product(Quadratic& f, double factor, const Foot& p, const Foot& q) {
  f.constant += factor * p.constant * q.constant;
  f.x += factor * (p.constant * q.slope[0] + p.slope[0] * q.constant);
  f.y += factor * (p.constant * q.slope[1] + p.slope[1] * q.constant);
  f.xx += factor * p.slope[0] * q.slope[0];
  f.xy += factor * (p.slope[0] * q.slope[1] + p.slope[1] * q.slope[0]);
  f.yy += factor * p.slope[1] * q.slope[1];
  return std::abs(factor) * (0.5 * q.error + (0.5 + q.error) * p.error);
}

// Half of the second derivatives along n in the middle of their bounds.
Quadratic bent_along(const Vec3& n, const SecondDerivatives& second) {
  return {0,
          0,
          0,
          0.5 * dot(n, second.uu.middle),
          dot(n, second.uv.middle),
          0.5 * dot(n, second.vv.middle)};
}

// How far the heights n . p over a cell are at most from those by `slope` and `bent` round its
// middle, constants aside. Of polynomials the nets tell more than the second derivatives do.
double rest_of(const CellTree& tree, const Cell& cell, const Vec3& n, const Quadratic& heights,
               const SecondDerivatives& second) {
  const NetShape& shape = tree.shape();
  const Vec3 spread = bend_of({second.uu.radius, second.uv.radius, second.vv.radius});
  if (shape.planes == 4) return dot(absolute(n), spread);
  Quadratic known = heights;
  known.constant = dot(n, point_at(tree.patch(), at(cell.u, 0.5), at(cell.v, 0.5)));
  const Range rest = height_range(cell.hull, shape.rows, shape.columns, n, known);
  return std::max(-rest.low, rest.high) + 4 * cell.margin;
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
    : tree_a_(tree_a),
      tree_b_(tree_b),
      a_(a),
      b_(b),
      box_{a.u, a.v, b.u, b.v},
      whole_(a, b),
      second_a_(second_derivatives(a, tree_a.shape())),
      second_b_(second_derivatives(b, tree_b.shape())),
      most_a_(largest(second_a_)),
      most_b_(largest(second_b_)),
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
  const PatchJet a = jet_at(tree_a_.patch(), x[0], x[1], 1),
                 b = jet_at(tree_b_.patch(), x[2], x[3], 1);
  return {place,
          a.point - b.point,
          {length(box_[0]) * a.u, length(box_[1]) * a.v, -length(box_[2]) * b.u,
           -length(box_[3]) * b.v}};
}

// Rows of the inverse of (B_s, B_t, n) take F apart: along the tangents of b they say where the
// points of a lie over b, and n how high.
bool PairModel::are_disjoint(double least) const {
  const PairJet jet = this->jet({});
  const Vec3 s = -jet.columns[2], t = -jet.columns[3], normal = cross(s, t);
  const double square = dot(normal, normal);
  if (!std::isfinite(1 / square)) return false;
  const Vec3 bend = bend_of(most_a_) + bend_of(most_b_);
  // Twice the rounding of F: points in the middle are computed with and without derivatives.
  Vec3 error = 2 * rounding_ + kSumSlack * (absolute(jet.gap) + bend);
  for (std::size_t k = 0; k < 4; ++k)
    error = error + 0.5 * slope_rounding_[k] + kSumSlack * absolute(jet.columns[k]);
  // How the inverse fails to be one counts as error, too.
  const auto part_along = [&](const Vec3& row, const Vec3& other, double of_s, double of_t) {
    const double rest = 0.5 * (std::abs(of_s - dot(row, s)) + std::abs(of_t - dot(row, t)));
    return Foot{dot(row, jet.gap),
                {dot(row, jet.columns[0]), dot(row, jet.columns[1])},
                dot(absolute(row), other + error) + rest};
  };
  const Foot on_s = part_along(cross(t, normal) * (1 / square), bend, 1, 0);
  const Foot on_t = part_along(cross(normal, s) * (1 / square), bend, 0, 1);
  std::array<Interval, 2> z{Interval{-0.5, 0.5}, Interval{-0.5, 0.5}};
  if (!clip(on_s, z) || !clip(on_t, z)) return true;

  const Vec3 n = unit(normal);
  const Foot height = part_along(n, {}, 0, 0);
  const Quadratic over_a = bent_along(n, second_a_), over_b = bent_along(n, second_b_);
  Quadratic gap{height.constant, height.slope[0], height.slope[1], over_a.xx, over_a.xy, over_a.yy};
  double off = height.error + rest_of(tree_a_, a_, n, gap, second_a_) +
               rest_of(tree_b_, b_, n, over_b, second_b_);
  off += add_product(gap, -over_b.xx, on_s, on_s) + add_product(gap, -over_b.xy, on_s, on_t) +
         add_product(gap, -over_b.yy, on_t, on_t);
  off += kSumSlack * size(gap) + least;
  const PolynomialRange heights = range(gap, z[0], z[1]);
  return heights.low > off || heights.high < -off;
}

BoundedVector PairModel::gap(const std::array<double, 4>& place) const {
  const auto x = parameters(place);
  return {point_at(tree_a_.patch(), x[0], x[1]) - point_at(tree_b_.patch(), x[2], x[3]), rounding_};
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
  return JacobianBounds({column(0, most_a_[0], most_a_[1]), column(1, most_a_[1], most_a_[2]),
                         column(2, most_b_[0], most_b_[1]), column(3, most_b_[1], most_b_[2])});
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
