// SPDX-License-Identifier: LGPL-2.1-or-later
// Changes of a surface that leave its set of points as it is, or move and scale it as a whole.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "core/forms/algebra/degree.h"
#include "core/forms/algebra/products.h"
#include "core/forms/surface.h"
#include "core/subdivision/patch_subdivision.h"
#include "tests/support/random.h"

namespace blossom::testing {

/// x -> scale R x + shift, R a rotation given by its rows.
struct Motion {
  std::array<Vec3, 3> rotation{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 shift{};
  double scale = 1;
};

/// Any rotation, by a unit quaternion from the uniform distribution, and a shift of up to 2.
///
/// Source: Shoemake 1992, uniform random rotations.
inline Motion random_motion(Random& random) {
  const double r = uniform(random, 0, 1), s = uniform(random, 0, 2 * std::numbers::pi),
               t = uniform(random, 0, 2 * std::numbers::pi);
  const double x = std::sqrt(1 - r) * std::sin(s), y = std::sqrt(1 - r) * std::cos(s),
               z = std::sqrt(r) * std::sin(t), w = std::sqrt(r) * std::cos(t);
  Motion motion;
  motion.rotation = {Vec3{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                     Vec3{2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                     Vec3{2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  for (int k = 0; k < 3; ++k) motion.shift[k] = uniform(random, -2, 2);
  return motion;
}

inline BezierSurface moved(BezierSurface surface, const Motion& motion) {
  for (RationalBezierPatch& patch : surface.patches.values())
    for (Vec4& p : patch.points.values()) {
      const Vec3 x{p[0], p[1], p[2]};
      for (int k = 0; k < 3; ++k)
        p[k] = motion.scale * dot(motion.rotation[static_cast<std::size_t>(k)], x) +
               p[3] * motion.shift[k];
    }
  return surface;
}

/// u and v exchanged.
inline BezierSurface exchanged(const BezierSurface& surface) {
  const auto transposed = []<class T>(const Grid<T>& grid) {
    Grid<T> result(grid.columns(), grid.rows());
    for (int i = 0; i < grid.rows(); ++i)
      for (int j = 0; j < grid.columns(); ++j) result(j, i) = grid(i, j);
    return result;
  };
  BezierSurface result = surface;
  result.patches = transposed(surface.patches);
  for (RationalBezierPatch& patch : result.patches.values())
    patch.points = transposed(patch.points);
  std::swap(result.u_knots, result.v_knots);
  std::swap(result.u_law, result.v_law);
  std::swap(result.closed_u, result.closed_v);
  return result;
}

/// A surface of one span.
inline BezierSurface of_patch(const RationalBezierPatch& patch) {
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 1, patch);
  for (const Vec4& p : patch.points.values()) surface.rational |= p[3] != 1;
  return surface;
}

/// u and v reversed, on the same ranges.
inline BezierSurface reversed(const BezierSurface& surface) {
  const auto turned = [](std::vector<double> knots) {
    std::reverse(knots.begin(), knots.end());
    const double sum = knots.front() + knots.back();
    for (double& knot : knots) knot = sum - knot;
    return knots;
  };
  BezierSurface result = surface;
  result.u_knots = turned(surface.u_knots);
  result.v_knots = turned(surface.v_knots);
  const int rows = surface.patches.rows(), columns = surface.patches.columns();
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      result.patches(i, j) =
          sub_patch(surface.patches(rows - 1 - i, columns - 1 - j), {1, 0}, {1, 0});
  return result;
}

/// Higher degrees in both directions.
inline BezierSurface elevated(BezierSurface surface, int degree) {
  for (RationalBezierPatch& patch : surface.patches.values())
    patch = elevated(patch, degree, degree);
  return surface;
}

/// A surface of one span as one of two, with a knot inside and other knots than it had.
inline BezierSurface split_in_u(const BezierSurface& surface, double cut) {
  BezierSurface split{{2, 2 + 3 * cut, 5}, {0, 1}};
  split.rational = surface.rational;
  split.patches = subdivide(surface.patches(0, 0), std::array{0.0, cut, 1.0}, std::array{0.0, 1.0});
  return split;
}

/// The same points and parameters of a surface of one span, numerator and denominator multiplied
/// by a positive bilinear function.
inline BezierSurface weighted(const BezierSurface& surface, const BezierFunction2& weight) {
  return of_patch(product(weight, surface.patches(0, 0)));
}

inline BezierFunction2 random_weight(Random& random) {
  BezierFunction2 weight{Grid<double>(2, 2)};
  for (double& w : weight.points.values()) w = uniform(random, 0.5, 2);
  return weight;
}

}  // namespace blossom::testing
