// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/charts/jet_enclosure.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace blossom {
namespace {

constexpr double kSteepest = 0.8;  // sine of the angle between n and normals, for the second bound

double extent(const std::array<Vec2, 3>& corners, int k) {
  const auto [low, high] = std::minmax({corners[0][k], corners[1][k], corners[2][k]});
  return high - low;
}

// The second derivative in the middle of the ranges, along a side.
Vec3 bend(const JetEnclosure& jet, const Vec2& e) {
  return e[0] * e[0] * jet.uu.centre + 2 * e[0] * e[1] * jet.uv.centre +
         e[1] * e[1] * jet.vv.centre;
}

struct Extent {
  double u, v;

  double rest(double uu, double uv, double vv) const {
    return (u * u * uu + 2 * u * v * std::abs(uv) + v * v * vv) / 8;
  }
};

}  // namespace

VectorRange united(const VectorRange& a, const VectorRange& b) {
  VectorRange both;
  for (int k = 0; k < 3; ++k) {
    const double low = std::min(a.centre[k] - a.radius[k], b.centre[k] - b.radius[k]);
    const double high = std::max(a.centre[k] + a.radius[k], b.centre[k] + b.radius[k]);
    both.centre[k] = 0.5 * (low + high);
    both.radius[k] = 0.5 * (high - low);
  }
  return both;
}

JetEnclosure united(const JetEnclosure& a, const JetEnclosure& b) {
  return {united(a.uu, b.uu),
          united(a.uv, b.uv),
          united(a.vv, b.vv),
          std::max(a.length_u, b.length_u),
          std::max(a.length_v, b.length_v),
          std::min(a.jacobian, b.jacobian),
          a.jump_u + b.jump_u,
          a.jump_v + b.jump_v};
}

double largest_mean(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  if (a < c) std::swap(a, c);
  if (!(a > 0)) return 0;
  b = std::max(b / a, 0.0), c = std::max(c / a, 0.0);
  const double excess = b + c - 1;
  if (!(excess > 0)) return a / 4;
  // It is taken inside of the triangle. As the excess is at most b and at most c, what is divided
  // by is at least 3 b c, and rounded little.
  return a * std::clamp(b * c / (4 * b * c - excess * excess), 0.25, 1.0 / 3);
}

double facet_distance(const JetEnclosure& jet, const Vec3& n, const std::array<Vec2, 3>& corners) {
  std::array<Vec3, 3> bends;
  for (std::size_t i = 0; i < 3; ++i)
    bends[i] = bend(jet, corners[(i + 1) % 3] - corners[(i + 2) % 3]);
  const Extent extents{extent(corners, 0), extent(corners, 1)};
  const auto along = [&](double sign) {
    return largest_mean(sign * dot(n, bends[0]), sign * dot(n, bends[1]), sign * dot(n, bends[2]));
  };
  const Vec3 size_n = absolute(n);
  const double height =
      0.5 * std::max(along(1), along(-1)) +
      extents.rest(jet.uu.spread_along(n), jet.uv.spread_along(n), jet.vv.spread_along(n)) +
      (extents.u * dot(size_n, jet.jump_u) + extents.v * dot(size_n, jet.jump_v)) / 4;
  const double whole = 0.5 * largest_mean(norm(bends[0]), norm(bends[1]), norm(bends[2])) +
                       extents.rest(norm(jet.uu.radius), norm(jet.uv.radius), norm(jet.vv.radius)) +
                       (extents.u * norm(jet.jump_u) + extents.v * norm(jet.jump_v)) / 4;
  if (!(jet.jacobian > 0)) return whole;
  // n is normal somewhere on the facet, so that |n S_u| is what S_u changes by.
  const double slope_u =
      extents.u * jet.uu.size_along(n) + extents.v * jet.uv.size_along(n) + dot(size_n, jet.jump_u);
  const double slope_v =
      extents.u * jet.uv.size_along(n) + extents.v * jet.vv.size_along(n) + dot(size_n, jet.jump_v);
  const double sine = (slope_u * jet.length_v + slope_v * jet.length_u) / jet.jacobian;
  if (!(sine < kSteepest)) return whole;
  const double m = jet.jacobian * std::sqrt(1 - sine * sine);
  const double d_u = whole * jet.length_v / m, d_v = whole * jet.length_u / m;
  const double moved =
      0.5 * (d_u * d_u * jet.uu.size() + 2 * d_u * d_v * jet.uv.size() + d_v * d_v * jet.vv.size());
  return std::min(whole, height + 2 * (slope_u * d_u + slope_v * d_v) + 4 * moved);
}

}  // namespace blossom
