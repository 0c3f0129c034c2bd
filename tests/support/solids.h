// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact closed surfaces as rational Bezier patches: boxes, spheres, tori.

#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/forms/surface.h"
#include "core/math/vec.h"

namespace blossom::testing {

/// A surface of one patch with parameters [0, 1]^2.
inline BezierSurface one_patch(RationalBezierPatch patch) {
  BezierSurface surface;
  surface.u_knots = surface.v_knots = {0, 1};
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  for (const Vec4& p : patch.points.values()) surface.rational = surface.rational || p[3] != 1;
  surface.patches(0, 0) = std::move(patch);
  return surface;
}

inline Vec4 weighted(const Vec3& point, double weight) {
  return {weight * point[0], weight * point[1], weight * point[2], weight};
}

/// The bilinear patch with corners (0, 0), (0, 1), (1, 0), (1, 1) in (u, v).
inline BezierSurface quadrilateral(const Vec3& p00, const Vec3& p01, const Vec3& p10,
                                   const Vec3& p11) {
  RationalBezierPatch patch{Grid<Vec4>(2, 2)};
  patch.points(0, 0) = weighted(p00, 1);
  patch.points(0, 1) = weighted(p01, 1);
  patch.points(1, 0) = weighted(p10, 1);
  patch.points(1, 1) = weighted(p11, 1);
  return one_patch(std::move(patch));
}

/// The six sides of [0, 1]^3, turned outwards.
inline std::vector<BezierSurface> unit_cube() {
  return {quadrilateral({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}),
          quadrilateral({0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}),
          quadrilateral({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}),
          quadrilateral({0, 1, 0}, {1, 1, 0}, {0, 1, 1}, {1, 1, 1}),
          quadrilateral({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}),
          quadrilateral({1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1})};
}

/// A quarter of a unit circle from angle `from` on: three homogeneous points (wx, wy, w). The
/// middle one is 1 / w away from the centre.
inline std::array<Vec3, 3> quarter_arc(double from) {
  const double w = std::numbers::sqrt2 / 2, middle = from + std::numbers::pi / 4;
  const double half_turn = from + std::numbers::pi / 2;
  return {Vec3{std::cos(from), std::sin(from), 1}, Vec3{std::cos(middle), std::sin(middle), w},
          Vec3{std::cos(half_turn), std::sin(half_turn), 1}};
}

/// Turns the circle of radius `tube` round (ring, 0) about the z axis: u is the angle about the
/// axis, v that of the circle, from `v_from` in `v_spans` quarters.
inline BezierSurface revolved_circle(double ring, double tube, double v_from, int v_spans) {
  constexpr double kQuarter = std::numbers::pi / 2;
  BezierSurface surface;
  surface.u_law = surface.v_law = ParameterLaw::Angle;
  surface.rational = surface.closed_u = true;
  surface.closed_v = v_spans == 4;
  for (int i = 0; i <= 4; ++i) surface.u_knots.push_back(i * kQuarter);
  for (int j = 0; j <= v_spans; ++j) surface.v_knots.push_back(v_from + j * kQuarter);
  surface.patches = Grid<RationalBezierPatch>(4, v_spans);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < v_spans; ++j) {
      const std::array<Vec3, 3> round = quarter_arc(i * kQuarter);
      const std::array<Vec3, 3> profile = quarter_arc(v_from + j * kQuarter);
      RationalBezierPatch& patch = surface.patches(i, j);
      patch.points = Grid<Vec4>(3, 3);
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) {
          const Vec3& a = round[static_cast<std::size_t>(k)];
          const Vec3& b = profile[static_cast<std::size_t>(l)];
          const double across = ring * b[2] + tube * b[0];  // from the axis
          patch.points(k, l) = {a[0] * across, a[1] * across, a[2] * tube * b[1], a[2] * b[2]};
        }
    }
  return surface;
}

/// A unit sphere about the origin; its poles on the z axis are collapsed sides.
inline BezierSurface unit_sphere() { return revolved_circle(0, 1, -std::numbers::pi / 2, 2); }

inline BezierSurface torus(double ring, double tube) { return revolved_circle(ring, tube, 0, 4); }

}  // namespace blossom::testing
