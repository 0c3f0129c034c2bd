// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/corner_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <TColgp_Array1OfPnt2d.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/faces/surface_projector.h"

namespace blossom::occt {
namespace {

constexpr double kStraight = 1e-6;  // radians: turns below take no handles but those of a line

Vec3 in_space(const Handle(Geom_Surface) & surface, const Vec2& at, const Vec2& step) {
  const SurfaceJet frame = frame_at(surface, at);
  return step[0] * frame.du + step[1] * frame.dv;
}

// A cubic over a turn of a circle by an angle has handles of 4/3 tan(turn / 4) radii; the way to
// where its end tangents meet is tan(turn / 2) of them, half the chord sin(turn / 2).
double handle(double turn, double leg, double chord) {
  if (turn < kStraight) return chord / 3;
  const double of_radius = 4.0 / 3 * std::tan(turn / 4);
  if (leg > 0 && turn < std::numbers::pi - kStraight) return leg * of_radius / std::tan(turn / 2);
  return chord * of_radius / (2 * std::sin(turn / 2));
}

// The same place a whole number of turns off, as near as can be to another one.
Vec2 near_to(const Handle(Geom_Surface) & surface, Vec2 place, const Vec2& other) {
  const auto turns = turns_of(surface);
  for (int d = 0; d < 2; ++d)
    if (const double turn = turns[static_cast<std::size_t>(d)]; turn > 0)
      place[d] += turn * std::round((other[d] - place[d]) / turn);
  return place;
}

// How far two lines through points, along unit directions, go until they are nearest to each other;
// 0 for both where that is behind one of the points.
std::array<double, 2> ways_to_meet(const Vec3& a, const Vec3& along_a, const Vec3& b,
                                   const Vec3& along_b) {
  const double c = dot(along_a, along_b), p = dot(along_a, a - b), q = dot(along_b, a - b);
  const double s = (c * q - p) / (1 - c * c), t = (q - c * p) / (1 - c * c);
  return s > 0 && t > 0 ? std::array{s, t} : std::array{0.0, 0.0};
}

bool is_contact(const PathEnd& end) { return norm(end.ahead) > 0; }

}  // namespace

Handle(Geom2d_BezierCurve)
    corner_path(const Handle(Geom_Surface) & surface, const PathEnd& from, const PathEnd& to) {
  const Vec2 a = from.chart, b = near_to(surface, to.chart, a);
  const gp_Pnt start = surface->Value(a[0], a[1]), end = surface->Value(b[0], b[1]);
  const double chord = start.Distance(end);
  std::array<Vec2, 4> poles{a, a + (1.0 / 3) * (b - a), a + (2.0 / 3) * (b - a), b};
  if (is_contact(from) && is_contact(to)) {
    const Vec3 out = unit(in_space(surface, a, from.ahead));
    const Vec3 in = -unit(in_space(surface, b, to.ahead));
    const double turn = std::atan2(norm(cross(out, in)), dot(out, in));
    std::array legs{from.leg, to.leg};
    if (legs[0] <= 0 || legs[1] <= 0)
      legs = ways_to_meet({start.X(), start.Y(), start.Z()}, out, {end.X(), end.Y(), end.Z()}, -in);
    poles[1] = a + handle(turn, legs[0], chord) * from.ahead;
    poles[2] = b + handle(turn, legs[1], chord) * to.ahead;
  } else if (is_contact(from) || is_contact(to)) {
    // A parabola whose tangents meet half the way to the edge.
    const PathEnd& contact = is_contact(from) ? from : to;
    const Vec2 place = is_contact(from) ? a : b;
    const Vec2 meet =
        place + 0.5 * (contact.leg > 0 ? std::min(contact.leg, chord) : chord) * contact.ahead;
    poles[1] = a + (2.0 / 3) * (meet - a);
    poles[2] = b + (2.0 / 3) * (meet - b);
  }
  TColgp_Array1OfPnt2d points(1, 4);
  for (int i = 0; i < 4; ++i) {
    const Vec2& p = poles[static_cast<std::size_t>(i)];
    points(i + 1) = {p[0], p[1]};
  }
  return new Geom2d_BezierCurve(points);
}

}  // namespace blossom::occt
