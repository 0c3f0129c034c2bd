// SPDX-License-Identifier: LGPL-2.1-or-later
// The bound on the distance of two elementary surfaces, against distances of points.

#include "core/forms/elementary.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace blossom {
namespace {

using std::numbers::pi;

using Random = std::mt19937;

double draw(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

Vec3 direction(Random& random) {
  return unit(Vec3{draw(random, -1, 1), draw(random, -1, 1), draw(random, 0.1, 1)});
}

Elementary drawn(Random& random, ElementaryKind kind) {
  Elementary of{kind,
                {},
                direction(random),
                draw(random, 2, 5),
                draw(random, 0.5, 1.5),
                draw(random, 0.2, 1.2)};
  for (int k = 0; k < 3; ++k) of.centre[k] = draw(random, -10, 10);
  return of;
}

Elementary moved(Random& random, Elementary of, double by) {
  for (int k = 0; k < 3; ++k) of.centre[k] += draw(random, -by, by);
  of.axis = unit(of.axis + by * direction(random));
  of.radius += draw(random, -by, by);
  of.minor += draw(random, -by, by);
  of.angle += draw(random, -by, by);
  return of;
}

// The distance from the axis and the height along it.
Vec2 profile(const Elementary& of, const Vec3& p) {
  const double height = dot(p - of.centre, of.axis);
  return {norm(p - of.centre - height * of.axis), height};
}

double distance_from(const Elementary& of, const Vec3& p) {
  const Vec2 at = profile(of, p);
  switch (of.kind) {
    case ElementaryKind::Plane: return std::abs(at[1]);
    case ElementaryKind::Cylinder: return std::abs(at[0] - of.radius);
    case ElementaryKind::Cone:
      return std::abs(at[0] * std::cos(of.angle) - std::abs(at[1]) * std::sin(of.angle));
    case ElementaryKind::Sphere: return std::abs(distance(p, of.centre) - of.radius);
    case ElementaryKind::Torus: break;
  }
  return std::abs(std::hypot(at[0] - of.radius, at[1]) - of.minor);
}

// Some point of a surface, not far from its centre.
Vec3 point_of(Random& random, const Elementary& of) {
  const Vec3 x = unit(cross(of.axis, Vec3{0.3, -0.5, 0.1})), y = cross(of.axis, x);
  const double turn = draw(random, -pi, pi), height = draw(random, 0.5, 6);
  const double tilt = draw(random, -pi, pi);
  const auto at = [&](double r, double h) {
    return of.centre + r * (std::cos(turn) * x + std::sin(turn) * y) + h * of.axis;
  };
  switch (of.kind) {
    case ElementaryKind::Plane: return at(height, 0);
    case ElementaryKind::Cylinder: return at(of.radius, height);
    case ElementaryKind::Cone: return at(height * std::tan(of.angle), height);
    case ElementaryKind::Sphere: return at(of.radius * std::cos(tilt), of.radius * std::sin(tilt));
    case ElementaryKind::Torus: break;
  }
  return at(of.radius + of.minor * std::cos(tilt), of.minor * std::sin(tilt));
}

constexpr std::array kKinds{ElementaryKind::Plane, ElementaryKind::Cylinder, ElementaryKind::Cone,
                            ElementaryKind::Sphere, ElementaryKind::Torus};

TEST(DistanceBoundOfElementarySurfaces, HoldsForPointsInTheBall) {
  Random random(7);
  for (const ElementaryKind kind : kKinds)
    for (int i = 0; i < 2000; ++i) {
      const Elementary a = drawn(random, kind);
      const Elementary b = moved(random, a, std::pow(10, draw(random, -9, -2)));
      const Vec3 p = point_of(random, a);
      const Ball ball{p + draw(random, 0, 3) * direction(random), 5};
      EXPECT_LE(distance_from(b, p), distance_bound(a, b, ball)) << static_cast<int>(kind);
    }
}

TEST(DistanceBoundOfElementarySurfaces, IsRoundingForOneSurfaceWithItsAxisTurnedRound) {
  Random random(8);
  for (const ElementaryKind kind : kKinds)
    for (int i = 0; i < 100; ++i) {
      const Elementary a = drawn(random, kind);
      Elementary b = a;
      b.axis = -a.axis;
      EXPECT_LE(distance_bound(a, b, {a.centre, 10}), 1e-12);
    }
}

TEST(DistanceBoundOfElementarySurfaces, IsNoMoreThanWhatMovedThem) {
  const Elementary plane{ElementaryKind::Plane, {0, 0, 0}, {0, 0, 1}};
  Elementary other = plane;
  other.centre = {5, 7, 1e-6};
  EXPECT_NEAR(distance_bound(plane, other, {{0, 0, 0}, 1000}), 1e-6, 1e-9);
  other.centre = {0, 0, 0};
  other.axis = unit(Vec3{1e-9, 0, 1});
  EXPECT_NEAR(distance_bound(plane, other, {{0, 0, 0}, 1000}), 1e-6, 1e-9);
  const Elementary rod{ElementaryKind::Cylinder, {0, 0, 0}, {0, 0, 1}, 3};
  Elementary bore = rod;
  bore.radius = 3 + 1e-7;
  EXPECT_NEAR(distance_bound(rod, bore, {{0, 0, 0}, 1000}), 1e-7, 1e-10);
}

TEST(DistanceBoundOfElementarySurfaces, IsInfiniteForTwoKinds) {
  const Elementary plane{ElementaryKind::Plane, {0, 0, 0}, {0, 0, 1}};
  const Elementary ball{ElementaryKind::Sphere, {0, 0, 1}, {0, 0, 1}, 1};
  EXPECT_FALSE(std::isfinite(distance_bound(plane, ball, {{0, 0, 0}, 1})));
}

// At a point of each one, and a step off it along its normal there.
TEST(Elementary, HeightsOverThemGrowAlongNormals) {
  const Vec3 centre{1, -2, 3}, axis{0, 0, 1};
  const double angle = 0.3, step = 0.125;
  struct Case {
    Elementary surface;
    Vec3 point, normal;
  };
  const Vec3 slope{std::cos(angle), 0, -std::sin(angle)};
  for (const Case& one :
       {Case{{ElementaryKind::Plane, centre, axis, 0, 0, 0}, {5, 5, 3}, axis},
        Case{{ElementaryKind::Cylinder, centre, axis, 2, 0, 0}, {3, -2, 9}, {1, 0, 0}},
        Case{{ElementaryKind::Cone, centre, axis, 0, 0, angle},
             {1 + 4 * std::tan(angle), -2, 7},
             slope},
        Case{{ElementaryKind::Cone, centre, axis, 0, 0, angle},
             {1 + 4 * std::tan(angle), -2, -1},
             {slope[0], 0, -slope[2]}},
        Case{{ElementaryKind::Sphere, centre, axis, 2, 0, 0}, {1, 0, 3}, {0, 1, 0}},
        Case{{ElementaryKind::Torus, centre, axis, 2, 0.5, 0}, {3, -2, 3.5}, {0, 0, 1}},
        Case{{ElementaryKind::Torus, centre, axis, 2, 0.5, 0}, {2.5, -2, 3}, {-1, 0, 0}}})
    for (const double off : {-step, 0.0, step}) {
      const Height height = height_over(one.surface, one.point + off * one.normal);
      EXPECT_NEAR(height.value, off, 1e-15);
      EXPECT_LT(distance(height.rise, one.normal), 1e-15);
    }
}

}  // namespace
}  // namespace blossom
