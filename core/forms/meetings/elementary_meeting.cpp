// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/meetings/elementary_meeting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/forms/meetings/pipe_meeting.h"

namespace blossom {
namespace {

// Sine of the angle between a plane and an axis, of a plane's and a cone's slope, or of two axes,
// below which the ellipse is so long that its ends are nowhere; of lines in a half plane likewise
// below which they hardly cross.
constexpr double kMinSine = 1e-3;

using Known = std::optional<ElementaryMeeting>;

Conic line(const Vec3& point, const Vec3& direction) {
  return {ConicKind::Line, point, direction, {}, 0, 0};
}

Conic circle(const Vec3& centre, const Vec3& axis, double radius) {
  const Vec3 x = any_across(axis);
  return {ConicKind::Circle, centre, x, cross(axis, x), radius, radius};
}

double reach_of(const Elementary& surface, const Ball& ball) {
  return ball.radius + distance(ball.centre, surface.centre);
}

// How far a surface is, within the ball, from where it would lie as the closed form has it, and
// what that means for what it meets.
class Misfit {
 public:
  Misfit(double off, const MeetingLimits& limits)
      : off_(off), exact_(off <= limits.exact), contact_(limits.contact) {}

  bool is_exact() const { return exact_; }

  // No nearer to each other than this surfaces are apart, wherever the true one lies.
  double contact() const { return exact_ ? contact_ : contact_ + off_; }

  // Whether a curve in which the surfaces cross at an angle stands for the true one. That is off by
  // no more than off / sine; what is curved leaves a chord of less than `contact` alone, so that
  // the sine does not fall to half of it on the way.
  bool settles(double sine) const { return exact_ || 2 * off_ <= contact_ * sine; }

 private:
  double off_;
  bool exact_;
  double contact_;
};

// --- what round surfaces of one axis have in common, told in the half plane beside it

// A point of the half plane: distance from the axis, and along it.
struct ProfilePoint {
  double radius = 0, height = 0;
  bool tangential = false;
  double gap = 0;
  double sine = 1;  // of the angle at which the profiles cross
};
struct Profile {
  std::vector<ProfilePoint> points;
  bool open = false;  // there may be more of them, or fewer
};

// A line in the half plane, or a circle.
struct ProfileLine {
  Vec2 point, direction;  // unit
};
struct ProfileCircle {
  Vec2 centre;
  double radius = 0;
};

// height   of the surface's centre along the axis
std::vector<ProfileLine> lines_of(const Elementary& of, double height) {
  if (of.kind == ElementaryKind::Cylinder) return {{{of.radius, height}, {0, 1}}};
  if (of.kind == ElementaryKind::Cone)
    return {{{0, height}, {std::sin(of.angle), std::cos(of.angle)}},
            {{0, height}, {std::sin(of.angle), -std::cos(of.angle)}}};
  return {};
}

std::optional<ProfileCircle> circle_of(const Elementary& of, double height) {
  if (of.kind == ElementaryKind::Sphere) return ProfileCircle{{0, height}, of.radius};
  if (of.kind == ElementaryKind::Torus && of.minor < of.radius)
    return ProfileCircle{{of.radius, height}, of.minor};
  return {};
}

void add_touch(Profile& profile, const Vec2& at, double gap) {
  if (at[0] >= 0) profile.points.push_back({at[0], at[1], true, gap, 0});
}

void add_crossing(Profile& profile, const Vec2& at, double sine) {
  if (at[0] >= 0) profile.points.push_back({at[0], at[1], false, 0, sine});
}

// Lines that hardly cross are known where they do not, up to a distance from the origin.
void meet(const ProfileLine& a, const ProfileLine& b, double contact, double reach,
          Profile& profile) {
  const double sine = cross(a.direction, b.direction);
  const Vec2 between = b.point - a.point;
  if (std::abs(sine) >= kMinSine)
    return add_crossing(profile, a.point + cross(between, b.direction) / sine * a.direction,
                        std::abs(sine));
  const double apart = std::abs(cross(between, a.direction));
  if (apart - std::abs(sine) * (reach + norm(b.point)) <= contact) profile.open = true;
}

void meet(const ProfileLine& a, const ProfileCircle& b, double contact, Profile& profile) {
  const double along = dot(b.centre - a.point, a.direction);
  const Vec2 foot = a.point + along * a.direction;
  const double off = distance(foot, b.centre), gap = std::abs(off - b.radius);
  if (gap <= contact) return add_touch(profile, foot, gap);
  if (off > b.radius) return;
  const double half = std::sqrt((b.radius - off) * (b.radius + off));
  for (const double sign : {-1.0, 1.0})
    add_crossing(profile, foot + sign * half * a.direction, half / b.radius);
}

// Of circles one of which the other one may lie in.
void meet(const ProfileCircle& a, const ProfileCircle& b, double contact, Profile& profile) {
  const double apart = distance(a.centre, b.centre);
  if (apart <= contact) {  // too near to say where they cross, if they do
    profile.open = profile.open || std::abs(a.radius - b.radius) <= apart + contact;
    return;
  }
  const Vec2 towards = (1 / apart) * (b.centre - a.centre);
  const double outside = apart - a.radius - b.radius;
  const double inside = std::abs(a.radius - b.radius) - apart;
  if (std::abs(outside) <= contact)
    return add_touch(profile, a.centre + (a.radius + 0.5 * outside) * towards, std::abs(outside));
  if (std::abs(inside) <= contact) {
    const double sign = a.radius > b.radius ? 1 : -1;
    return add_touch(profile, a.centre + sign * (a.radius - 0.5 * sign * inside) * towards,
                     std::abs(inside));
  }
  if (outside > 0 || inside > 0) return;
  const double along = 0.5 * (apart + (a.radius - b.radius) * (a.radius + b.radius) / apart);
  const double half = std::sqrt(std::max(0.0, (a.radius - along) * (a.radius + along)));
  const Vec2 foot = a.centre + along * towards, side{-towards[1], towards[0]};
  const double sine = half * apart / (a.radius * b.radius);
  for (const double sign : {-1.0, 1.0}) add_crossing(profile, foot + sign * half * side, sine);
}

// reach   from the centre of a within which all that counts lies
Profile common_profile(const Elementary& a, const Elementary& b, double height, double contact,
                       double reach) {
  const std::vector<ProfileLine> lines_a = lines_of(a, 0), lines_b = lines_of(b, height);
  const std::optional<ProfileCircle> circle_a = circle_of(a, 0), circle_b = circle_of(b, height);
  Profile profile;
  for (const ProfileLine& x : lines_a) {
    for (const ProfileLine& y : lines_b) meet(x, y, contact, reach, profile);
    if (circle_b) meet(x, *circle_b, contact, profile);
  }
  for (const ProfileLine& y : lines_b)
    if (circle_a) meet(y, *circle_a, contact, profile);
  if (circle_a && circle_b) meet(*circle_a, *circle_b, contact, profile);
  return profile;
}

// Circles round an axis; points where they would be none, once each.
ElementaryMeeting turned(const Profile& profile, const Vec3& origin, const Vec3& axis,
                         double contact) {
  ElementaryMeeting made;
  for (const auto& [radius, height, tangential, gap, sine] : profile.points) {
    const Vec3 centre = origin + height * axis;
    const auto is_here = [&, &at = centre](const MeetingPoint& known) {
      return distance(known.point, at) <= contact;
    };
    if (radius > contact)
      made.curves.push_back({circle(centre, axis, radius), tangential, gap});
    else if (std::ranges::none_of(made.points, is_here))
      made.points.push_back({centre, std::max(gap, radius)});
  }
  return made;
}

// Whether what a profile becomes stands for what surfaces beside their places have in common.
bool holds(const Profile& profile, const Misfit& misfit) {
  return misfit.is_exact() || std::ranges::all_of(profile.points, [&](const ProfilePoint& point) {
           return !point.tangential && point.radius > misfit.contact() &&
                  misfit.settles(point.sine);
         });
}

bool is_round(const Elementary& of) { return of.kind != ElementaryKind::Plane; }

bool has_axis(const Elementary& of) { return is_round(of) && of.kind != ElementaryKind::Sphere; }

Known round_one_axis(const Elementary& a, const Elementary& b, const Ball& ball,
                     const MeetingLimits& limits) {
  if (!is_round(a) || !is_round(b) || (!has_axis(a) && !has_axis(b))) return {};
  for (const Elementary* of : {&a, &b})
    if (of->kind == ElementaryKind::Torus && of->minor >= of->radius) return {};
  const Elementary &first = has_axis(a) ? a : b, &second = has_axis(a) ? b : a;
  const Vec3 between = second.centre - first.centre;
  const double tilt = has_axis(second) ? norm(cross(first.axis, second.axis)) : 0;
  const Misfit misfit(norm(across(between, first.axis)) + tilt * reach_of(second, ball), limits);
  if (!misfit.settles(1)) return {};
  const Profile profile = common_profile(first, second, dot(between, first.axis), misfit.contact(),
                                         reach_of(first, ball));
  if (profile.open || !holds(profile, misfit)) return {};
  // Half way between the axes, so that what is off both is the same.
  const Vec3 aside = misfit.is_exact() ? Vec3{} : 0.5 * across(between, first.axis);
  return turned(profile, first.centre + aside, first.axis, limits.contact);
}

// --- planes

Known plane_and_sphere(const Elementary& plane, const Elementary& sphere,
                       const MeetingLimits& limits) {
  const double height = dot(sphere.centre - plane.centre, plane.axis);
  const double gap = std::abs(std::abs(height) - sphere.radius);
  const Vec3 foot = sphere.centre - height * plane.axis;
  ElementaryMeeting made;
  if (gap <= limits.contact)
    made.points.push_back({foot, gap});
  else if (std::abs(height) < sphere.radius)
    made.curves.push_back(
        {circle(foot, plane.axis, std::sqrt((sphere.radius - height) * (sphere.radius + height)))});
  return made;
}

// Lines along the axis of a cylinder.
Known plane_along_cylinder(const Elementary& plane, const Elementary& cylinder, const Ball& ball,
                           const Misfit& misfit) {
  const Vec3 middle =
      cylinder.centre + dot(ball.centre - cylinder.centre, cylinder.axis) * cylinder.axis;
  const double height = dot(middle - plane.centre, plane.axis);
  const double gap = std::abs(std::abs(height) - cylinder.radius);
  const Vec3 foot = middle - height * plane.axis;
  const Vec3 along = unit(across(cylinder.axis, plane.axis));
  ElementaryMeeting made;
  if (gap <= misfit.contact()) {
    if (!misfit.is_exact()) return {};
    made.curves.push_back({line(foot, along), true, gap});
  } else if (std::abs(height) < cylinder.radius) {
    const double half = std::sqrt((cylinder.radius - height) * (cylinder.radius + height));
    if (!misfit.settles(half / cylinder.radius)) return {};
    for (const double sign : {-1.0, 1.0})
      made.curves.push_back({line(foot + sign * half * cross(plane.axis, along), along)});
  }
  return made;
}

Known plane_and_cylinder(const Elementary& plane, const Elementary& cylinder, const Ball& ball,
                         const MeetingLimits& limits) {
  const double slope = dot(plane.axis, cylinder.axis);
  const Misfit misfit(std::abs(slope) * reach_of(cylinder, ball), limits);
  if (misfit.settles(1)) return plane_along_cylinder(plane, cylinder, ball, misfit);
  if (std::abs(slope) < kMinSine) return {};
  const Vec3 centre =
      cylinder.centre + dot(plane.centre - cylinder.centre, plane.axis) / slope * cylinder.axis;
  const double tilt = norm(cross(plane.axis, cylinder.axis));
  if (tilt * cylinder.radius <= limits.exact)
    return ElementaryMeeting{{{circle(centre, plane.axis, cylinder.radius)}}, {}};
  const Vec3 x = unit(across(cylinder.axis, plane.axis));
  // Of nearly parallel axes the product may be above 1 by rounding.
  const double major = cylinder.radius / std::min(1.0, std::abs(slope));
  return ElementaryMeeting{
      {{{ConicKind::Ellipse, centre, x, cross(plane.axis, x), major, cylinder.radius}}}, {}};
}

// Rulings of a cone in a plane through its apex.
Known plane_through_apex(const Elementary& plane, const Elementary& cone, const Ball& ball,
                         const MeetingLimits& limits) {
  const Vec3 shadow = across(cone.axis, plane.axis);
  const double rise = std::atan2(std::abs(dot(cone.axis, plane.axis)), norm(shadow));
  const double steep = cone.angle - rise;  // how far the plane cuts into the cone, radians
  const double gap = std::abs(steep) * reach_of(cone, ball);
  ElementaryMeeting made;
  if (gap <= limits.contact) {
    made.curves.push_back({line(cone.centre, unit(shadow)), true, gap});
  } else if (steep < 0) {
    made.points.push_back({cone.centre, 0});
  } else if (steep < kMinSine) {
    return {};
  } else {
    const Vec3 x = unit(shadow), y = cross(plane.axis, x);
    const double cosine = std::cos(cone.angle) / norm(shadow);
    const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
    for (const double sign : {-1.0, 1.0})
      made.curves.push_back({line(cone.centre, cosine * x + sign * sine * y)});
  }
  return made;
}

// An ellipse round one half of a cone. With E across the axis A the direction in which the plane
// falls, it goes from one to the other of the rulings along cos(angle) A +- sin(angle) E, at the
// distances t from the apex where these are in the plane; half way between its ends the cone is
// sin(angle) sqrt(t t') wide.
Known plane_round_cone(const Elementary& plane, const Elementary& cone, double height,
                       double contact) {
  const double cosine = dot(plane.axis, cone.axis), sign = cosine < 0 ? -1 : 1;
  const Vec3 slope = across(sign * plane.axis, cone.axis);
  const double tilt = std::atan2(norm(slope), std::abs(cosine));
  if (std::cos(tilt + cone.angle) < kMinSine) return {};
  const Vec3 e = unit(across(unit(slope), cone.axis));  // what is short is across within rounding
  const double near = sign * height / std::cos(tilt - cone.angle);
  const double far = sign * height / std::cos(tilt + cone.angle);
  const double c = std::cos(cone.angle), s = std::sin(cone.angle);
  const Vec3 first = near * (c * cone.axis + s * e), last = far * (c * cone.axis - s * e);
  const double minor = s * std::sqrt(near * far), major = 0.5 * distance(first, last);
  const Vec3 centre = cone.centre + 0.5 * (first + last);
  if (minor <= contact) {
    if (major > contact) return {};
    return ElementaryMeeting{{}, {{centre, major}}};
  }
  const Vec3 x = unit(last - first);
  // Of nearly parallel planes the longer one may come out shorter by rounding.
  return ElementaryMeeting{
      {{{ConicKind::Ellipse, centre, x, cross(plane.axis, x), std::max(major, minor), minor}}}, {}};
}

Known plane_and_cone(const Elementary& plane, const Elementary& cone, const Ball& ball,
                     const MeetingLimits& limits) {
  const double height = dot(plane.centre - cone.centre, plane.axis);
  const double reach = reach_of(cone, ball);
  const double tilt = norm(cross(plane.axis, cone.axis));
  if (const Misfit misfit(tilt * reach, limits); misfit.settles(std::cos(cone.angle))) {
    const double radius = std::abs(height) * std::tan(cone.angle), contact = misfit.contact();
    if (std::abs(height) <= contact && radius > contact) return {};  // nearly flat
    if (radius <= contact && !misfit.is_exact()) return {};
    const Vec3 centre = cone.centre + height * plane.axis;
    if (radius <= contact) return ElementaryMeeting{{}, {{centre, std::abs(height)}}};
    return ElementaryMeeting{{{circle(centre, plane.axis, radius)}}, {}};
  }
  if (std::abs(height) <= limits.exact) return plane_through_apex(plane, cone, ball, limits);
  if (std::abs(height) <= limits.contact) return {};  // a point, or nearly
  return plane_round_cone(plane, cone, height, limits.contact);
}

Known plane_and_torus(const Elementary& plane, const Elementary& torus,
                      const MeetingLimits& limits) {
  if (torus.minor >= torus.radius) return {};
  const double height = dot(plane.centre - torus.centre, plane.axis);
  const double most = torus.radius + torus.minor;
  ElementaryMeeting made;
  const Misfit across_axis(norm(cross(plane.axis, torus.axis)) * most, limits);
  if (across_axis.settles(1)) {
    const Vec3 centre = torus.centre + height * plane.axis;
    const double gap = std::abs(std::abs(height) - torus.minor);
    if (gap <= across_axis.contact()) {
      if (!across_axis.is_exact()) return {};
      made.curves.push_back({circle(centre, plane.axis, torus.radius), true, gap});
    } else if (std::abs(height) < torus.minor) {
      const double half = std::sqrt((torus.minor - height) * (torus.minor + height));
      if (!across_axis.settles(half / torus.minor)) return {};
      for (const double sign : {-1.0, 1.0})
        made.curves.push_back({circle(centre, plane.axis, torus.radius + sign * half)});
    }
    return made;
  }
  const double slope = std::abs(dot(plane.axis, torus.axis));
  if (!Misfit(slope * most + std::abs(height), limits).settles(1)) return {};
  const Vec3 aside = unit(cross(plane.axis, torus.axis));
  for (const double sign : {-1.0, 1.0})
    made.curves.push_back(
        {circle(torus.centre + sign * torus.radius * aside, plane.axis, torus.minor)});
  return made;
}

Known with_plane(const Elementary& plane, const Elementary& other, const Ball& ball,
                 const MeetingLimits& limits) {
  switch (other.kind) {
    case ElementaryKind::Plane: return {};
    case ElementaryKind::Cylinder: return plane_and_cylinder(plane, other, ball, limits);
    case ElementaryKind::Cone: return plane_and_cone(plane, other, ball, limits);
    case ElementaryKind::Sphere: return plane_and_sphere(plane, other, limits);
    case ElementaryKind::Torus: break;
  }
  return plane_and_torus(plane, other, limits);
}

// --- spheres and cylinders beside each other

Known two_spheres(const Elementary& a, const Elementary& b, const MeetingLimits& limits) {
  const double apart = distance(a.centre, b.centre);
  if (apart <= limits.contact) {
    if (std::abs(a.radius - b.radius) <= 2 * limits.contact) return {};
    return ElementaryMeeting{};
  }
  const Vec3 axis = (1 / apart) * (b.centre - a.centre);
  Profile profile;
  meet(ProfileCircle{{0, 0}, a.radius}, ProfileCircle{{0, apart}, b.radius}, limits.contact,
       profile);
  return turned(profile, a.centre, axis, limits.contact);
}

// Two ellipses in the planes half way between the axes, which cross over the point that these
// share.
Known crossing_cylinders(const Elementary& a, const Elementary& b, const MeetingLimits& limits) {
  const Vec3 normal = cross(a.axis, b.axis), between = b.centre - a.centre;
  const double sine = norm(normal);
  if (sine < kMinSine) return {};
  const Vec3 y = (1 / sine) * normal;
  const double gap = std::max(std::abs(a.radius - b.radius), std::abs(dot(between, y)));
  if (gap > limits.exact) return {};
  const double along = dot(cross(between, b.axis), y) / sine;
  const Vec3 centre = a.centre + along * a.axis;
  ElementaryMeeting made;
  for (const double sign : {-1.0, 1.0}) {
    const Vec3 across_plane = unit(a.axis + sign * b.axis);
    const double major = a.radius / std::abs(dot(across_plane, a.axis));
    made.curves.push_back(
        {{ConicKind::Ellipse, centre, cross(y, across_plane), y, major, a.radius}});
    made.curves.back().nodes = {0.5 * std::numbers::pi, 1.5 * std::numbers::pi};
    made.nodes.push_back({centre + sign * a.radius * y, gap, std::sqrt(2 * a.radius * gap)});
  }
  return made;
}

Known two_cylinders(const Elementary& a, const Elementary& b, const Ball& ball,
                    const MeetingLimits& limits) {
  const double tilt = norm(cross(a.axis, b.axis));
  const auto middle = [&](const Elementary& of) {
    return of.centre + dot(ball.centre - of.centre, a.axis) * a.axis;
  };
  const Misfit misfit(tilt * (reach_of(a, ball) + reach_of(b, ball)), limits);
  if (!misfit.settles(1)) return crossing_cylinders(a, b, limits);
  const Vec3 from = middle(a), between = across(middle(b) - from, a.axis);
  const double apart = norm(between), contact = misfit.contact();
  if (apart <= contact) {
    if (std::abs(a.radius - b.radius) <= 2 * contact) return {};
    return ElementaryMeeting{};
  }
  // The section across both axes, turned so that the second centre lies on one side of the first.
  const Vec3 x = (1 / apart) * between, y = cross(a.axis, x);
  Profile profile;
  const double far = a.radius + b.radius + apart;  // keeps the half plane out of it
  meet(ProfileCircle{{far, 0}, a.radius}, ProfileCircle{{far + apart, 0}, b.radius}, contact,
       profile);
  if (!holds(profile, misfit)) return {};
  ElementaryMeeting made;
  for (const auto& [radius, height, tangential, gap, sine] : profile.points)
    made.curves.push_back({line(from + (radius - far) * x + height * y, a.axis), tangential, gap});
  return made;
}

// Off the cylinder's axis: apart, within it, or touching in a point.
Known sphere_beside_cylinder(const Elementary& sphere, const Elementary& cylinder,
                             const MeetingLimits& limits) {
  const Vec3 off = across(sphere.centre - cylinder.centre, cylinder.axis);
  const double apart = norm(off);
  const double outside = apart - cylinder.radius - sphere.radius;
  const double inside = cylinder.radius - sphere.radius - apart;
  if (outside > limits.contact || inside > limits.contact) return ElementaryMeeting{};
  if (apart <= limits.contact || sphere.radius >= cylinder.radius + limits.contact) {
    if (std::abs(outside) > limits.contact) return {};
  }
  if (std::abs(outside) <= limits.contact)
    return ElementaryMeeting{
        {}, {{sphere.centre - (sphere.radius + 0.5 * outside) / apart * off, std::abs(outside)}}};
  if (std::abs(inside) <= limits.contact && cylinder.radius - sphere.radius > 4 * limits.contact)
    return ElementaryMeeting{
        {}, {{sphere.centre + (sphere.radius + 0.5 * inside) / apart * off, std::abs(inside)}}};
  return {};
}

}  // namespace

std::optional<ElementaryMeeting> elementary_meeting(const Elementary& a, const Elementary& b,
                                                    const Ball& ball, const MeetingLimits& limits) {
  if (distance_bound(a, b, ball) <= limits.contact) return {};
  if (!is_round(a)) return with_plane(a, b, ball, limits);
  if (!is_round(b)) return with_plane(b, a, ball, limits);
  if (!has_axis(a) && !has_axis(b)) return two_spheres(a, b, limits);
  if (Known known = round_one_axis(a, b, ball, limits)) return known;
  if (a.kind == ElementaryKind::Cylinder && b.kind == ElementaryKind::Cylinder)
    return two_cylinders(a, b, ball, limits);
  if (a.kind == ElementaryKind::Cylinder && b.kind == ElementaryKind::Sphere)
    return sphere_beside_cylinder(b, a, limits);
  if (a.kind == ElementaryKind::Sphere && b.kind == ElementaryKind::Cylinder)
    return sphere_beside_cylinder(a, b, limits);
  return meeting_of_pipes(a, b, limits);
}

}  // namespace blossom
