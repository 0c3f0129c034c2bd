// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/nearest_pair.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/not_zero.h"
#include "core/bounds/box_tree.h"

namespace blossom {
namespace {

// Roundings of the few operations in a bound.
constexpr double kPairSlack = 1e-14;
constexpr int kDampedSteps = 40;
constexpr double kMinDamping = 1e-12, kMaxDamping = 1e8;
constexpr double kFirstDamping = 1e-3;  // part of the curvature
constexpr double kNoMove = 1e-12;       // part of a patch: a step that finds nothing smaller
// A step this small changes no digit of a parameter any more.
constexpr double kLastStep = 1e-16;

struct Heights {
  double low;
  double high;
};

Heights heights(const HullCell& hull, const Vec3& n) {
  const double* x = hull.cell->hull;
  const double* y = x + hull.points;
  const double* z = y + hull.points;
  double low = n[0] * x[0] + n[1] * y[0] + n[2] * z[0];
  double high = low;
  for (int i = 1; i < hull.points; ++i) {
    const double h = n[0] * x[i] + n[1] * y[i] + n[2] * z[i];
    low = h < low ? h : low;
    high = h > high ? h : high;
  }
  // |n| <= 1 turns the margin of three coordinates into at most sqrt(3) of it.
  return {low - 2 * hull.cell->margin, high + 2 * hull.cell->margin};
}

double gap_along(const HullCell& a, const HullCell& b, const Vec3& direction) {
  const Heights ha = heights(a, direction), hb = heights(b, direction);
  const double gap = std::max(ha.low - hb.high, hb.low - ha.high);
  const double size = std::max(std::max(std::abs(ha.low), std::abs(ha.high)),
                               std::max(std::abs(hb.low), std::abs(hb.high)));
  return gap - kPairSlack * size;
}

Vec3 middle(const Cell& cell) { return 0.5 * (cell.low + cell.high); }

// Whether r . d may vanish for r within mid +- rad and d within the bounds.
bool may_be_across(const Vec3& mid, const Vec3& rad, const VectorBounds& d) {
  double value = 0, spread = 0;
  for (int k = 0; k < 3; ++k) {
    value += mid[k] * d.middle[k];
    spread += std::abs(mid[k]) * d.radius[k] + rad[k] * (std::abs(d.middle[k]) + d.radius[k]) +
              kPairSlack * std::abs(mid[k] * d.middle[k]);
  }
  return std::abs(value) <= spread * (1 + kPairSlack);
}

using Vec4d = std::array<double, 4>;
using Matrix4 = std::array<Vec4d, 4>;

// Solves h s = -g for the free variables by Cholesky's method; false if h is not positive definite.
bool solve(Matrix4 h, const Vec4d& g, const std::array<bool, 4>& free, Vec4d& step) {
  step = {};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!free[i]) continue;
    for (std::size_t j = 0; j <= i; ++j) {
      if (!free[j]) continue;
      double sum = h[i][j];
      for (std::size_t k = 0; k < j; ++k)
        if (free[k]) sum -= h[i][k] * h[j][k];
      if (i == j && !(sum > 0)) return false;
      h[i][j] = i == j ? std::sqrt(sum) : sum / h[j][j];
    }
    double sum = -g[i];
    for (std::size_t k = 0; k < i; ++k)
      if (free[k]) sum -= h[i][k] * step[k];
    step[i] = sum / h[i][i];
  }
  for (std::size_t i = 4; i-- > 0;) {
    if (!free[i]) continue;
    for (std::size_t k = i + 1; k < 4; ++k)
      if (free[k]) step[i] -= h[k][i] * step[k];
    step[i] /= h[i][i];
  }
  return true;
}

}  // namespace

double distance_bound(const HullCell& a, const HullCell& b, const Vec3& direction) {
  const double boxes =
      std::sqrt(squared_distance(Box{a.cell->low, a.cell->high}, Box{b.cell->low, b.cell->high}));
  double bound = boxes * (1 - kPairSlack);
  if (!(direction == Vec3{})) bound = std::max(bound, gap_along(a, b, direction));
  const Vec3 between = unit(middle(*a.cell) - middle(*b.cell));
  if (!(between == Vec3{})) bound = std::max(bound, gap_along(a, b, between));
  return bound;
}

bool may_be_normal(const Cell& a, const std::array<bool, 2>& across_a, const Cell& b,
                   const std::array<bool, 2>& across_b) {
  Vec3 mid, rad;
  for (int k = 0; k < 3; ++k) {
    const double low = a.low[k] - b.high[k], high = a.high[k] - b.low[k];
    mid[k] = 0.5 * (low + high);
    rad[k] = 0.5 * (high - low) * (1 + kPairSlack) + kPairSlack * std::abs(mid[k]);
  }
  return (!across_a[0] || may_be_across(mid, rad, a.du)) &&
         (!across_a[1] || may_be_across(mid, rad, a.dv)) &&
         (!across_b[0] || may_be_across(mid, rad, b.du)) &&
         (!across_b[1] || may_be_across(mid, rad, b.dv));
}

SquaredGap squared_gap(const PatchOf& a, const PatchOf& b, const std::array<double, 4>& x) {
  SquaredGap gap;
  gap.a = jet_at(*a.patch, x[0], x[1], 2);
  gap.b = jet_at(*b.patch, x[2], x[3], 2);
  const Vec3 r = gap.a.point - gap.b.point;
  gap.value = 0.5 * dot(r, r);
  const std::array<Vec3, 4> d{gap.a.u, gap.a.v, -gap.b.u, -gap.b.v};
  for (std::size_t i = 0; i < 4; ++i) {
    gap.slope[i] = dot(r, d[i]);
    for (std::size_t j = 0; j < 4; ++j) gap.curvature[i][j] = dot(d[i], d[j]);
  }
  gap.curvature[0][0] += dot(r, gap.a.uu);
  gap.curvature[1][1] += dot(r, gap.a.vv);
  gap.curvature[0][1] = gap.curvature[1][0] = gap.curvature[0][1] + dot(r, gap.a.uv);
  gap.curvature[2][2] -= dot(r, gap.b.uu);
  gap.curvature[3][3] -= dot(r, gap.b.vv);
  gap.curvature[2][3] = gap.curvature[3][2] = gap.curvature[2][3] - dot(r, gap.b.uv);
  return gap;
}

NearPair near_pair(const PatchOf& a, const PatchOf& b, const Vec2& start_a, const Vec2& start_b) {
  const std::array<bool, 4> counts{a.dimension > 0, a.dimension > 1, b.dimension > 0,
                                   b.dimension > 1};
  const std::array<Interval, 4> sides{a.u, a.v, b.u, b.v};
  Vec4d x{start_a[0], start_a[1], start_b[0], start_b[1]};
  SquaredGap gap = squared_gap(a, b, x);
  double damping = 0;
  for (int k = 0; k < kDampedSteps && damping < kMaxDamping; ++k) {
    std::array<bool, 4> free = counts;
    for (std::size_t i = 0; i < 4; ++i)  // not those that a side of the piece holds
      free[i] = free[i] && !(x[i] <= sides[i].from && gap.slope[i] > 0) &&
                !(x[i] >= sides[i].to && gap.slope[i] < 0);
    Matrix4 h = gap.curvature;
    for (std::size_t i = 0; i < 4; ++i) h[i][i] += damping * (std::abs(h[i][i]) + kNotZero);
    Vec4d step;
    if (!solve(h, gap.slope, free, step)) {
      damping = std::max(10 * damping, kFirstDamping);
      continue;
    }
    Vec4d next = x;
    double moved = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      next[i] = std::clamp(x[i] + step[i], sides[i].from, sides[i].to);
      moved = std::max(moved, std::abs(next[i] - x[i]));
    }
    if (!(moved > kLastStep)) break;
    const SquaredGap there = squared_gap(a, b, next);
    if (there.value < gap.value) {
      x = next;
      gap = there;
      damping = damping < kMinDamping ? 0 : damping / 10;
    } else {
      if (moved < kNoMove) break;
      damping = std::max(10 * damping, kFirstDamping);
    }
  }
  return {{x[0], x[1]}, {x[2], x[3]}, gap.a.point, gap.b.point};
}

}  // namespace blossom
