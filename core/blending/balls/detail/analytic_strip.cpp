// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/detail/analytic_strip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/blending/balls/detail/strip_section.h"

namespace blossom {
namespace {

// Of the largest coordinate: solutions of the ball's equations are good to some 100 roundings, and
// a circle through three of them to their distances' ratio more.
constexpr double kRounding = 1e-11;
// A radius of rotation below this part of the ball's is none.
constexpr double kMinTurn = 1e-9;

struct Section {
  Vec3 centre;  // of the ball
  CharacteristicCircle circle;
};

double size_of(const std::vector<Section>& sections) {
  double size = 0;
  for (const Section& s : sections) size = std::max(size, max_norm(s.centre) + s.circle.radius);
  return size;
}

// From one unit vector to another, right-handed about the axis, in (-pi, pi].
double turn(const Vec3& axis, const Vec3& from, const Vec3& to) {
  return std::atan2(dot(axis, cross(from, to)), dot(from, to));
}

bool is_line(const std::vector<Section>& sections, const Vec3& axis, double size) {
  const Section& first = sections.front();
  const double slope = (sections.back().circle.radius - first.circle.radius) /
                       dot(sections.back().circle.centre - first.circle.centre, axis);
  for (const Section& s : sections) {
    const Vec3 way = s.circle.centre - first.circle.centre;
    if (norm(way - axis * dot(way, axis)) > kRounding * size) return false;
    const double radius = first.circle.radius + slope * dot(way, axis);
    if (std::abs(s.circle.radius - radius) > kRounding * size) return false;
    for (std::size_t k = 0; k < 2; ++k)
      if (norm(s.circle.to_contact[k] - first.circle.to_contact[k]) * radius > kRounding * size)
        return false;
  }
  return true;
}

AnalyticStrip along_line(const std::vector<Section>& sections, const Vec3& axis, double size) {
  const CharacteristicCircle &first = sections.front().circle, &last = sections.back().circle;
  AnalyticStrip strip;
  const double way = dot(last.centre - first.centre, axis);
  const double change = last.radius - first.radius;
  strip.surface.axis = axis;
  strip.x = first.to_contact[0];
  strip.across = {0, turn(axis, first.to_contact[0], first.to_contact[1])};
  if (std::abs(change) <= kRounding * size) {
    strip.surface.kind = ElementaryKind::Cylinder;
    strip.surface.centre = first.centre;
    strip.surface.radius = first.radius;
    strip.along = {0, way};
    return strip;
  }
  const double to_apex = -first.radius * way / change;  // from the first circle, along the axis
  strip.surface.kind = ElementaryKind::Cone;
  strip.surface.centre = first.centre + axis * to_apex;
  strip.surface.angle = std::atan(std::abs(change / way));
  strip.along = {-to_apex, way - to_apex};
  return strip;
}

// The axis of the circle through three points of the track; zero if they are on a line.
Elementary circle_through(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 p = b - a, q = c - a, n = cross(p, q);
  const double nn = dot(n, n);
  Elementary torus;
  torus.kind = ElementaryKind::Torus;
  torus.axis = unit(n);
  if (!(nn > 0)) return torus;
  torus.centre = a + (cross(n, p) * dot(q, q) - cross(n, q) * dot(p, p)) * (1 / (2 * nn));
  torus.radius = distance(a, torus.centre);
  return torus;
}

std::optional<AnalyticStrip> along_circle(const std::vector<Section>& sections, double size) {
  const std::size_t third = sections.size() / 3;
  AnalyticStrip strip;
  strip.surface =
      circle_through(sections.front().centre, sections[third].centre, sections[2 * third].centre);
  const Elementary& torus = strip.surface;
  const Section& first = sections.front();
  strip.surface.minor = first.circle.radius;
  if (!(torus.radius > kMinTurn * torus.minor)) return std::nullopt;
  const auto outward = [&](const Section& s) { return unit(s.centre - torus.centre); };
  strip.x = outward(first);
  double angle = 0;
  Vec3 before = strip.x;
  for (const Section& s : sections) {
    const Vec3 way = s.centre - torus.centre, out = outward(s);
    if (std::abs(norm(way) - torus.radius) > kRounding * size ||
        std::abs(dot(way, torus.axis)) > kRounding * size ||
        std::abs(s.circle.radius - torus.minor) > kRounding * size)
      return std::nullopt;
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3 &e = s.circle.to_contact[k], &f = first.circle.to_contact[k];
      if (std::abs(dot(e, out) - dot(f, strip.x)) * torus.minor > kRounding * size ||
          std::abs(dot(e - f, torus.axis)) * torus.minor > kRounding * size)
        return std::nullopt;
    }
    angle += turn(torus.axis, before, out);
    before = out;
  }
  strip.along = {0, angle};
  const auto tube = [&](const Vec3& e) { return std::atan2(dot(e, torus.axis), dot(e, strip.x)); };
  const double from = tube(first.circle.to_contact[0]), to = tube(first.circle.to_contact[1]);
  strip.across = {from, from + std::remainder(to - from, 2 * std::numbers::pi)};
  return strip;
}

}  // namespace

std::optional<AnalyticStrip> analytic_strip(const BallTrack& track, const Interval& range) {
  std::vector<Section> sections;
  for (int i = 0; i < kAnalyticSamples; ++i) {
    const BallPoint ball = track.at(at(range, i / (kAnalyticSamples - 1.0)));
    sections.push_back({ball.centre, characteristic_circle(ball)});
  }
  const double size = size_of(sections);
  const Vec3 axis = unit(sections.back().circle.centre - sections.front().circle.centre);
  if (norm(axis) > 0.5 && is_line(sections, axis, size)) return along_line(sections, axis, size);
  return along_circle(sections, size);
}

}  // namespace blossom
