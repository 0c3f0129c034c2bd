// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/quadric_band.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/math/binomial.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

constexpr int kMaxPoints = 64;  // of a net: the cost is their square
constexpr double kTight = 0.5;  // of the tolerance: with kSteep distances are within it
constexpr double kSteep = 0.5;

using Net = std::array<Vec4, kMaxPoints>;
using Form = std::array<double, 4 * kMaxPoints>;  // (2n + 1)(2m + 1) < 4 (n + 1)(m + 1)

struct CellForm2 {
  int rows = 0, columns = 0;
  Form value{};   // coefficients of q(X), each times its binomials
  Form weight{};  // of w^2, likewise
};

// The points times their binomials, so that products are sums over equal indices.
Net scaled_net(const Cell& cell, const NetShape& shape) {
  Net net;
  const int size = shape.plane_size();
  for (int i = 0; i < shape.rows; ++i)
    for (int j = 0; j < shape.columns; ++j) {
      const int at = i * shape.columns + j;
      const double b = binomial(shape.rows - 1, i) * binomial(shape.columns - 1, j);
      Vec4& x = net[static_cast<std::size_t>(at)];
      for (int k = 0; k < 3; ++k) x[k] = b * cell.homogeneous[k * size + at];
      x[3] = shape.planes == 4 ? b * cell.homogeneous[3 * size + at] : b;
    }
  return net;
}

Vec4 product(const Quadric& q, const Vec4& x) {
  Vec4 y;
  for (int i = 0; i < 4; ++i) {
    const auto& row = q.matrix[static_cast<std::size_t>(i)];
    y[i] = row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3] * x[3];
  }
  return y;
}

CellForm2 form_of(const Quadric& q, const Cell& cell, const NetShape& shape) {
  const Net net = scaled_net(cell, shape);
  const int size = shape.plane_size(), columns = shape.columns;
  CellForm2 form{2 * shape.rows - 1, 2 * columns - 1, {}, {}};
  for (int p = 0; p < size; ++p) {
    const Vec4& x = net[static_cast<std::size_t>(p)];
    const Vec4 y = product(q, x);
    for (int r = p; r < size; ++r) {
      const Vec4& z = net[static_cast<std::size_t>(r)];
      const double twice = r == p ? 1 : 2;
      const int i = p / columns + r / columns, j = p % columns + r % columns;
      const auto at = static_cast<std::size_t>(i * form.columns + j);
      form.value[at] += twice * (y[0] * z[0] + y[1] * z[1] + y[2] * z[2] + y[3] * z[3]);
      form.weight[at] += twice * x[3] * z[3];
    }
  }
  return form;
}

// Bound on the error of a value in space beside `other`, over the cell: by the rounding of its
// points, of its weights, which is no larger relative to them, and of the sums. Each coefficient is
// a mean of products, with weights w_i w_j.
double error_of(const Quadric& q, const Cell& cell, const NetShape& shape, double other) {
  Vec4 most{0, 0, 0, 1};
  for (int k = 0; k < 3; ++k) most[k] = std::max(std::abs(cell.low[k]), std::abs(cell.high[k]));
  double sum = 0, slope = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double c =
          std::abs(q.matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]) * most[j];
      sum += c * most[i];
      if (i < 3) slope += 2 * c;
    }
  const double relative = cell.margin / std::max({most[0], most[1], most[2]});
  return ((shape.plane_size() + 24) * kUnitRoundoff + 4 * relative) * (sum + other) +
         slope * cell.margin;
}

Vec3 corner_of(const Vec3& low, const Vec3& high, int corner) {
  return {(corner & 1) != 0 ? high[0] : low[0], (corner & 2) != 0 ? high[1] : low[1],
          (corner & 4) != 0 ? high[2] : low[2]};
}

double largest_slope(const Quadric& q, const Vec3& low, const Vec3& high) {
  Vec3 most;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 g = q.gradient(corner_of(low, high, corner));
    for (int k = 0; k < 3; ++k) most[k] = std::max(most[k], std::abs(g[k]));
  }
  return norm(most);
}

// The values of |grad q|^2.
Quadric square_of_slope(const Quadric& q) {
  Quadric square;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        square.matrix[i][j] += 4 * q.matrix[k][i] * q.matrix[k][j];
  return square;
}

// Bound on the change of a gradient by the distance.
double largest_bend(const Quadric& q) {
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) squares += q.matrix[i][j] * q.matrix[i][j];
  return 2 * std::sqrt(squares);
}

}  // namespace

double QuadricBand::largest_over(const Cell& cell, const NetShape& shape) const {
  const CellForm2 form = form_of(quadric_, cell, shape);
  double largest = 0;
  for (int k = 0; k < form.rows * form.columns; ++k) {
    const auto at = static_cast<std::size_t>(k);
    largest = std::max(largest, std::abs(form.value[at]) / form.weight[at]);
  }
  return largest + error_of(quadric_, cell, shape, largest);
}

std::optional<QuadricBand> QuadricBand::of(const CellTree& tree, double tolerance) {
  const auto quadric = quadric_of(tree.patch());
  if (!quadric) return std::nullopt;
  const Vec3 by{tolerance, tolerance, tolerance};
  QuadricBand band;
  band.quadric_ = *quadric;
  band.tolerance_ = tolerance;
  band.off_ = band.largest_over(tree[0], tree.shape());
  band.half_ = band.off_ + tolerance * largest_slope(*quadric, tree[0].low - by, tree[0].high + by);
  return band;
}

bool QuadricBand::holds_tightly(const CellTree& other) const {
  return spread_over(other[0], other.shape()) <= kTight;
}

double QuadricBand::spread_over(const Cell& cell, const NetShape& shape) const {
  if (shape.plane_size() > kMaxPoints) return kInfinity;
  return (off_ + largest_over(cell, shape)) / tolerance_;
}

// The form tells more than the box where only the direction of the gradient turns.
bool QuadricBand::is_steep_in(const Cell& cell, const NetShape& shape, double part) const {
  if (is_steep_in_box_of(cell, std::max(part, kSteep))) return true;
  if (part <= kSteep || shape.plane_size() > kMaxPoints) return false;
  const Quadric square = square_of_slope(quadric_);
  const CellForm2 form = form_of(square, cell, shape);
  double least = kInfinity, most = 0;
  for (int k = 0; k < form.rows * form.columns; ++k) {
    const auto at = static_cast<std::size_t>(k);
    least = std::min(least, form.value[at] / form.weight[at]);
    most = std::max(most, form.value[at] / form.weight[at]);
  }
  least -= error_of(square, cell, shape, most);
  // On the way from the one patch to the other one the gradient turns a little.
  const double turn = tolerance_ * largest_bend(quadric_);
  return least > 0 && std::sqrt(least) - turn >= part;
}

// The gradient is affine, so each entry has its extremes at corners.
bool QuadricBand::is_steep_in_box_of(const Cell& cell, double part) const {
  Vec3 low = quadric_.gradient(cell.low), high = low;
  for (int corner = 1; corner < 8; ++corner) {
    const Vec3 g = quadric_.gradient(corner_of(cell.low, cell.high, corner));
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], g[k]);
      high[k] = std::max(high[k], g[k]);
    }
  }
  Vec3 least;
  for (int k = 0; k < 3; ++k) least[k] = std::max({low[k], -high[k], 0.0});
  return norm(least) >= part;
}

bool QuadricBand::misses(const Cell& cell, const NetShape& shape) const {
  if (shape.plane_size() > kMaxPoints) return false;
  const double least = half_ + error_of(quadric_, cell, shape, half_);
  const auto corner = [&](int at) {
    Vec4 x;
    for (int k = 0; k < 3; ++k) x[k] = cell.hull[k * shape.plane_size() + at];
    x[3] = 1;
    return quadric_.value(x);
  };
  const int last = shape.plane_size() - 1;
  const double sign = corner(0) > 0 ? 1 : -1;
  for (const int at : {0, shape.columns - 1, last - shape.columns + 1, last})
    if (!(sign * corner(at) > least)) return false;
  const CellForm2 form = form_of(quadric_, cell, shape);
  for (int k = 0; k < form.rows * form.columns; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (!(sign * form.value[at] > least * form.weight[at])) return false;
  }
  return true;
}

const QuadricBand* QuadricBands::of(const CellTree& tree) {
  if (!may_lie_on_quadric(tree.patch())) return nullptr;
  const auto [known, added] = bands_.try_emplace(&tree);
  if (added) known->second = QuadricBand::of(tree, tolerance_);
  return known->second ? &*known->second : nullptr;
}

}  // namespace blossom
