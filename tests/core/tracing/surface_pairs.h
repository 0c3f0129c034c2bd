// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of surfaces of every kind that curves are written back on.

#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/forms/surface.h"
#include "tests/support/cubic_family.h"

namespace blossom::testing {

struct SurfacePair {
  std::string name;
  BezierSurface a, b;
};

/// The bilinear patch with corners p, p + e, p + f, p + e + f.
inline BezierSurface plane(const Vec3& p, const Vec3& e, const Vec3& f) {
  Grid<Vec4> net(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const Vec3 x = p + static_cast<double>(i) * e + static_cast<double>(j) * f;
      net(i, j) = {x[0], x[1], x[2], 1};
    }
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{net});
  return surface;
}

/// A profile in the half plane (radius, height), homogeneous points (w r, w z, w) of the spans of
/// v, turned about the z axis from angle 0 in equal arcs.
inline BezierSurface revolved(const std::vector<std::vector<Vec3>>& profile,
                              std::vector<double> v_knots, ParameterLaw v_law, double angle,
                              int arcs) {
  BezierSurface surface{{0}, std::move(v_knots)};
  surface.u_law = ParameterLaw::Angle;
  surface.v_law = v_law;
  surface.rational = true;
  surface.patches = Grid<RationalBezierPatch>(arcs, static_cast<int>(profile.size()));
  const double half = 0.5 * angle / arcs;
  for (int arc = 0; arc < arcs; ++arc) {
    surface.u_knots.push_back(2 * half * (arc + 1));
    for (std::size_t span = 0; span < profile.size(); ++span) {
      Grid<Vec4> net(3, static_cast<int>(profile[span].size()));
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < net.columns(); ++j) {
          const Vec3& p = profile[span][static_cast<std::size_t>(j)];
          const double w = i == 1 ? std::cos(half) : 1, turn = half * (2 * arc + i);
          // The middle point of an arc is farther out by 1 / w: times w it is on the circle.
          net(i, j) = {p[0] * std::cos(turn), p[0] * std::sin(turn), w * p[1], w * p[2]};
        }
      surface.patches(arc, static_cast<int>(span)) = RationalBezierPatch{net};
    }
  }
  return surface;
}

inline BezierSurface cylinder(double radius, double from, double to) {
  return revolved({{{radius, from, 1}, {radius, to, 1}}}, {from, to}, ParameterLaw::Linear,
                  2 * std::numbers::pi, 4);
}

/// The circle of a radius round (centre, 0) from one angle to another, as a profile.
inline std::vector<std::vector<Vec3>> circle(double centre, double radius, double from, double to,
                                             int arcs) {
  std::vector<std::vector<Vec3>> profile;
  const double half = 0.5 * (to - from) / arcs;
  for (int arc = 0; arc < arcs; ++arc) {
    std::vector<Vec3> points;
    for (int i = 0; i < 3; ++i) {
      const double w = i == 1 ? std::cos(half) : 1, turn = from + half * (2 * arc + i);
      points.push_back({w * centre + radius * std::cos(turn), radius * std::sin(turn), w});
    }
    profile.push_back(points);
  }
  return profile;
}

inline BezierSurface torus(double centre, double radius) {
  const double pi = std::numbers::pi;
  return revolved(circle(centre, radius, 0, 2 * pi, 4), {0, pi / 2, pi, 1.5 * pi, 2 * pi},
                  ParameterLaw::Angle, 2 * pi, 4);
}

/// Two spans of u that join at `cut`: z, and beyond it z + k (x - cut)^power. The power is the
/// first derivative that jumps.
inline BezierSurface bent(const Cubic& z, double cut, double k, int power) {
  Cubic more = constant(k);
  for (int i = 0; i < power; ++i) more = more * linear(-cut, 1, 0);
  BezierSurface surface = graph(z, {0, 0}, {cut, 0}, {0, 1});
  const BezierSurface second = graph(z + more, {cut, 0}, {1 - cut, 0}, {0, 1});
  surface.u_knots = {0, cut, 1};
  const RationalBezierPatch first = surface.patches(0, 0);
  surface.patches = Grid<RationalBezierPatch>(2, 1, first);
  surface.patches(1, 0) = second.patches(0, 0);
  return surface;
}

/// The same surface with weights q^(i + j): its parameters change, its points do not.
inline BezierSurface weighted(BezierSurface surface, double q) {
  surface.rational = true;
  for (RationalBezierPatch& patch : surface.patches.values())
    for (int i = 0; i <= patch.degree_u(); ++i)
      for (int j = 0; j <= patch.degree_v(); ++j) patch.points(i, j) *= std::pow(q, i + j);
  return surface;
}

/// A wavy graph of the given degree in both directions, about the height 0.
inline BezierSurface waves(int degree) {
  Grid<Vec4> net(degree + 1, degree + 1);
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j) {
      const double x = i / static_cast<double>(degree), y = j / static_cast<double>(degree);
      net(i, j) = {x, y, 2 * std::sin(7 * x + y) * std::cos(5 * y - x), 1};
    }
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{net});
  return surface;
}

inline std::vector<SurfacePair> surface_pairs() {
  const CubicPair loop_pair = cubic_pair(loop(0.43, 0.57, 0.2));
  const BezierSurface tilted = plane({-3, -3.1, -0.4}, {6, 0.1, 1.3}, {-0.2, 6.1, 0.7});
  const Cubic bowl = loop(0.46, 0.52, 0.21);
  const BezierSurface floor = graph(constant(0), {-0.1, -0.1}, {1.3, 0.1}, {-0.05, 1.2});
  return {{"polynomial", loop_pair.a, loop_pair.b},
          {"rational", weighted(loop_pair.a, 1.2), weighted(loop_pair.b, 0.85)},
          {"rational_and_polynomial", weighted(loop_pair.a, 0.7), loop_pair.b},
          {"cylinder_and_plane", cylinder(1, -3, 3), tilted},
          {"torus_and_plane", torus(1.5, 0.6), tilted},
          {"torus_and_cylinder", torus(1.5, 0.6), cylinder(1.6, -2, 2)},
          {"degree_10", waves(10), floor},
          {"rational_of_degree_8", weighted(waves(8), 1.1), floor},
          {"third_derivative_jumps", bent(bowl, 0.4, 2, 3), floor},
          {"curvature_jumps", bent(bowl, 0.4, 1, 2), floor},
          {"crease", bent(bowl, 0.4, 0.2, 1), floor}};
}

}  // namespace blossom::testing
