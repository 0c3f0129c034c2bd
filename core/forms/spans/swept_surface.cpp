// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/spans/swept_surface.h"

#include <cstddef>
#include <utility>

#include "core/forms/spans/homogeneous.h"

namespace blossom {
namespace {

/// The point at w (radius, height) of the half plane of the meridian.
MeridianPoint point_of(const MeridianFrame& frame, double radius, double height, double weight) {
  return {weight * frame.origin + height * frame.z, radius * frame.x, radius * frame.y, weight};
}

}  // namespace

Meridian straight_meridian(const MeridianFrame& frame, double radius, double d_radius,
                           double d_height, const Interval& v) {
  return {{{{point_of(frame, radius + v.from * d_radius, v.from * d_height, 1),
             point_of(frame, radius + v.to * d_radius, v.to * d_height, 1)},
            v}}};
}

Meridian circular_meridian(const MeridianFrame& frame, double major, double minor,
                           const Interval& v, ArcCuts cuts) {
  Meridian meridian;
  meridian.law = ParameterLaw::Angle;
  for (const ArcSpan& arc : arc_spans(v, cuts)) {
    MeridianSpan span{{}, arc.place};
    for (int k = 0; k < 3; ++k)
      span.points.push_back(point_of(frame, arc.weight[k] * major + minor * arc.cosine[k],
                                     minor * arc.sine[k], arc.weight[k]));
    meridian.spans.push_back(std::move(span));
  }
  return meridian;
}

Meridian curved_meridian(const CurveSpans& curve, const Vec3& origin, const Vec3& axis) {
  Meridian meridian;
  meridian.law = curve.spans.front().law;
  meridian.error = curve.error;
  for (const CurveSpan& span : curve.spans) {
    MeridianSpan turned{{}, span.place};
    for (const Vec4& p : span.curve.points) {
      const Vec3 arm = head(p) - p[3] * origin;
      const Vec3 along = dot(arm, axis) * axis;
      const Vec3 across = arm - along;
      turned.points.push_back({p[3] * origin + along, across, cross(axis, across), p[3]});
    }
    meridian.spans.push_back(std::move(turned));
  }
  return meridian;
}

BezierSurface turned_surface(const Meridian& meridian, const Interval& angles, ArcCuts cuts) {
  const std::vector<ArcSpan> arcs = arc_spans(angles, cuts);
  BezierSurface result;
  result.u_law = ParameterLaw::Angle;
  result.v_law = meridian.law;
  result.error = meridian.error;
  result.patches = Grid<RationalBezierPatch>(static_cast<int>(arcs.size()),
                                             static_cast<int>(meridian.spans.size()));
  result.u_knots.push_back(angles.from);
  for (const ArcSpan& arc : arcs) result.u_knots.push_back(arc.place.to);
  result.v_knots.push_back(meridian.spans.front().place.from);
  for (const MeridianSpan& span : meridian.spans) result.v_knots.push_back(span.place.to);
  for (int r = 0; r < result.patches.rows(); ++r)
    for (int c = 0; c < result.patches.columns(); ++c) {
      const ArcSpan& arc = arcs[static_cast<std::size_t>(r)];
      const auto& points = meridian.spans[static_cast<std::size_t>(c)].points;
      Grid<Vec4> net(3, static_cast<int>(points.size()));
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < net.columns(); ++j) {
          const MeridianPoint& p = points[static_cast<std::size_t>(j)];
          const Vec3 point =
              arc.weight[i] * p.along + (arc.cosine[i] * p.across + arc.sine[i] * p.across_next);
          net(i, j) = with_weight(point, arc.weight[i] * p.weight);
        }
      result.patches(r, c).points = std::move(net);
    }
  return result;
}

BezierSurface extruded_surface(const CurveSpans& curve, const Vec3& direction, const Interval& v) {
  BezierSurface result;
  result.u_law = curve.spans.front().law;
  result.error = curve.error;
  result.v_knots = {v.from, v.to};
  result.u_knots.push_back(curve.spans.front().place.from);
  result.patches = Grid<RationalBezierPatch>(static_cast<int>(curve.spans.size()), 1);
  for (int r = 0; r < result.patches.rows(); ++r) {
    const CurveSpan& span = curve.spans[static_cast<std::size_t>(r)];
    result.u_knots.push_back(span.place.to);
    Grid<Vec4> net(span.curve.degree() + 1, 2);
    for (int i = 0; i < net.rows(); ++i) {
      const Vec4& p = span.curve.points[static_cast<std::size_t>(i)];
      net(i, 0) = with_weight(head(p) + (p[3] * v.from) * direction, p[3]);
      net(i, 1) = with_weight(head(p) + (p[3] * v.to) * direction, p[3]);
    }
    result.patches(r, 0).points = std::move(net);
  }
  return result;
}

}  // namespace blossom
