// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/meetings/pipe_joint.h"

#include <cmath>
#include <numbers>

#include "core/math/functions/quadrature.h"

namespace blossom {
namespace {

// Bends that differ by less, in parts of the tube's radius, leave each other at hardly any angle;
// axes of bends that cross at less have no common direction.
constexpr double kMinBend = 1e-3;
constexpr double kAccuracy = 1e-12;  // of a length

// A function with its first two derivatives.
struct Jet {
  double value = 0, first = 0, second = 0;
};
Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.first + b.first, a.second + b.second};
}
Jet operator*(double s, const Jet& a) { return {s * a.value, s * a.first, s * a.second}; }
Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + 2 * a.first * b.first + a.value * b.second};
}
Jet from_one(const Jet& a) { return {1 - a.value, -a.first, -a.second}; }
Jet root(const Jet& a) {
  const double value = std::sqrt(a.value), first = 0.5 * a.first / value;
  return {value, first, (0.5 * a.second - first * first) / value};
}
Jet over(const Jet& a, const Jet& b) {
  const double value = a.value / b.value, first = (a.first - value * b.first) / b.value;
  return {value, first, (a.second - 2 * first * b.first - value * b.second) / b.value};
}
Jet sine(double t) { return {std::sin(t), std::cos(t), -std::sin(t)}; }
Jet cosine(double t) { return {std::cos(t), -std::sin(t), -std::cos(t)}; }

// A point with its first two derivatives, as a sum of directions times functions.
void add(const Jet& by, const Vec3& direction, std::array<Vec3, 3>& point) {
  point[0] += by.value * direction;
  point[1] += by.first * direction;
  point[2] += by.second * direction;
}

// Along with u = cos x + sin y for x, y across the axis.
std::array<Vec3, 3> point_of(const PipeCrossing& c, const Vec3& x, const Vec3& y, const Jet& cos,
                             const Jet& sin, const Jet& w, const Jet& z) {
  const PipeJoint& joint = c.joint;
  std::array<Vec3, 3> point{joint.centre, {}, {}};
  add(joint.radius * cos, x, point);
  add(joint.radius * sin, y, point);
  add(0.5 * w, joint.bends[static_cast<std::size_t>(c.bend)], point);
  add(z, joint.axis, point);
  return point;
}

// Through both points: F u = sin^2 t.
std::array<Vec3, 3> jet_of_one_loop(const PipeCrossing& c, double t) {
  const Vec3& bend = c.joint.bends[static_cast<std::size_t>(c.bend)];
  const Vec3 aside = cross(c.joint.axis, c.towards);
  const double r = c.joint.radius;
  const Jet s = sine(t), cos = s * s, sin = cosine(t) * root(Jet{1, 0, 0} + cos);
  const Jet w = c.reach * cos;
  const Jet left = from_one(r * dot(bend, c.towards) * cos + r * dot(bend, aside) * sin +
                            0.25 * dot(bend, bend) * w);
  return point_of(c, c.towards, aside, cos, sin, w, std::sqrt(c.reach) * s * root(left));
}

// What F u is for the point of the pipe at an angle about its bend: with S = sin^2(angle / 2)
//   S = u M(S),   M = S r k + k^2 reach / 4 F
Vec3 reached(const PipeCrossing& c, const Vec3& bend, double s) {
  return s * c.joint.radius * bend + 0.25 * dot(bend, bend) * c.reach * c.towards;
}

std::array<Vec3, 3> jet_of_two_loops(const PipeCrossing& c, double t) {
  const Vec3& bend = c.joint.bends[static_cast<std::size_t>(c.bend)];
  const double r = c.joint.radius, most = norm(bend);
  const Vec3 x = (1 / most) * bend, y = cross(c.joint.axis, x);
  const Jet half = sine(0.5 * t), s = Jet{half.value, 0.5 * half.first, 0.25 * half.second} *
                                      Jet{half.value, 0.5 * half.first, 0.25 * half.second};
  const Vec3 at_joint = reached(c, bend, 0);
  const Jet mx = Jet{dot(at_joint, x), 0, 0} + r * most * s, my = Jet{dot(at_joint, y), 0, 0};
  // u is M's direction turned by the angle whose cosine is S / |M|.
  const Jet square = mx * mx + my * my;
  const Jet along = over(s, square), aside = over(root(square + -1.0 * (s * s)), square);
  const Jet cos = along * mx + -1.0 * c.loop * (aside * my);
  const Jet sin = along * my + 1.0 * c.loop * (aside * mx);
  const Jet arm = from_one(r * most * cos);  // from the centre of the bend, in radii of it
  return point_of(c, x, y, cos, sin, 4 / (most * most) * (s * arm), 1 / most * (sine(t) * arm));
}

bool is_pipe(const Elementary& of) {
  return of.kind == ElementaryKind::Cylinder ||
         (of.kind == ElementaryKind::Torus && of.minor < of.radius);
}

double tube_of(const Elementary& pipe) {
  return pipe.kind == ElementaryKind::Torus ? pipe.minor : pipe.radius;
}

// How far the middle of a bent pipe is from a point, and from the direction there.
double misfit(const Elementary& torus, const Vec3& point, const Vec3& axis) {
  const Vec3 arm = point - torus.centre;
  const double height = dot(arm, torus.axis);
  const Vec3 level = arm - height * torus.axis;
  const double tilt = std::hypot(dot(axis, torus.axis), dot(axis, level) / torus.radius);
  return std::abs(height) + std::abs(norm(level) - torus.radius) + tilt * torus.minor;
}

// The places in which the middles of two pipes may run along each other, and directions.
std::vector<std::array<Vec3, 2>> places(const Elementary& torus, const Elementary& other) {
  if (other.kind == ElementaryKind::Cylinder)
    return {{other.centre + dot(torus.centre - other.centre, other.axis) * other.axis, other.axis}};
  const Vec3 both = cross(torus.axis, other.axis), between = other.centre - torus.centre;
  const double sine = norm(both);
  Vec3 axis = (1 / sine) * both;
  if (!(sine > kMinBend)) {
    const Vec3 level = across(between, torus.axis);
    if (!(norm(level) > 0)) return {};
    axis = cross(torus.axis, unit(level));
  }
  const Vec3 arm = torus.radius * unit(cross(torus.axis, axis));
  return {{torus.centre + arm, axis}, {torus.centre - arm, axis}};
}

Vec3 bend_at(const Elementary& pipe, const Vec3& point) {
  if (pipe.kind == ElementaryKind::Cylinder) return {};
  return (1 / pipe.radius) * unit(across(pipe.centre - point, pipe.axis));
}

}  // namespace

std::array<Vec3, 3> jet_at(const PipeCrossing& crossing, double t) {
  return crossing.loop == 0 ? jet_of_one_loop(crossing, t) : jet_of_two_loops(crossing, t);
}

double arc_length(const PipeCrossing& crossing, const Interval& range) {
  return integral([&](double t) { return norm(jet_at(crossing, t)[1]); }, range.from, range.to,
                  kAccuracy * std::sqrt(crossing.reach))
      .value;
}

std::optional<PipeJoint> pipe_joint(const Elementary& a, const Elementary& b, double exact) {
  if (!is_pipe(a) || !is_pipe(b)) return {};
  const bool first = a.kind == ElementaryKind::Torus;
  if (!first && b.kind != ElementaryKind::Torus) return {};
  for (const auto& [centre, axis] : first ? places(a, b) : places(b, a)) {
    PipeJoint joint{centre, axis, 0.5 * (tube_of(a) + tube_of(b)), {}, 0};
    joint.gap = std::abs(tube_of(a) - tube_of(b));
    for (const Elementary* of : {&a, &b})
      if (of->kind == ElementaryKind::Torus) joint.gap += misfit(*of, centre, axis);
    if (!(joint.gap <= exact)) continue;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}})
      joint.bends[k] = across(bend_at(k == 0 ? a : b, centre), axis);
    if (joint.radius * distance(joint.bends[0], joint.bends[1]) > kMinBend) return joint;
  }
  return {};
}

std::vector<PipeCrossing> crossings_beside(const PipeJoint& joint) {
  const std::size_t less = norm(joint.bends[0]) < norm(joint.bends[1]) ? 0 : 1;
  const Vec3 apart = joint.bends[1 - less] - joint.bends[less];
  PipeCrossing crossing{
      joint, static_cast<int>(less), unit(apart), 4 * joint.radius / norm(apart), 0, {}};
  const double beyond = norm(reached(crossing, joint.bends[less], 1)) - 1;
  if (std::abs(beyond) < kMinBend) return {};
  if (beyond < 0) {
    crossing.nodes = {0, std::numbers::pi};
    return {crossing};
  }
  crossing.nodes = {0};
  std::vector<PipeCrossing> both(2, crossing);
  both[0].loop = 1;
  both[1].loop = -1;
  return both;
}

}  // namespace blossom
