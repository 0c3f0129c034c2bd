// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves of tests: Bezier curves, arcs, polygons, and changes that leave their points in place.

#pragma once

#include <cmath>
#include <vector>

#include "core/forms/algebra/degree.h"
#include "core/forms/curve_spans.h"
#include "core/subdivision/curve_subdivision.h"

namespace blossom::testing {

inline CurveSpans bezier(const std::vector<Vec3>& points) {
  return curve_spans(BezierCurve{points});
}

/// Lines from corner to corner; corner i has parameter i.
inline CurveSpans polygon(const std::vector<Vec3>& corners) {
  CurveSpans curve;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    CurveSpan span = bezier({corners[i], corners[i + 1]}).spans[0];
    span.place = {static_cast<double>(i), static_cast<double>(i + 1)};
    curve.spans.push_back(span);
  }
  return curve;
}

/// A circular arc in the plane, by angle, in four equal spans.
inline CurveSpans arc(const Vec2& centre, double radius, const Interval& angles) {
  CurveSpans curve;
  curve.rational = true;
  const double whole = 8 * std::atan(1.0);
  const auto direction = [&](int i) {
    const double angle = at(angles, 0.25 * i);
    return i == 4 && length(angles) >= whole ? Vec2{std::cos(angles.from), std::sin(angles.from)}
                                             : Vec2{std::cos(angle), std::sin(angle)};
  };
  for (int i = 0; i < 4; ++i) {
    const Vec2 from = direction(i), to = direction(i + 1);
    const double weight = std::cos(0.125 * length(angles));
    const Vec2 middle = (from + to) * (0.5 / weight);
    const auto point = [&](const Vec2& p, double w) {
      return Vec4{w * (centre[0] + radius * p[0]), w * (centre[1] + radius * p[1]), 0, w};
    };
    curve.spans.push_back({{{point(from, 1), point(middle * (1 / weight), weight), point(to, 1)}},
                           {at(angles, 0.25 * i), at(angles, 0.25 * (i + 1))},
                           ParameterLaw::Angle});
  }
  return curve;
}

inline CurveSpans circle(const Vec2& centre, double radius) {
  return arc(centre, radius, {0, 8 * std::atan(1.0)});
}

/// The plane z = 0 laid askew into space.
inline Vec3 in_space(const Vec3& p) {
  const Vec3 e1 = unit(Vec3{1, 2, 3}), e2 = unit(cross(e1, Vec3{1, 0, 0})), e3 = cross(e1, e2);
  return e1 * p[0] + e2 * p[1] + e3 * p[2] + Vec3{0.1, 0.4, 0.7};
}

inline CurveSpans in_space(CurveSpans curve) {
  for (CurveSpan& span : curve.spans)
    for (Vec4& p : span.curve.points) {
      const Vec3 q = in_space(Vec3{p[0] / p[3], p[1] / p[3], p[2] / p[3]});
      p = {q[0] * p[3], q[1] * p[3], q[2] * p[3], p[3]};
    }
  return curve;
}

inline CurveSpans piece(const RationalBezierCurve& curve, const Interval& part) {
  return curve_spans(sub_curve(curve, part));
}

/// The piece in a linear rational parameter, and with a higher degree.
inline CurveSpans reparametrised(const RationalBezierCurve& curve, const Interval& part,
                                 double ratio, int degree) {
  RationalBezierCurve result = sub_curve(curve, part);
  double factor = 1;
  for (Vec4& p : result.points) {
    p *= factor;
    factor *= ratio;
  }
  return curve_spans(elevated(result, degree));
}

}  // namespace blossom::testing
