// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/conic.h"

#include <algorithm>
#include <cmath>

#include "core/math/functions/quadrature.h"

namespace blossom {

const char* to_string(ConicKind kind) {
  switch (kind) {
    case ConicKind::Line: return "line";
    case ConicKind::Circle: return "circle";
    case ConicKind::Ellipse: return "ellipse";
    case ConicKind::Parabola: return "parabola";
    case ConicKind::Hyperbola: return "hyperbola";
  }
  return "";
}

Vec3 point_at(const Conic& c, double t) {
  switch (c.kind) {
    case ConicKind::Line: return c.centre + t * c.x;
    case ConicKind::Parabola: return c.centre + (t * t / (4 * c.major) * c.x + t * c.y);
    case ConicKind::Hyperbola:
      return c.centre + (c.major * std::cosh(t) * c.x + c.minor * std::sinh(t) * c.y);
    default: return c.centre + (c.major * std::cos(t) * c.x + c.minor * std::sin(t) * c.y);
  }
}

Vec3 derivative_at(const Conic& c, double t) {
  switch (c.kind) {
    case ConicKind::Line: return c.x;
    case ConicKind::Parabola: return t / (2 * c.major) * c.x + c.y;
    case ConicKind::Hyperbola: return c.major * std::sinh(t) * c.x + c.minor * std::cosh(t) * c.y;
    default: return -c.major * std::sin(t) * c.x + c.minor * std::cos(t) * c.y;
  }
}

Vec3 second_derivative_at(const Conic& c, double t) {
  switch (c.kind) {
    case ConicKind::Line: return {};
    case ConicKind::Parabola: return 1 / (2 * c.major) * c.x;
    case ConicKind::Hyperbola: return point_at(c, t) - c.centre;
    default: return c.centre - point_at(c, t);
  }
}

double parameter_at(const Conic& c, const Vec3& point) {
  const Vec3 arm = point - c.centre;
  const double x = dot(arm, c.x), y = dot(arm, c.y);
  switch (c.kind) {
    case ConicKind::Line: return x;
    case ConicKind::Parabola: return y;
    case ConicKind::Hyperbola: return std::asinh(y / c.minor);
    default: return std::atan2(y / c.minor, x / c.major);
  }
}

double arc_length(const Conic& c, const Interval& range) {
  constexpr double kAccuracy = 1e-12;
  if (c.kind == ConicKind::Line) return length(range);
  if (c.kind == ConicKind::Circle) return c.major * length(range);
  return integral([&](double t) { return norm(derivative_at(c, t)); }, range.from, range.to,
                  kAccuracy * std::max(c.major, c.minor))
      .value;
}

double sixth_derivative_bound(const Conic& c, const Interval& range) {
  switch (c.kind) {
    case ConicKind::Line:
    case ConicKind::Parabola: return 0;
    case ConicKind::Hyperbola:
      return (c.major + c.minor) * std::cosh(std::max(std::abs(range.from), std::abs(range.to)));
    default: return c.major;
  }
}

}  // namespace blossom
