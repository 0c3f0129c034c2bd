// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes whose fillings are known, as sides for `fill`.

#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/blending/fills/fill.h"
#include "core/forms/algebra/interpolation.h"
#include "core/math/vec.h"
#include "tests/support/random.h"

namespace blossom::testing {

/// Two coordinates of a collar's place to its height; of total degree up to 3.
using Height = std::function<double(double, double)>;

/// The cubic of the families of pairs, over [0, 1]^2.
inline double base_cubic(double x, double y) {
  return 0.3 * x * x * x - 0.25 * x * y * y + 0.2 * x * y - 0.15 * y * y + 0.1 * x - 0.05 * y +
         0.12 * x * x * y;
}

/// The patch over the parallelogram a + s (b - a) + t out with the height z(x, y), plus `extra(s,
/// t)` in z, of the degree that is given in both parameters.
inline RationalBezierPatch collar(const Vec2& a, const Vec2& b, const Vec2& out, const Height& z,
                                  int degree = 3, const Height& extra = {}) {
  const std::vector<double> x = extreme_points(degree);
  Grid<Vec3> values(degree + 1, degree + 1);
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j) {
      const double s = x[static_cast<std::size_t>(i)], t = x[static_cast<std::size_t>(j)];
      const Vec2 p = a + s * (b - a) + t * out;
      values(i, j) = {p[0], p[1], z(p[0], p[1]) + (extra ? extra(s, t) : 0)};
    }
  const Grid<Vec3> net = bezier_through(values);
  RationalBezierPatch patch{Grid<Vec4>(degree + 1, degree + 1)};
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      patch.points(i, j) = {net(i, j)[0], net(i, j)[1], net(i, j)[2], 1};
  return patch;
}

/// Corner k of the regular polygon round (0.5, 0.5).
inline Vec2 polygon_corner(int n, int k, double radius = 0.3) {
  const double angle = 2 * std::numbers::pi * k / n;
  return {0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)};
}

/// 0.2 times the outward direction of side k.
inline Vec2 outward(int n, int k) {
  const double angle = 2 * std::numbers::pi * (k + 0.5) / n;
  return {0.2 * std::cos(angle), 0.2 * std::sin(angle)};
}

/// The polygon's hole in the graph of z.
inline std::vector<FillSide> graph_hole(int n, FillContinuity continuity,
                                        const Height& z = base_cubic) {
  std::vector<FillSide> sides;
  for (int k = 0; k < n; ++k)
    sides.push_back(
        fill_side(collar(polygon_corner(n, k), polygon_corner(n, k + 1), outward(n, k), z),
                  SurfaceSide::VMin, false, continuity));
  return sides;
}

/// The same where each collar leaves the graph as s^p (1 - s)^p and t s^q (1 - s)^q times random
/// numbers: p = 2, q = 1 keeps tangent planes at the corners and lets the twists disagree; with
/// p = 3, q = 2 the second derivatives agree there, too.
inline std::vector<FillSide> loose_hole(int n, FillContinuity continuity, int p, int q, int seed) {
  Random random = seeded(seed);
  std::vector<FillSide> sides;
  for (int k = 0; k < n; ++k) {
    const double border = uniform(random, -1, 1), across = uniform(random, -0.5, 0.5);
    const Height extra = [=](double s, double t) {
      const double bump = s * (1 - s);
      return border * std::pow(bump, p) + across * t * std::pow(bump, q);
    };
    sides.push_back(fill_side(collar(polygon_corner(n, k), polygon_corner(n, k + 1), outward(n, k),
                                     base_cubic, 2 * p, extra),
                              SurfaceSide::VMin, false, continuity));
  }
  return sides;
}

/// The corner of a box whose three edges are rounded by cylinders of the radii, each cut off at the
/// distance `back` from the corner; on each face a cubic joins the ends of two cylinders' contacts.
/// Six sides, every second one a circular arc. Box: all coordinates negative, corner at the origin.
inline std::vector<FillSide> set_back_corner(const std::array<double, 3>& radii, double back) {
  const auto unit_vector = [](int i) {
    Vec4 e;
    e[i] = 1;
    return e;
  };
  // Where the strip along axis i touches the face whose normal is j; k is the third axis.
  const auto contact = [&](int i, int j) {
    const int k = 3 - i - j;
    return Vec4{0, 0, 0, 1} - back * unit_vector(i) -
           radii[static_cast<std::size_t>(i)] * unit_vector(k);
  };
  std::vector<FillSide> sides;
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3, face = (i + 2) % 3;
    const Vec4 a = contact(i, face), b = contact(next, face);
    const double reach = 0.4 * back;
    sides.push_back({.edge = {a, a + reach * unit_vector(i), b + reach * unit_vector(next), b},
                     .across = {-unit_vector(next), -unit_vector(i)},
                     .bend = {},
                     .continuity = FillContinuity::G1});
    const double w = std::sqrt(0.5);
    const Vec4 middle = w * (Vec4{0, 0, 0, 1} - back * unit_vector(next));
    const Vec4 end = contact(next, i);
    sides.push_back({.edge = {b, middle, end},
                     .across = {-unit_vector(next), -w * unit_vector(next), -unit_vector(next)},
                     .bend = {},
                     .continuity = FillContinuity::G1});
  }
  return sides;
}

}  // namespace blossom::testing
