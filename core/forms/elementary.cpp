// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/elementary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/unbounded.h"

namespace blossom {
namespace {

constexpr double kPlacingRounding = 0x1p-48;  // of the coordinates: some ten steps

double sine_between(const Elementary& a, const Elementary& b) {
  return norm(cross(a.axis, b.axis));
}

double angle_between(const Elementary& a, const Elementary& b) {
  return 0.5 * std::numbers::pi * std::min(sine_between(a, b), 1.0);
}

double plane_bound(const Elementary& a, const Elementary& b, const Ball& ball) {
  const Vec3 foot = ball.centre - dot(ball.centre - a.centre, a.axis) * a.axis;
  return std::abs(dot(foot - b.centre, b.axis)) + sine_between(a, b) * ball.radius;
}

double cylinder_bound(const Elementary& a, const Elementary& b, const Ball& ball) {
  const Vec3 foot = a.centre + dot(ball.centre - a.centre, a.axis) * a.axis;
  return norm(across(foot - b.centre, b.axis)) +
         sine_between(a, b) * (ball.radius + distance(foot, ball.centre)) +
         std::abs(a.radius - b.radius);
}

double cone_bound(const Elementary& a, const Elementary& b, const Ball& ball) {
  return distance(a.centre, b.centre) + (angle_between(a, b) + std::abs(a.angle - b.angle)) *
                                            (ball.radius + distance(ball.centre, a.centre));
}

double sphere_bound(const Elementary& a, const Elementary& b) {
  return distance(a.centre, b.centre) + std::abs(a.radius - b.radius);
}

double torus_bound(const Elementary& a, const Elementary& b) {
  return sphere_bound(a, b) + angle_between(a, b) * a.radius + std::abs(a.minor - b.minor);
}

double bound_of_moves(const Elementary& a, const Elementary& b, const Ball& ball) {
  switch (a.kind) {
    case ElementaryKind::Plane: return plane_bound(a, b, ball);
    case ElementaryKind::Cylinder: return cylinder_bound(a, b, ball);
    case ElementaryKind::Cone: return cone_bound(a, b, ball);
    case ElementaryKind::Sphere: return sphere_bound(a, b);
    case ElementaryKind::Torus: break;
  }
  return torus_bound(a, b);
}

// The plane through the apex of a cone across its axis.
Elementary flattened(const Elementary& cone) {
  return {ElementaryKind::Plane, cone.centre, cone.axis, 0, 0, 0};
}

double flat_cone_bound(const Elementary& plane, const Elementary& cone, const Ball& ball) {
  const double rise = (ball.radius + distance(ball.centre, cone.centre)) / std::tan(cone.angle);
  return plane_bound(plane, flattened(cone), ball) + rise;
}

}  // namespace

Height height_over(const Elementary& surface, const Vec3& point) {
  const Vec3 from = point - surface.centre, radial = across(from, surface.axis);
  const Vec3 out = unit(radial);
  const double along = dot(from, surface.axis), round = norm(radial);
  switch (surface.kind) {
    case ElementaryKind::Plane: return {along, surface.axis};
    case ElementaryKind::Cylinder: return {round - surface.radius, out};
    case ElementaryKind::Cone: {
      const Vec3 rise = std::cos(surface.angle) * out -
                        std::copysign(std::sin(surface.angle), along) * surface.axis;
      return {dot(rise, from), rise};
    }
    case ElementaryKind::Sphere: return {norm(from) - surface.radius, unit(from)};
    case ElementaryKind::Torus: break;
  }
  const Vec3 beside = from - surface.radius * out;
  return {norm(beside) - surface.minor, unit(beside)};
}

double distance_bound(const Elementary& a, const Elementary& b, const Ball& ball) {
  if (a.kind == ElementaryKind::Plane && b.kind == ElementaryKind::Cone)
    return flat_cone_bound(a, b, ball);
  if (a.kind == ElementaryKind::Cone && b.kind == ElementaryKind::Plane)
    return flat_cone_bound(b, a, ball);
  if (a.kind != b.kind) return kInfinity;
  const double coordinate = std::max({max_norm(a.centre), max_norm(b.centre), max_norm(ball.centre),
                                      ball.radius, a.radius, a.minor});
  return bound_of_moves(a, b, ball) + kPlacingRounding * coordinate;
}

}  // namespace blossom
