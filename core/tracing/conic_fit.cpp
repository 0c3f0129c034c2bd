// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/conic_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace blossom {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kFirstLook = 7;  // points of a chain; most curves are no conic, and done then
constexpr std::size_t kSecondLook = 24;
constexpr double kLoosely = 100;    // times the slack: points that are known may be that far off
constexpr double kParabola = 1e-6;  // ratio of the quadratic form's eigenvalues, to try one
constexpr double kAtStart = 1e-12;  // radians: an ellipse so near before its vertex begins there

std::size_t farthest(std::span<const Vec3> points, auto&& distance_of) {
  const auto best = std::max_element(
      points.begin(), points.end(),
      [&](const Vec3& p, const Vec3& q) { return distance_of(p) < distance_of(q); });
  return static_cast<std::size_t>(best - points.begin());
}

bool holds(const Conic& conic, std::span<const Vec3> points, double slack) {
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return distance(p, point_at(conic, parameter_at(conic, p))) <= slack;
  });
}

// Its parameter growing along the points. Closed ones: from the first point to the next one.
Conic directed(Conic conic, std::span<const Vec3> points) {
  const auto parameter = [&](const Vec3& p) { return parameter_at(conic, p); };
  const double step = parameter(points[1]) - parameter(points[0]);
  if ((conic.is_closed() ? std::remainder(step, 2 * kPi) : step) < 0)
    (conic.kind == ConicKind::Line ? conic.x : conic.y) *= -1;
  return conic;
}

// Coordinates in the plane of the points, in units of their spread.
struct Plane {
  Vec3 origin, x, y, normal;
  double scale;

  Vec2 seen(const Vec3& p) const {
    return {dot(p - origin, x) / scale, dot(p - origin, y) / scale};
  }
  Vec3 direction(const Vec2& d) const { return d[0] * x + d[1] * y; }
  Vec3 point(const Vec2& p) const { return origin + scale * direction(p); }
};

// A x^2 + B x y + C y^2 + D x + E y + F.
using Quadratic = std::array<double, 6>;

double value(const Quadratic& q, const Vec2& p) {
  return q[0] * p[0] * p[0] + q[1] * p[0] * p[1] + q[2] * p[1] * p[1] + q[3] * p[0] + q[4] * p[1] +
         q[5];
}

// The product of the lines pq and rs.
Quadratic line_pair(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
  const auto line = [](const Vec2& from, const Vec2& to) {
    const Vec2 d = to - from;
    return std::array{-d[1], d[0], d[1] * from[0] - d[0] * from[1]};
  };
  const auto [a, b, c] = line(p, q);
  const auto [d, e, f] = line(r, s);
  return {a * d, a * e + b * d, b * e, a * f + c * d, b * f + c * e, c * f};
}

Quadratic through(const std::array<Vec2, 5>& p) {
  const Quadratic first = line_pair(p[0], p[1], p[2], p[3]);
  const Quadratic second = line_pair(p[0], p[2], p[1], p[3]);
  const double at_first = value(first, p[4]), at_second = value(second, p[4]);
  Quadratic q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = at_second * first[i] - at_first * second[i];
  return q;
}

// The form in the frame of its axes: l0 u^2 + l1 v^2 + d u + e v + f, with |l0| <= |l1|.
struct AxisForm {
  Vec2 u, v;
  double l0, l1, d, e, f;
};

AxisForm axis_form(const Quadratic& q) {
  const double angle = 0.5 * std::atan2(q[1], q[0] - q[2]);
  Vec2 u{std::cos(angle), std::sin(angle)}, v{-u[1], u[0]};
  const auto along = [&](const Vec2& w) {
    return q[0] * w[0] * w[0] + q[1] * w[0] * w[1] + q[2] * w[1] * w[1];
  };
  if (std::abs(along(u)) > std::abs(along(v))) std::swap(u, v);
  return {u, v, along(u), along(v), q[3] * u[0] + q[4] * u[1], q[3] * v[0] + q[4] * v[1], q[5]};
}

std::optional<Conic> parabola_of(const AxisForm& form, const Plane& plane) {
  if (!(std::abs(form.l0) <= kParabola * std::abs(form.l1)) || form.d == 0) return {};
  const double v = -form.e / (2 * form.l1), u = -(form.f + form.l1 * v * v + form.e * v) / form.d;
  const double sign = -form.d / form.l1 > 0 ? 1 : -1;
  return Conic{ConicKind::Parabola,
               plane.point(u * form.u + v * form.v),
               sign * plane.direction(form.u),
               plane.direction(form.v),
               plane.scale * std::abs(form.d / (4 * form.l1)),
               0};
}

// An ellipse, or the branch of a hyperbola on which a point lies.
std::optional<Conic> central_of(const AxisForm& form, const Plane& plane, const Vec2& point) {
  if (form.l0 == 0) return {};
  const Vec2 centre{-form.d / (2 * form.l0), -form.e / (2 * form.l1)};
  const double rest = form.l0 * centre[0] * centre[0] + form.l1 * centre[1] * centre[1] - form.f;
  const Vec2 squares{rest / form.l0, rest / form.l1};
  Conic conic{ConicKind::Ellipse,
              plane.point(centre[0] * form.u + centre[1] * form.v),
              plane.direction(form.u),
              plane.direction(form.v),
              plane.scale * std::sqrt(std::abs(squares[0])),
              plane.scale * std::sqrt(std::abs(squares[1]))};
  if (squares[0] > 0 && squares[1] > 0) return conic;
  if (squares[0] < 0 && squares[1] < 0) return {};
  conic.kind = ConicKind::Hyperbola;
  if (squares[0] < 0) {
    std::swap(conic.x, conic.y);
    std::swap(conic.major, conic.minor);
  }
  if (dot(plane.point(point) - conic.centre, conic.x) < 0) conic.x *= -1;
  return conic;
}

std::optional<Conic> circle_of(const std::array<Vec2, 5>& p, const Plane& plane) {
  const Vec2 a = p[2] - p[0], b = p[4] - p[0];
  const double twice = 2 * (a[0] * b[1] - a[1] * b[0]);
  if (twice == 0) return {};
  const double aa = dot(a, a), bb = dot(b, b);
  const Vec2 arm{(b[1] * aa - a[1] * bb) / twice, (a[0] * bb - b[0] * aa) / twice};
  const double radius = plane.scale * norm(arm);
  const Vec3 centre = plane.point(p[0] + arm), x = unit(plane.point(p[0]) - centre);
  return Conic{ConicKind::Circle, centre, x, cross(plane.normal, x), radius, radius};
}

// Five of the points, evenly spread.
std::array<Vec2, 5> five_of(std::span<const Vec3> points, const Plane& plane) {
  std::array<Vec2, 5> five;
  for (std::size_t i = 0; i < 5; ++i) five[i] = plane.seen(points[i * (points.size() - 1) / 4]);
  return five;
}

// Begins where the curve does.
Conic begun(Conic conic, const Vec3& start) {
  if (!conic.is_closed()) {
    if (conic.kind == ConicKind::Line) conic.centre = point_at(conic, parameter_at(conic, start));
    return conic;
  }
  const double t = parameter_at(conic, start);
  if (conic.kind == ConicKind::Circle) {
    const Vec3 x = std::cos(t) * conic.x + std::sin(t) * conic.y;
    conic.y = std::cos(t) * conic.y - std::sin(t) * conic.x;
    conic.x = x;
  } else if (t < -kAtStart || t > kPi - kAtStart) {
    conic.x *= -1;
    conic.y *= -1;
  }
  return conic;
}

std::vector<Vec3> points_along(const ChainTracer& tracer, std::size_t count) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    points.push_back(tracer.at(part * tracer.stations().back(), true).point);
  }
  return points;
}

}  // namespace

std::optional<Conic> conic_through(std::span<const Vec3> points, double slack) {
  if (points.size() < 6) return {};
  const Vec3 start = points.front();
  const Vec3 end = points[farthest(points, [&](const Vec3& p) { return distance(p, start); })];
  const double scale = distance(start, end);
  if (!(scale > slack)) return {};
  const Vec3 x = (end - start) * (1 / scale);
  const auto across = [&](const Vec3& p) { return (p - start) - dot(p - start, x) * x; };
  const Vec3 side =
      across(points[farthest(points, [&](const Vec3& p) { return norm(across(p)); })]);
  const Conic line{ConicKind::Line, start, x, {}, 0, 0};
  if (norm(side) <= slack) return directed(line, points);
  const Vec3 y = unit(side);
  const Plane plane{start, x, y, cross(x, y), scale};
  if (std::any_of(points.begin(), points.end(),
                  [&](const Vec3& p) { return std::abs(dot(p - start, plane.normal)) > slack; }))
    return {};
  const std::array<Vec2, 5> five = five_of(points, plane);
  const AxisForm form = axis_form(through(five));
  for (const auto& conic :
       {circle_of(five, plane), parabola_of(form, plane), central_of(form, plane, five[0])})
    if (conic && holds(*conic, points, slack)) return directed(*conic, points);
  return {};
}

std::optional<Conic> conic_along(const ChainTracer& tracer, double slack) {
  const std::vector<Vec3>& known = tracer.known_points();
  if (known.size() >= kFirstLook ? !conic_through(known, kLoosely * slack)
                                 : !conic_through(points_along(tracer, kFirstLook), slack))
    return {};
  const auto conic = conic_through(points_along(tracer, kSecondLook), slack);
  if (!conic) return {};
  return begun(*conic, tracer.at(0, true).point);
}

}  // namespace blossom
