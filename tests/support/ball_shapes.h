// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces that balls roll on, whose tracks are known in closed form.

#pragma once

#include <functional>
#include <numbers>

#include "core/forms/surface.h"
#include "tests/support/cubic_family.h"
#include "tests/support/quadric_patches.h"

namespace blossom::testing {

/// origin + u e + v f, u and v in the ranges.
inline BezierSurface plane_patch(const Vec3& origin, const Vec3& e, const Vec3& f,
                                 const Interval& u = {0, 1}, const Interval& v = {0, 1}) {
  BezierSurface surface{{u.from, u.to}, {v.from, v.to}};
  RationalBezierPatch patch{Grid<Vec4>(2, 2)};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const Vec3 x = origin + (i == 0 ? u.from : u.to) * e + (j == 0 ? v.from : v.to) * f;
      patch.points(i, j) = {x[0], x[1], x[2], 1};
    }
  surface.patches = Grid<RationalBezierPatch>(1, 1, patch);
  return surface;
}

/// Quarters from `turned_quarter` all round the axis z; v over the range given. Outward normals.
inline BezierSurface all_round(const RationalBezierPatch& quarter, const Interval& v,
                               ParameterLaw v_law = ParameterLaw::Linear) {
  BezierSurface surface{{}, {v.from, v.to}, ParameterLaw::Angle, v_law};
  surface.rational = true;
  surface.closed_u = true;
  surface.patches = Grid<RationalBezierPatch>(4, 1, quarter);
  for (int k = 0; k <= 4; ++k) surface.u_knots.push_back(k * std::numbers::pi / 2);
  for (int k = 1; k < 4; ++k)
    for (Vec4& p : surface.patches(k, 0).points.values())
      for (int turn = 0; turn < k; ++turn) p = {-p[1], p[0], p[2], p[3]};
  return surface;
}

/// The cylinder of radius r about the axis z, v the height from 0.
inline BezierSurface whole_cylinder(double r, double height) {
  return all_round(cylinder_quarter(r, height), {0, height});
}

/// The upper half of the sphere of radius r round the origin, v the latitude.
inline BezierSurface upper_sphere(double r) {
  return all_round(turned_quarter(quarter_circle(r)), {0, std::numbers::pi / 2},
                   ParameterLaw::Angle);
}

/// The bicubic through the values of f, which has to be one, over the unit square.
inline BezierSurface bicubic(const std::function<Vec3(double, double)>& f) {
  constexpr double kInverse[4][4] = {
      {1, 0, 0, 0}, {-5.0 / 6, 3, -1.5, 1.0 / 3}, {1.0 / 3, -1.5, 3, -5.0 / 6}, {0, 0, 0, 1}};
  RationalBezierPatch patch{Grid<Vec4>(4, 4)};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      Vec3 p;
      for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 4; ++l) p += f(k / 3.0, l / 3.0) * (kInverse[i][k] * kInverse[j][l]);
      patch.points(i, j) = {p[0], p[1], p[2], 1};
    }
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 1, patch);
  return surface;
}

/// Two free-form faces that share the sharp edge y = 0.5: v = 1 of the first, v = 0 of the second.
inline BezierSurface floor_face() { return graph(base_cubic(), {0, 0}, {1, 0}, {0, 0.5}); }
inline BezierSurface wall_face() {
  const Cubic c = base_cubic();
  return bicubic([&](double s, double t) {
    return Vec3{s, 0.5 + 0.3 * t + 0.1 * t * t, c(s, 0.5) + 0.8 * t - 0.2 * t * t + 0.15 * s * t};
  });
}

/// z = a x^2 over |x| <= half, 0 <= y <= depth: a trough along y. Upward normals.
inline BezierSurface trough(double a, double half, double depth) {
  return bicubic([=](double s, double t) {
    const double x = half * (2 * s - 1);
    return Vec3{x, depth * t, a * x * x};
  });
}

}  // namespace blossom::testing
