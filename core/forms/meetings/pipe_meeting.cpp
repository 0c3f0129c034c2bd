// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/meetings/pipe_meeting.h"

#include <cmath>
#include <numbers>

#include "core/forms/meetings/pipe_joint.h"

namespace blossom {
namespace {

using Known = std::optional<ElementaryMeeting>;

MeetingCurve touching_circle(const Vec3& centre, const Vec3& x, const Vec3& axis, double radius,
                             double gap) {
  return {{ConicKind::Circle, centre, x, cross(axis, x), radius, radius}, true, gap};
}

// The circle touches, and nothing crosses: all of the sphere is within the tube.
Known sphere_in_torus(const Elementary& sphere, const Elementary& torus,
                      const MeetingLimits& limits) {
  if (torus.minor >= torus.radius) return {};
  const Vec3 arm = sphere.centre - torus.centre, level = across(arm, torus.axis);
  const double gap = std::hypot(dot(arm, torus.axis), norm(level) - torus.radius) +
                     std::abs(sphere.radius - torus.minor);
  if (gap > limits.exact) return {};
  const Vec3 x = unit(level);
  return ElementaryMeeting{
      {touching_circle(sphere.centre, x, cross(torus.axis, x), sphere.radius, gap)}, {}};
}

// Near a node, x along the joint and z along the pipes from there, the surfaces are about
// |d| / 2 z^2 (x - |d| z^2 / 4) apart: what changes that by the gap moves the crossing by about
// z^4 = 8 gap / d^2.
Known touching_pipes(const Elementary& a, const Elementary& b, const MeetingLimits& limits) {
  const auto joint = pipe_joint(a, b, limits.exact);
  if (!joint) return {};
  ElementaryMeeting made;
  made.crossings = crossings_beside(*joint);
  if (made.crossings.empty()) return {};
  const Vec3 x = made.crossings.front().towards, y = cross(joint->axis, x);
  made.curves = {touching_circle(joint->centre, x, joint->axis, joint->radius, joint->gap)};
  made.curves.front().nodes = {0.5 * std::numbers::pi, 1.5 * std::numbers::pi};
  const double apart = distance(joint->bends[0], joint->bends[1]);
  const double reach = std::sqrt(std::sqrt(8 * joint->gap) / apart);
  for (const double sign : {-1.0, 1.0})
    made.nodes.push_back({joint->centre + sign * joint->radius * y, joint->gap, reach});
  return made;
}

}  // namespace

Known meeting_of_pipes(const Elementary& a, const Elementary& b, const MeetingLimits& limits) {
  const bool ball_a = a.kind == ElementaryKind::Sphere, ball_b = b.kind == ElementaryKind::Sphere;
  if (ball_a && b.kind == ElementaryKind::Torus) return sphere_in_torus(a, b, limits);
  if (ball_b && a.kind == ElementaryKind::Torus) return sphere_in_torus(b, a, limits);
  return touching_pipes(a, b, limits);
}

}  // namespace blossom
