// SPDX-License-Identifier: LGPL-2.1-or-later
// Rational patches on spheres, cylinders, cones and tori.

#pragma once

#include <array>
#include <numbers>

#include "core/forms/patch.h"

namespace blossom::testing {

/// The quarter of a circle round the origin, from (r, 0) to (0, r), as x, y, w.
inline std::array<Vec3, 3> quarter_circle(double r) {
  const double s = std::numbers::sqrt2 / 2;
  return {Vec3{r, 0, 1}, Vec3{s * r, s * r, s}, Vec3{0, r, 1}};
}

/// The profile, given as points (distance from the axis, height, weight), turned by a quarter.
template <std::size_t N>
RationalBezierPatch turned_quarter(const std::array<Vec3, N>& profile) {
  RationalBezierPatch patch{Grid<Vec4>(3, static_cast<int>(N))};
  const auto turn = quarter_circle(1);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < N; ++j) {
      const Vec3 &c = turn[i], &p = profile[j];
      patch.points(static_cast<int>(i), static_cast<int>(j)) = {c[0] * p[0], c[1] * p[0],
                                                                c[2] * p[1], c[2] * p[2]};
    }
  return patch;
}

/// u runs round the axis z, v along it or along the profile.
inline RationalBezierPatch sphere_octant(const Vec3& centre, double r) {
  RationalBezierPatch patch = turned_quarter(quarter_circle(r));
  for (Vec4& p : patch.points.values())
    for (int k = 0; k < 3; ++k) p[k] += p[3] * centre[k];
  return patch;
}

inline RationalBezierPatch cylinder_quarter(double r, double height) {
  return turned_quarter(std::array{Vec3{r, 0, 1}, Vec3{r, height, 1}});
}

inline RationalBezierPatch cone_quarter(double slope, double low, double high) {
  return turned_quarter(std::array{Vec3{slope * low, low, 1}, Vec3{slope * high, high, 1}});
}

inline RationalBezierPatch torus_quarter(double major, double minor) {
  auto profile = quarter_circle(minor);
  for (Vec3& p : profile) p[0] += p[2] * major;
  return turned_quarter(profile);
}

}  // namespace blossom::testing
