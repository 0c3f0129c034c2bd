// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/charts/elementary_chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/unbounded.h"

namespace blossom {
namespace {

// Of the radius: as near to the apex of a cone all angles are one point.
constexpr double kAtApex = 1e-9;
// Half of an arc, radians: of wider ones of a torus the closed form is not known.
constexpr double kWideArc = 1.5;

Vec3 radial(const ElementaryChart& chart, double u) {
  return std::cos(u) * chart.x + std::sin(u) * chart.y;
}

// 1 where x, y, z are right-handed, else -1: then S_u x S_v points the other way.
double hand(const ElementaryChart& chart) {
  return dot(cross(chart.x, chart.y), chart.z) < 0 ? -1 : 1;
}

double cone_radius(const ElementaryChart& chart, double v) {
  return chart.radius + v * std::sin(chart.angle);
}

Vec3 point_on(const ElementaryChart& chart, const Vec2& uv) {
  const auto [u, v] = uv.coordinates;
  switch (chart.kind) {
    case ElementaryKind::Plane: return chart.origin + u * chart.x + v * chart.y;
    case ElementaryKind::Cylinder:
      return chart.origin + chart.radius * radial(chart, u) + v * chart.z;
    case ElementaryKind::Cone:
      return chart.origin + cone_radius(chart, v) * radial(chart, u) +
             v * std::cos(chart.angle) * chart.z;
    case ElementaryKind::Sphere:
      return chart.origin + chart.radius * std::cos(v) * radial(chart, u) +
             chart.radius * std::sin(v) * chart.z;
    case ElementaryKind::Torus:
      return chart.origin + (chart.radius + chart.minor * std::cos(v)) * radial(chart, u) +
             chart.minor * std::sin(v) * chart.z;
  }
  return chart.origin;
}

// Turned as in a right-handed frame.
Vec3 outwards(const ElementaryChart& chart, const Vec2& uv) {
  const auto [u, v] = uv.coordinates;
  switch (chart.kind) {
    case ElementaryKind::Plane: return cross(chart.x, chart.y);
    case ElementaryKind::Cylinder: return radial(chart, u);
    case ElementaryKind::Cone: {
      const double side = cone_radius(chart, v) < 0 ? -1 : 1;
      return side * (std::cos(chart.angle) * radial(chart, u) - std::sin(chart.angle) * chart.z);
    }
    case ElementaryKind::Sphere:
    case ElementaryKind::Torus: return std::cos(v) * radial(chart, u) + std::sin(v) * chart.z;
  }
  return {};
}

double cone_distance(const ElementaryChart& chart, const std::array<Vec2, 3>& corners) {
  double low = kInfinity, high = -low, largest = 0;
  std::array<double, 3> radius;
  for (std::size_t i = 0; i < 3; ++i) {
    radius[i] = std::abs(cone_radius(chart, corners[i][1]));
    largest = std::max(largest, radius[i]);
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (radius[i] > kAtApex * largest) {
      low = std::min(low, corners[i][0]);
      high = std::max(high, corners[i][0]);
    }
  double bound = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (radius[i] > kAtApex * largest) {
      const double s = std::sin((corners[i][0] - 0.5 * (low + high)) / 2);
      bound = std::max(bound, 2 * s * s * radius[i] * std::cos(chart.angle));
    }
  return high - low > std::numbers::pi ? largest : bound;
}

double segment_distance(const Vec3& p, const Vec3& q) {
  const Vec3 d = q - p;
  const double square = dot(d, d);
  const double t = square > 0 ? std::clamp(-dot(p, d) / square, 0.0, 1.0) : 0;
  return norm(p + t * d);
}

// From the origin.
double triangle_distance(const std::array<Vec3, 3>& p) {
  const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
  bool inside = dot(n, n) > 0;
  for (std::size_t i = 0; i < 3 && inside; ++i) inside = dot(n, cross(p[i], p[(i + 1) % 3])) >= 0;
  if (inside) return std::abs(dot(n, p[0])) / norm(n);
  return std::min(
      {segment_distance(p[0], p[1]), segment_distance(p[1], p[2]), segment_distance(p[2], p[0])});
}

double sphere_distance(const ElementaryChart& chart, const std::array<Vec2, 3>& corners) {
  std::array<Vec3, 3> unit_points;
  for (std::size_t i = 0; i < 3; ++i) unit_points[i] = outwards(chart, corners[i]);
  return chart.radius * std::max(0.0, 1 - triangle_distance(unit_points));
}

// The third derivatives of a torus bound how far the second ones are from those in the middle.
JetEnclosure torus_jet(const ElementaryChart& chart, const std::array<Vec2, 3>& corners) {
  Vec2 low = corners[0], high = low;
  for (const Vec2& corner : corners)
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], corner[k]);
      high[k] = std::max(high[k], corner[k]);
    }
  const Vec2 middle = 0.5 * (low + high), half = 0.5 * (high - low);
  const double R = chart.radius, r = chart.minor;
  const double cv = std::cos(middle[1]), sv = std::sin(middle[1]);
  const Vec3 e = radial(chart, middle[0]), turned = radial(chart, middle[0] + std::numbers::pi / 2);
  const auto ball = [](const Vec3& centre, double radius) {
    return VectorRange{centre, {radius, radius, radius}};
  };
  JetEnclosure jet;
  const double outer = R + r;
  jet.uu = ball(-(R + r * cv) * e, outer * half[0] + r * half[1]);
  jet.uv = ball(-r * sv * turned, r * (half[0] + half[1]));
  jet.vv = ball(-r * (cv * e + sv * chart.z), r * (half[0] + half[1]));
  jet.length_u = outer;
  jet.length_v = r;
  jet.jacobian = std::max(0.0, r * (R + r * (cv - half[1])));
  return jet;
}

// In the half-plane of a point of the facet the circle of corners with the same weights is left by
// no more than the height of its arc, inwards. The point itself is nearer to the axis: by d, which
// takes it by d cos v towards the middle of the tube or away from it; the distance from there is
// convex.
std::optional<double> torus_distance(const ElementaryChart& chart,
                                     const std::array<Vec2, 3>& corners) {
  const auto [u0, u1] = std::minmax({corners[0][0], corners[1][0], corners[2][0]});
  const auto [v0, v1] = std::minmax({corners[0][1], corners[1][1], corners[2][1]});
  const double R = chart.radius, r = chart.minor, half_v = 0.5 * (v1 - v0);
  if (!(R > r) || !(half_v < kWideArc) || !(u1 - u0 < 2 * kWideArc)) return {};
  // Of the cosine over the range of v: at its ends, or 1 and -1 inside.
  const double turn = 2 * std::numbers::pi;
  const auto holds = [&](double v) { return std::ceil((v0 - v) / turn) * turn + v <= v1; };
  const auto [low, high] = std::minmax({std::cos(v0), std::cos(v1)});
  const double most = holds(0) ? 1 : high, least = holds(std::numbers::pi) ? -1 : low;
  const double d = (R + r * most) * (1 - std::cos(0.5 * (u1 - u0)));
  const double inside = r * (1 - std::cos(half_v)) + d * std::max(most, 0.0);
  const double outside = d * std::max(-least, 0.0) + d * d / (2 * r * std::cos(half_v));
  return std::max(inside, outside);
}

}  // namespace

PointNormal frame_at(const ElementaryChart& chart, const Vec2& uv) {
  return {point_on(chart, uv), chart.kind == ElementaryKind::Plane
                                   ? outwards(chart, uv)
                                   : hand(chart) * outwards(chart, uv)};
}

CurvatureSample curvature_at(const ElementaryChart& chart, const Vec2& uv) {
  const double v = uv[1], R = chart.radius;
  switch (chart.kind) {
    case ElementaryKind::Plane: return {0, 0, 0, 1, 1};
    case ElementaryKind::Cylinder: return {R, 0, 0, R, 1};
    case ElementaryKind::Cone: {
      const double radius = std::abs(cone_radius(chart, v));
      return {radius * std::cos(chart.angle), 0, 0, radius, 1};
    }
    case ElementaryKind::Sphere: {
      const double c = std::abs(std::cos(v));
      return {R * c * c, 0, R, R * c, R};
    }
    case ElementaryKind::Torus: {
      const double across = R + chart.minor * std::cos(v);
      return {std::abs(across * std::cos(v)), 0, chart.minor, std::abs(across), chart.minor};
    }
  }
  return {};
}

double facet_distance(const ElementaryChart& chart, const std::array<Vec2, 3>& corners) {
  switch (chart.kind) {
    case ElementaryKind::Plane: return 0;
    case ElementaryKind::Cylinder: {
      const auto [low, high] = std::minmax({corners[0][0], corners[1][0], corners[2][0]});
      if (high - low > std::numbers::pi) return chart.radius;
      const double s = std::sin((high - low) / 4);
      return 2 * s * s * chart.radius;
    }
    case ElementaryKind::Cone: return cone_distance(chart, corners);
    case ElementaryKind::Sphere: return sphere_distance(chart, corners);
    case ElementaryKind::Torus: {
      const double by_jet = facet_distance(torus_jet(chart, corners),
                                           hand(chart) * outwards(chart, corners[0]), corners);
      return std::min(by_jet, torus_distance(chart, corners).value_or(by_jet));
    }
  }
  return 0;
}

}  // namespace blossom
