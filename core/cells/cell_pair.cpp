// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/cell_pair.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/cells/net_ranges.h"
#include "core/math/four.h"

namespace blossom {
namespace {

// Nearly parallel pairs are this flat: the sines of the angles by which the derivatives of both
// cells turn, added.
constexpr double kFlat = 0.3;

constexpr double kInverseRoundoff = 1e-14;  // relative, of a 3 x 3 inverse times its matrix
constexpr int kPowerSteps = 4;              // towards the Perron vector of the spread
// Of an arc's parameter beside the fastest one: below, arcs are tangent to its borders, as where
// they are cut (core/surfaces/pairs/border_roots.cpp).
constexpr double kSlowest = 1e-6;
constexpr double kLittle = 1e-3;  // of the largest entry, which keeps all positive

bool boxes_apart(const Cell& a, const Cell& b, double gap) {
  for (int k = 0; k < 3; ++k)
    if (a.low[k] > b.high[k] + gap || b.low[k] > a.high[k] + gap) return true;
  return false;
}

// Heights of a cell over another one's plane, margin included; |normal| <= 1.
Range heights_over(const FatPlane& plane, const Cell& cell, int points) {
  const Range h = height_range(cell.hull, points, plane.normal);
  return {h.low - 2 * cell.margin, h.high + 2 * cell.margin};
}

bool above_or_below(const FatPlane& plane, const Cell& cell, int points, double gap) {
  const Range h = heights_over(plane, cell, points);
  return h.low > plane.high + gap || h.high < plane.low - gap;
}

bool slab_holds(const FatPlane& plane, const Cell& cell, int points, double thickness) {
  if (plane.normal == Vec3{}) return false;
  const Range h = heights_over(plane, cell, points);
  return std::max(h.high, plane.high) - std::min(h.low, plane.low) <= thickness;
}

double determinant(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(a, cross(b, c)); }

bool spectral_radius_below_one(const Matrix3& e) {
  std::array<double, 3> x{1, 1, 1};
  for (int step = 0; step < kPowerSteps; ++step) {
    std::array<double, 3> y{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) y[i] += e[i][j] * x[j];
    if (y[0] < x[0] && y[1] < x[1] && y[2] < x[2]) return true;
    const double little = kLittle * std::max({y[0], y[1], y[2]});
    for (std::size_t i = 0; i < 3; ++i) x[i] = y[i] + little;
  }
  return false;
}

// What the four minors of J come to, each in the lane of the column that it leaves out.
struct FourMinors {
  std::array<double, 4> size;  // the square of the middle's determinant, for unit columns
  std::array<bool, 4> regular;
};

using FourMatrix = std::array<std::array<Four, 3>, 3>;

// Lanes in which the spectral radius is below 1, as spectral_radius_below_one finds them.
[[gnu::always_inline]] inline std::array<bool, 4> spectral_radii_below_one(const FourMatrix& e) {
  std::array<Four, 3> x, y;
  x.fill(Four{1, 1, 1, 1});
  std::array<bool, 4> below{};
  for (int step = 0; step < kPowerSteps; ++step) {
    for (std::size_t i = 0; i < 3; ++i) y[i] = e[i][0] * x[0] + e[i][1] * x[1] + e[i][2] * x[2];
    const auto less = (y[0] < x[0]) & (y[1] < x[1]) & (y[2] < x[2]);
    for (int k = 0; k < 4; ++k) below[static_cast<std::size_t>(k)] |= less[k] != 0;
    const Four more = y[0] > y[1] ? y[0] : y[1], largest = more > y[2] ? more : y[2];
    for (std::size_t i = 0; i < 3; ++i) x[i] = y[i] + kLittle * largest;
  }
  return below;
}

[[gnu::always_inline]] inline void dot(const std::array<Four, 3>& a, const std::array<Four, 3>& b,
                                       Four& sum) {
  sum = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

BLOSSOM_HOT FourMinors four_minors(const std::array<VectorBounds, 4>& columns) {
  FourMatrix middle, radius, inverse, spread;  // [column][axis]; rows of the inverse
  for (std::size_t i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      // The lanes up to i leave out an earlier column.
      const std::array<double, 4> lanes{0, 1, 2, 3};
      Four lane;
      std::memcpy(&lane, lanes.data(), sizeof lane);
      const auto later = lane <= static_cast<double>(i);
      const VectorBounds &low = columns[i], &high = columns[i + 1];
      const Four zero{};
      middle[i][static_cast<std::size_t>(axis)] =
          later ? zero + high.middle[axis] : zero + low.middle[axis];
      radius[i][static_cast<std::size_t>(axis)] =
          later ? zero + high.radius[axis] : zero + low.radius[axis];
    }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &p = middle[(i + 1) % 3], &q = middle[(i + 2) % 3];
    inverse[i] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
  }
  Four d, squares{1, 1, 1, 1};
  dot(middle[0], inverse[0], d);
  for (std::size_t i = 0; i < 3; ++i) {
    Four square;
    dot(middle[i], middle[i], square);
    squares *= square;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Four &x = inverse[i][axis], &m = middle[i][axis];
      x *= 1 / d;
      x = x < 0 ? -x : x;
      radius[i][axis] += kInverseRoundoff * (m < 0 ? -m : m);
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) dot(inverse[i], radius[j], spread[i][j]);
  FourMinors result{{}, spectral_radii_below_one(spread)};
  const Four size = d * d / squares;
  std::memcpy(result.size.data(), &size, sizeof size);
  return result;
}

// Not a number where a column is zero.
int largest_of(const std::array<double, 4>& sizes) {
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (sizes[k] > sizes[largest] || std::isnan(sizes[largest])) largest = k;
  return static_cast<int>(largest);
}

}  // namespace

bool separated(const Cell& a, const Cell& b, int points_a, int points_b, double gap) {
  return boxes_apart(a, b, gap) || above_or_below(a.plane, b, points_b, gap) ||
         above_or_below(b.plane, a, points_a, gap);
}

bool separated_along(const Vec3& normal, const Cell& a, const Cell& b, int points_a, int points_b,
                     double gap) {
  const Vec3 n = unit(normal);
  const Range ha = heights_over({n, 0, 0}, a, points_a), hb = heights_over({n, 0, 0}, b, points_b);
  return ha.low > hb.high + gap || ha.high < hb.low - gap;
}

bool separated_across(const Cell& a, const Cell& b, int points_a, int points_b, double gap) {
  for (const Vec3& p : {a.du.middle, a.dv.middle})
    for (const Vec3& q : {b.du.middle, b.dv.middle})
      if (separated_along(cross(p, q), a, b, points_a, points_b, gap)) return true;
  return false;
}

bool within_slab(const Cell& a, const Cell& b, int points_a, int points_b, double thickness) {
  return slab_holds(a.plane, b, points_b, thickness) || slab_holds(b.plane, a, points_a, thickness);
}

bool is_halved_first(const Cell& a, const Cell& b) {
  constexpr double kExtentWeight = 0.02;
  return a.bend + kExtentWeight * a.extent >= b.bend + kExtentWeight * b.extent;
}

bool nearly_parallel(const Cell& a, const Cell& b) {
  const auto turn = [](const Cell& c) {
    return norm(c.du.radius) / norm(c.du.middle) + norm(c.dv.radius) / norm(c.dv.middle);
  };
  const double turns = turn(a) + turn(b);
  if (!(turns < kFlat)) return false;
  const Vec3 na = unit(cross(a.du.middle, a.dv.middle));
  const Vec3 nb = unit(cross(b.du.middle, b.dv.middle));
  // A skew frame turns its normal by more than its sides turn.
  const auto skew = [](const Cell& c) { return norm(cross(unit(c.du.middle), unit(c.dv.middle))); };
  return norm(cross(na, nb)) <= 2 * turns / std::min(skew(a), skew(b));
}

JacobianBounds::JacobianBounds(const Cell& a, const Cell& b)
    : columns_{a.du, a.dv, VectorBounds{-b.du.middle, b.du.radius},
               VectorBounds{-b.dv.middle, b.dv.radius}} {}

JacobianBounds::JacobianBounds(const VectorBounds& curve, const Cell& b)
    : columns_{curve, VectorBounds{}, VectorBounds{-b.du.middle, b.du.radius},
               VectorBounds{-b.dv.middle, b.dv.radius}} {}

int JacobianBounds::best_column() const { return largest_of(four_minors(columns_).size); }

int JacobianBounds::certified_column() const {
  const FourMinors minors = four_minors(columns_);
  const double best = minors.size[static_cast<std::size_t>(largest_of(minors.size))];
  std::array<double, 4> sizes = minors.size;
  for (std::size_t k = 0; k < 4; ++k)
    if (!minors.regular[k]) sizes[k] = std::numeric_limits<double>::quiet_NaN();
  const int column = largest_of(sizes);
  const double size = sizes[static_cast<std::size_t>(column)];
  return size > 0 && !(size < kSlowest * kSlowest * best) ? column : -1;
}

BLOSSOM_HOT Minor JacobianBounds::minor(int left_out) const {
  const auto kept = kept_columns(left_out);
  std::array<VectorBounds, 3> c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = columns_[static_cast<std::size_t>(kept[i])];
  const double d = determinant(c[0].middle, c[1].middle, c[2].middle);
  Minor result;
  if (d == 0 || !std::isfinite(1 / d)) return result;
  // Row i of the inverse is the cross product of the two other columns over d.
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 row = cross(c[(i + 1) % 3].middle, c[(i + 2) % 3].middle) * (1 / d);
    for (int k = 0; k < 3; ++k) result.inverse[i][static_cast<std::size_t>(k)] = row[k];
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const int axis = static_cast<int>(k);
        sum += std::abs(result.inverse[i][k]) *
               (c[j].radius[axis] + kInverseRoundoff * std::abs(c[j].middle[axis]));
      }
      result.spread[i][j] = sum;
    }
  result.regular = spectral_radius_below_one(result.spread);
  return result;
}

}  // namespace blossom
