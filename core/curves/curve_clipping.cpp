// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/curve_clipping.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/bounds/value_arithmetic.h"

namespace blossom {
namespace {

constexpr double kParallel = 1e-3;    // sine below which chords in space have no common normal
constexpr double kHullSlack = 1e-13;  // of a cell; covers the rounding of where a hull ends

// 1 / k, for slopes between control points.
constexpr std::array<double, kMaxDegree + 1> kOver = [] {
  std::array<double, kMaxDegree + 1> over{};
  for (std::size_t k = 1; k < over.size(); ++k) over[k] = 1 / static_cast<double>(k);
  return over;
}();

Vec3 turned(const Vec3& v) { return {-v[1], v[0], 0}; }

Vec3 middle_of(const CurveCell& cell) { return (cell.low + cell.high) * 0.5; }

// A direction perpendicular to both chords, in space; if those are nearly parallel, the one from
// one cell to the other.
Vec3 common_normal(const CurvePair& pair) {
  const Vec3 normal = cross(pair.a.axis, pair.b.axis);
  if (norm(normal) > kParallel) return unit(normal);
  const Vec3& axis = pair.a.axis;
  const Vec3 between = middle_of(pair.b) - middle_of(pair.a);
  const Vec3 across = between - axis * dot(axis, between);
  if (norm(across) > kParallel * norm(between)) return unit(across);
  return any_across(axis);
}

// The values of the control points along a direction, and their range without margins.
template <int kDimension>
ValueRange values_along(const CurveCell& cell, const Vec3& direction, double* values) {
  const int n = cell.points;
  const double *x = cell.hull, *y = x + n, *z = y + n;
  ValueRange range{kUnbounded, -kUnbounded};
  for (int i = 0; i < n; ++i) {
    double value = direction[0] * x[i] + direction[1] * y[i];
    if constexpr (kDimension == 3) value += direction[2] * z[i];
    values[i] = value;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range;
}

ValueRange values_along(const CurveCell& cell, int dimension, const Vec3& direction,
                        double* values) {
  return dimension == 2 ? values_along<2>(cell, direction, values)
                        : values_along<3>(cell, direction, values);
}

// Where the lower convex hull of (i / n, c_i) first comes down to 0, for c_0 > 0; 2: nowhere.
double first_reach(const double* c, int n) {
  for (int i = 0; i < n;) {
    int next = i + 1;
    double least = c[next] - c[i];
    for (int j = i + 2; j <= n; ++j) {
      const double slope = (c[j] - c[i]) * kOver[static_cast<std::size_t>(j - i)];
      if (slope < least) {
        least = slope;
        next = j;
      }
    }
    if (c[next] <= 0) return (i - c[i] / least) * kOver[static_cast<std::size_t>(n)];
    i = next;
  }
  return 2;
}

// Keeps of `part` where the values of a cell may lie in a range. With weights w the curve's value
// is above `high` where sum w_i (v_i - high) B_i is above 0. False: nowhere.
class Clip {
 public:
  Clip(const CurveTree& tree, const CurveCell& cell)
      : last_(cell.points - 1),
        weights_(tree.curve().rational ? cell.homogeneous + tree.dimension() * cell.points
                                       : nullptr) {}

  bool keep(const double* values, const ValueRange& range, Interval& part) const {
    const double from = reach(values, 0, 1, range), to = 1 - reach(values, last_, -1, range);
    part.from = std::max(part.from, from - kHullSlack);
    part.to = std::min(part.to, to + kHullSlack);
    return part.from <= part.to;
  }

 private:
  // From one end, how much of the cell is outside of the range.
  double reach(const double* values, int first, int step, const ValueRange& range) const {
    const bool above = values[first] > range.high;
    if (!above && !(values[first] < range.low)) return 0;
    const double level = above ? range.high : range.low, sign = above ? 1 : -1;
    double c[kMaxDegree + 1];
    for (int i = 0, k = first; i <= last_; ++i, k += step) {
      c[i] = sign * (values[k] - level);
      if (weights_ != nullptr) c[i] *= weights_[k];
    }
    return first_reach(c, last_);
  }

  int last_;
  const double* weights_;
};

}  // namespace

FatLines::FatLines(const CurvePair& pair, double tolerance) : pair_(pair), tolerance_(tolerance) {
  if (pair.a.axis == Vec3{} || pair.b.axis == Vec3{}) return;
  if (pair.dimension() == 2) {
    separated_ = add(turned(pair.a.axis), false, true) || add(turned(pair.b.axis), true, false);
    return;
  }
  const Vec3 normal = common_normal(pair);
  separated_ = add(normal, true, true) || add(unit(cross(normal, pair.a.axis)), true, true) ||
               add(unit(cross(normal, pair.b.axis)), true, true);
}

// |normal| <= 1 turns the margin of three coordinates into at most sqrt(3) of it.
bool FatLines::add(const Vec3& normal, bool with_a, bool with_b) {
  Line& line = lines_[static_cast<std::size_t>(count_++)];
  line.has_a = with_a;
  line.has_b = with_b;
  const auto range = [&](const CurveCell& cell, bool with, double* values) {
    if (!with) return cell.across;
    return padded(values_along(cell, pair_.dimension(), normal, values), 2 * cell.margin);
  };
  line.a = range(pair_.a, with_a, line.on_a.data());
  line.b = range(pair_.b, with_b, line.on_b.data());
  return are_apart(line.a, line.b, tolerance_);
}

bool FatLines::within_strip(double width) const {
  const bool along_a = pair_.a.extent >= pair_.b.extent;
  const Vec3& axis = along_a ? pair_.a.axis : pair_.b.axis;
  if (axis == Vec3{}) return false;
  const auto reach = [](const ValueRange& a, const ValueRange& b) {
    return std::max(a.high, b.high) - std::min(a.low, b.low);
  };
  if (pair_.dimension() == 2) {
    if (count_ < 2) return false;
    const Line& line = lines_[along_a ? 0 : 1];
    return reach(line.a, line.b) <= width;
  }
  const Vec3 first = any_across(axis);
  double square = 0;
  for (const Vec3& across : {first, cross(axis, first)}) {
    const double side = reach(range_along(pair_.a, 3, across), range_along(pair_.b, 3, across));
    square += side * side;
  }
  return square <= width * width;
}

std::optional<CellParts> FatLines::parts() const {
  CellParts parts;
  const Clip clip_a(pair_.tree_a, pair_.a), clip_b(pair_.tree_b, pair_.b);
  // The ranges hold one margin of their cells, the values that are clipped none.
  const double pad_a = tolerance_ + 4 * pair_.a.margin, pad_b = tolerance_ + 4 * pair_.b.margin;
  for (int i = 0; i < count_; ++i) {
    const Line& line = lines_[static_cast<std::size_t>(i)];
    if (line.has_a && !clip_a.keep(line.on_a.data(), padded(line.b, pad_a), parts.a))
      return std::nullopt;
    if (line.has_b && !clip_b.keep(line.on_b.data(), padded(line.a, pad_b), parts.b))
      return std::nullopt;
  }
  return parts;
}

namespace {

// In the plane: a line between the point and all control points, farther from both than `reach`
// together; the middle of the directions to the control points is across to it.
bool is_outside(const CurveCell& cell, const Vec3& point, double reach) {
  const int n = cell.points;
  const auto to = [&](int i) {
    return Vec3{cell.hull[i] - point[0], cell.hull[n + i] - point[1], 0};
  };
  Vec3 right = to(0), left = right;
  for (int i = 1; i < n; ++i) {
    const Vec3 v = to(i);
    if (cross_z(left, v) > 0)
      left = v;
    else if (cross_z(right, v) < 0)
      right = v;
  }
  const Vec3 middle = unit(unit(left) + unit(right));
  for (int i = 0; i < n; ++i)
    if (!(dot(middle, to(i)) > reach)) return false;
  return true;
}

}  // namespace

std::optional<Interval> part_near(const CurveTree& tree, const CurveCell& cell, const Vec3& point,
                                  double tolerance) {
  const double reach = tolerance + 4 * cell.margin;
  if (tree.dimension() == 2 && is_outside(cell, point, reach)) return std::nullopt;
  Interval part{0, 1};
  const Vec3& axis = cell.axis;
  if (axis == Vec3{}) return part;
  const int n = cell.points;
  Vec3 offset = point;
  for (int k = 0; k < tree.dimension(); ++k) offset[k] -= cell.hull[k * n];
  const Vec3 across =
      tree.dimension() == 2 ? turned(axis) : unit(offset - axis * dot(axis, offset));
  const Clip clip(tree, cell);
  for (const Vec3& direction : {across, axis}) {
    double values[kMaxDegree + 1];
    values_along(cell, tree.dimension(), direction, values);
    const double level = dot(direction, point);
    if (!clip.keep(values, {level - reach, level + reach}, part)) return std::nullopt;
  }
  return part;
}

}  // namespace blossom
