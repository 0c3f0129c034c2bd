// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/cell_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/unbounded.h"
#include "core/cells/net_ranges.h"
#include "core/math/roundoff.h"
#include "core/subdivision/growth.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

constexpr int kMaxBlock = 1 << 15;          // doubles per block of the arena
constexpr double kDerivativeSlack = 1e-13;  // covers the few roundings of a difference of bounds

// Interval products and quotients, padded for their rounding.
Range times(const Range& a, const Range& b) {
  const double p[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  return {*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
}

Range divided(const Range& a, const Range& positive) {
  return times(a, {1 / positive.high, 1 / positive.low});
}

Range scaled(const Range& a, double s) { return {a.low * s, a.high * s}; }

}  // namespace

CellTree::CellTree(const RationalBezierPatch& patch, bool rational, const Vec3& origin,
                   CellForm form, double cut, PartTest part)
    : CellTree(patch, rational, origin, form, cut, std::move(part),
               4 * kUnitRoundoff * max_norm(origin)) {}

CellTree::CellTree(const RationalBezierPatch& patch, bool rational, const Vec3& origin,
                   CellForm form, double cut, PartTest part, double given_rounding)
    : patch_(patch),
      shape_{patch.points.rows(), patch.points.columns(), rational ? 4 : 3},
      rational_(rational),
      part_(std::move(part)),
      cut_(cut),
      given_rounding_(given_rounding),
      block_(2 * shape_.size() + (rational ? 3 * shape_.plane_size() : 0)) {
  for (Vec4& p : patch_.points.values())
    for (int k = 0; k < 3; ++k) p[k] -= p[3] * origin[k];

  double* net = allocate(shape_.size());
  double most_weight = least_weight_ = patch_.points.values().front()[3];
  for (int i = 0; i < shape_.plane_size(); ++i) {
    const Vec4& p = patch_.points.values()[static_cast<std::size_t>(i)];
    least_weight_ = std::min(least_weight_, p[3]);
    most_weight = std::max(most_weight, p[3]);
    for (int k = 0; k < shape_.planes; ++k) {
      net[k * shape_.plane_size() + i] = p[k];
      net_scale_ = std::max(net_scale_, std::abs(p[k]));
    }
  }
  root_.homogeneous = net;
  weight_spread_ = most_weight / least_weight_;

  if (form != CellForm::Bezier) choose_form(form, net);
  finish(root_);
}

// Monomial where that is asked for or rounds less.
void CellTree::choose_form(CellForm form, const double* net) {
  double* coefficients = allocate(shape_.size());
  monomial_from_bezier(shape_, net, coefficients);
  for (int k = 0; k < shape_.planes; ++k) {
    double sum = 0;
    for (int i = 0; i < shape_.plane_size(); ++i)
      sum += std::abs(coefficients[k * shape_.plane_size() + i]);
    coefficient_scale_ = std::max(coefficient_scale_, sum);
  }
  const int n = shape_.rows - 1, m = shape_.columns - 1;
  const double bound =
      monomial_from_bezier_error(n, m) * net_scale_ +
      (monomial_halving_error(std::max(n, m), 20) + bezier_from_monomial_error(n, m)) *
          coefficient_scale_;
  monomial_ = form == CellForm::Monomial || bound < halving_error(std::max(n, m), 20) * net_scale_;
  if (monomial_)
    root_.coefficients = coefficients;
  else
    free_in_block_ += shape_.size();  // the last to be taken
}

double* CellTree::allocate(int count) {
  if (count > free_in_block_) {
    free_in_block_ = std::max(count, block_);
    block_ = std::min(2 * block_, kMaxBlock);
    blocks_.push_back(
        std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(free_in_block_)));
  }
  free_in_block_ -= count;
  return blocks_.back().get() + free_in_block_;
}

int CellTree::split(int index) {
  Cell& parent = cell_at(index);
  if (parent.child >= 0) return parent.child;
  const int child = size_;
  if (static_cast<std::size_t>(child - 1) % kTogether == 0)
    halves_.push_back(std::make_unique<std::array<Cell, kTogether>>());
  std::array<double*, 2> nets{allocate(shape_.size()), allocate(shape_.size())};
  halve_net(parent, nets);
  const double middle = at(parent.split_u ? parent.u : parent.v, cut_);
  for (int side = 0; side < 2; ++side) {
    Cell& half = cell_at(child + side);
    half.u = parent.u;
    half.v = parent.v;
    Interval& along = parent.split_u ? half.u : half.v;
    (side == 0 ? along.to : along.from) = middle;
    half.depth = parent.depth + 1;
    half.part = parent.part;
    set_net(half, nets[static_cast<std::size_t>(side)]);
    finish(half);
  }
  size_ += 2;
  return parent.child = child;
}

void CellTree::halve_net(const Cell& cell, const std::array<double*, 2>& nets) const {
  if (monomial_)
    (cell.split_u ? halve_monomial_u : halve_monomial_v)(shape_, cell.coefficients, cut_, nets[0],
                                                         nets[1]);
  else
    (cell.split_u ? halve_bezier_u : halve_bezier_v)(shape_, cell.homogeneous, cut_, nets[0],
                                                     nets[1]);
}

// The net is in the tree's form.
void CellTree::set_net(Cell& cell, double* net) {
  cell.homogeneous = net;
  if (!monomial_) return;
  cell.coefficients = net;
  double* bezier = allocate(shape_.size());
  bezier_from_monomial(shape_, net, bezier);
  cell.homogeneous = bezier;
}

void CellTree::drop_cells() {
  halves_.clear();
  blocks_.clear();
  free_in_block_ = 0;
  root_ = {};
  size_ = 1;
}

CellTree CellTree::piece(const Interval& u, const Interval& v) const {
  const RationalBezierPatch part = sub_patch(patch_, u, v);
  return CellTree(part, rational_, {}, CellForm::Bezier, 0.5, {}, piece_rounding(part, u, v));
}

// Inside, points of the piece are means of those of the patch; outside, sums with weights whose
// sizes add up to the growth.
double CellTree::piece_rounding(const RationalBezierPatch& piece, const Interval& u,
                                const Interval& v) const {
  const int n = shape_.rows - 1, m = shape_.columns - 1;
  const double error = subdivision_error(std::max(n, m));
  const double given = given_rounding_ + 4 * kUnitRoundoff * hull_scale_;
  const double growth = bezier_growth(n, u) * bezier_growth(m, v);
  if (growth <= 1) return given + 2 * error * hull_scale_;
  double least = kUnbounded, reach = 0;
  for (const Vec4& p : piece.points.values()) {
    if (!(p[3] > 0)) return kUnbounded;
    least = std::min(least, p[3]);
    reach = std::max(reach, max_norm(Vec3{p[0], p[1], p[2]}) / p[3]);
  }
  const double largest = weight_spread_ * least_weight_;
  return growth * largest / least * (given + 2 * error * (hull_scale_ + reach));
}

// The error of a coordinate of the hull. Halving takes convex combinations, and positive weights
// bound |X| by w times the largest point, so in Bezier form the error of X / w is relative to
// the points in space, however much the weights vary. The patch is relative to its origin, so only
// its move there was rounded relative to the distance of that. Monomial coefficients have no such
// sign.
double CellTree::rounding_of(const Cell& cell) const {
  const int n = shape_.rows - 1, m = shape_.columns - 1;
  const int degree = std::max(n, m);
  if (!monomial_)
    return (2 * halving_error(degree, cell.depth) + 8 * kUnitRoundoff) * hull_scale_ +
           given_rounding_;
  const double error =
      monomial_from_bezier_error(n, m) * net_scale_ +
      (monomial_halving_error(degree, cell.depth) + bezier_from_monomial_error(n, m)) *
          coefficient_scale_;
  const double of_net = rational_ ? (error / least_weight_) * (1 + hull_scale_) : error;
  return of_net + 8 * kUnitRoundoff * hull_scale_ + given_rounding_;
}

// Everything that follows from the net.
void CellTree::finish(Cell& cell) {
  if (part_ && cell.part == PartSide::Mixed) cell.part = part_(cell.u, cell.v);
  make_hull(cell);
  if (cell.depth == 0)
    for (int i = 0; i < 3 * shape_.plane_size(); ++i)
      hull_scale_ = std::max(hull_scale_, std::abs(cell.hull[i]));
  cell.margin = rounding_of(cell);
  for (int k = 0; k < 3; ++k) {
    const Range range = value_range(cell.hull + k * shape_.plane_size(), shape_.plane_size());
    cell.low[k] = range.low - cell.margin;
    cell.high[k] = range.high + cell.margin;
  }
  cell.extent = distance(cell.low, cell.high);

  const double* p = cell.hull;
  const int size = shape_.plane_size(), last = size - 1, columns = shape_.columns;
  const auto point = [&](int i) { return Vec3{p[i], p[i + size], p[i + 2 * size]}; };
  const Vec3 across = point(last - columns + 1) - point(columns - 1);
  cell.plane.normal = unit(cross(across, point(last) - point(0)));
  const Vec3& normal = cell.plane.normal;
  const Range heights = height_range(p, size, normal);
  // |normal| <= 1 turns the margin of three coordinates into at most sqrt(3) of it.
  cell.plane.low = heights.low - 2 * cell.margin;
  cell.plane.high = heights.high + 2 * cell.margin;

  rational_ ? bound_rational_derivatives(cell) : bound_polynomial_derivatives(cell);
  choose_direction(cell);
}

void CellTree::make_hull(Cell& cell) {
  if (!rational_) {
    cell.hull = cell.homogeneous;
    return;
  }
  const int size = shape_.plane_size();
  double* hull = allocate(3 * size);
  const double* weight = cell.homogeneous + 3 * size;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < size; ++i) hull[k * size + i] = cell.homogeneous[k * size + i] / weight[i];
  cell.hull = hull;
}

void CellTree::bound_polynomial_derivatives(Cell& cell) const {
  const int n = shape_.rows - 1, m = shape_.columns - 1;
  for (int k = 0; k < 3; ++k) {
    const double* plane = cell.hull + k * shape_.plane_size();
    const Range du = difference_range_u(plane, shape_.rows, shape_.columns);
    const Range dv = difference_range_v(plane, shape_.rows, shape_.columns);
    cell.du.middle[k] = 0.5 * n * (du.low + du.high);
    cell.du.radius[k] = n * (0.5 * (du.high - du.low) + 2 * cell.margin);
    cell.dv.middle[k] = 0.5 * m * (dv.low + dv.high);
    cell.dv.radius[k] = m * (0.5 * (dv.high - dv.low) + 2 * cell.margin);
  }
}

// With the origin O moved into the cell, X' = X - w O and S = X / w:
//   S_u = (X'_u - (S - O) w_u) / w
// so that the product, the loose term, is of second order in the cell's size.
void CellTree::bound_rational_derivatives(Cell& cell) const {
  const int rows = shape_.rows, columns = shape_.columns, size = shape_.plane_size();
  const double* weight = cell.homogeneous + 3 * size;
  Range w = value_range(weight, size);
  const double spread = w.high / w.low;  // errors are relative to the largest weight
  w = {w.low * (1 - kDerivativeSlack), w.high * (1 + kDerivativeSlack)};
  const Range wu = scaled(difference_range_u(weight, rows, columns), rows - 1);
  const Range wv = scaled(difference_range_v(weight, rows, columns), columns - 1);
  std::array<double, (kMaxDegree + 1) * (kMaxDegree + 1)> moved;
  for (int k = 0; k < 3; ++k) {
    const double origin = 0.5 * (cell.low[k] + cell.high[k]);
    const double* x = cell.homogeneous + k * size;
    for (int i = 0; i < size; ++i) moved[static_cast<std::size_t>(i)] = x[i] - weight[i] * origin;
    const Range offset{cell.low[k] - origin, cell.high[k] - origin};
    const auto bound = [&](const Range& dx, const Range& dw, int degree) {
      const Range product = times(offset, dw);
      const Range quotient = divided({dx.low - product.high, dx.high - product.low}, w);
      const double slack = 4 * degree * spread * cell.margin +
                           kDerivativeSlack * std::max(std::abs(quotient.low), quotient.high);
      return Range{quotient.low - slack, quotient.high + slack};
    };
    const Range du =
        bound(scaled(difference_range_u(moved.data(), rows, columns), rows - 1), wu, rows - 1);
    const Range dv = bound(scaled(difference_range_v(moved.data(), rows, columns), columns - 1), wv,
                           columns - 1);
    cell.du.middle[k] = 0.5 * (du.low + du.high);
    cell.du.radius[k] = 0.5 * (du.high - du.low);
    cell.dv.middle[k] = 0.5 * (dv.low + dv.high);
    cell.dv.radius[k] = 0.5 * (dv.high - dv.low);
  }
}

// Halve the direction along which the derivatives change most: second differences of the hull.
// Extent counts a little, so that flat cells are halved across their longer side.
void CellTree::choose_direction(Cell& cell) const {
  constexpr double kExtentWeight = 0.05;
  const int rows = shape_.rows, columns = shape_.columns, size = shape_.plane_size();
  double along_u = 0, along_v = 0, twist = 0, length_u = 0, length_v = 0;
  for (int k = 0; k < 3; ++k) {
    const SecondRanges ranges = second_difference_ranges(cell.hull + k * size, rows, columns);
    const auto largest = [&](const Range& range, VectorBounds& second) {
      second.middle[k] = 0.5 * (range.low + range.high);
      second.radius[k] = 0.5 * (range.high - range.low);
      return std::max(-range.low, range.high);
    };
    along_u = std::max(along_u, largest(ranges.uu, cell.second[0]));
    twist = std::max(twist, largest(ranges.uv, cell.second[1]));
    along_v = std::max(along_v, largest(ranges.vv, cell.second[2]));
    length_u = std::max(length_u, std::abs(cell.du.middle[k]) + cell.du.radius[k]);
    length_v = std::max(length_v, std::abs(cell.dv.middle[k]) + cell.dv.radius[k]);
  }
  const int n = rows - 1, m = columns - 1;
  along_u *= n * (n - 1);
  along_v *= m * (m - 1);
  cell.split_u = along_u + kExtentWeight * length_u >= along_v + kExtentWeight * length_v;
  cell.bend = along_u + along_v + n * m * twist;
}

}  // namespace blossom
