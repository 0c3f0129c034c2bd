// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes, quadrics, tori, surfaces of extrusion and of revolution as Bezier patches.
//
// All but planes and extrusions are a meridian turned about an axis. Over an arc with Bezier points
// (C_i, S_i, W_i) of w (cos, sin, 1), a meridian's homogeneous point at angle 0, split into its
// part along the axis (with the axis's origin) and its part across, gives the points
//
//   (W_i along + C_i across + S_i across', W_i w),   across' = axis x across

#include <array>
#include <cmath>
#include <utility>

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/curves_detail.h"
#include "adapters/occt/convert/surfaces_detail.h"

namespace blossom::occt {
namespace {

/// A homogeneous point of a meridian, ready to be turned.
struct TurnedPoint {
  Vec3 along;
  Vec3 across;       ///< at angle 0
  Vec3 across_next;  ///< at a quarter of a turn
  double weight;
};

struct TurnedSpan {
  std::vector<TurnedPoint> points;
  Interval place;
};

struct Meridian {
  std::vector<TurnedSpan> spans;
  ParameterLaw law = ParameterLaw::Linear;
  double error = 0;
};

BezierSurface turned(const Meridian& meridian, const Interval& angles, ArcCuts cuts) {
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
  for (const TurnedSpan& span : meridian.spans) result.v_knots.push_back(span.place.to);
  for (int r = 0; r < result.patches.rows(); ++r)
    for (int c = 0; c < result.patches.columns(); ++c) {
      const ArcSpan& arc = arcs[static_cast<std::size_t>(r)];
      const auto& points = meridian.spans[static_cast<std::size_t>(c)].points;
      Grid<Vec4> net(3, static_cast<int>(points.size()));
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < net.columns(); ++j) {
          const TurnedPoint& p = points[static_cast<std::size_t>(j)];
          const Vec3 point =
              arc.weight[i] * p.along + (arc.cosine[i] * p.across + arc.sine[i] * p.across_next);
          net(i, j) = with_weight(point, arc.weight[i] * p.weight);
        }
      result.patches(r, c).points = std::move(net);
    }
  return result;
}

/// The frame of an elementary surface, which may be left-handed.
struct Frame {
  Vec3 origin, x, y, z;

  explicit Frame(const gp_Ax3& axes)
      : origin(vec(axes.Location())),
        x(vec(axes.XDirection().XYZ())),
        y(vec(axes.YDirection().XYZ())),
        z(vec(axes.Direction().XYZ())) {}

  /// The point at w (radius, height) of the half plane of the meridian.
  TurnedPoint point(double radius, double height, double weight) const {
    return {weight * origin + height * z, radius * x, radius * y, weight};
  }
};

/// A straight meridian (radius, height) + v (d_radius, d_height).
Meridian straight(const Frame& frame, double radius, double d_radius, double d_height,
                  const Interval& v) {
  return {{{{frame.point(radius + v.from * d_radius, v.from * d_height, 1),
             frame.point(radius + v.to * d_radius, v.to * d_height, 1)},
            v}}};
}

/// A circle of radius `minor` about (`major`, 0).
Meridian circular(const Frame& frame, double major, double minor, const Interval& v, ArcCuts cuts) {
  Meridian meridian;
  meridian.law = ParameterLaw::Angle;
  for (const ArcSpan& arc : arc_spans(v, cuts)) {
    TurnedSpan span{{}, arc.place};
    for (int k = 0; k < 3; ++k)
      span.points.push_back(frame.point(arc.weight[k] * major + minor * arc.cosine[k],
                                        minor * arc.sine[k], arc.weight[k]));
    meridian.spans.push_back(std::move(span));
  }
  return meridian;
}

Meridian meridian_of(const Geom_SurfaceOfRevolution& surface, const Interval& v, double tolerance,
                     ArcCuts cuts) {
  const Vec3 origin = vec(surface.Location());
  const Vec3 axis = vec(surface.Direction().XYZ());
  const CurveSpans curve = bezier_spans(surface.BasisCurve(), v, tolerance, cuts);
  Meridian meridian;
  meridian.law = curve.spans.front().law;
  meridian.error = curve.error;
  for (const CurveSpan& span : curve.spans) {
    TurnedSpan turned_span{{}, span.place};
    for (const Vec4& p : span.curve.points) {
      const Vec3 arm = head(p) - p[3] * origin;
      const Vec3 along = dot(arm, axis) * axis;
      const Vec3 across = arm - along;
      turned_span.points.push_back({p[3] * origin + along, across, cross(axis, across), p[3]});
    }
    meridian.spans.push_back(std::move(turned_span));
  }
  return meridian;
}

/// A curve moved along a direction; degree 1 in v.
BezierSurface extruded(const CurveSpans& curve, const Vec3& direction, const Interval& v) {
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

BezierSurface flat(const Geom_Plane& plane, const ParameterBox& box) {
  const std::array u{box.u.from, box.u.to}, v{box.v.from, box.v.to};
  BezierSurface result;
  result.u_knots.assign(u.begin(), u.end());
  result.v_knots.assign(v.begin(), v.end());
  Grid<Vec4> net(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      net(i, j) = with_weight(
          vec(plane.Value(u[static_cast<std::size_t>(i)], v[static_cast<std::size_t>(j)])), 1);
  result.patches = Grid<RationalBezierPatch>(1, 1, {std::move(net)});
  return result;
}

/// An offset surface that is an elementary surface with the same parameters, or nothing.
Handle(Geom_Surface) elementary_offset(const Geom_OffsetSurface& offset, const ParameterBox& box) {
  const auto found = Handle(Geom_ElementarySurface)::DownCast(offset.Surface());
  if (found.IsNull()) return nullptr;
  // Open CASCADE does not promise that the parameters agree: compare before believing.
  for (const double s : {0.1, 0.45, 0.8})
    for (const double t : {0.15, 0.5, 0.9}) {
      const double u = at(box.u, s), v = at(box.v, t);
      const gp_Pnt wanted = offset.Value(u, v);
      constexpr double kOffsetRounding = 1e-13;  // some hundred roundings of a coordinate
      const double rounding = kOffsetRounding * (1 + wanted.XYZ().Modulus());
      if (found->Value(u, v).Distance(wanted) > rounding) return nullptr;
    }
  return Handle(Geom_Surface)(found);
}

}  // namespace

BezierSurface swept_patches(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                            double tolerance, ArcCuts cuts) {
  if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull())
    return flat(*plane, box);
  if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
    return turned(straight(Frame(cylinder->Position()), cylinder->Radius(), 0, 1, box.v), box.u,
                  cuts);
  if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) {
    const double angle = cone->SemiAngle();
    return turned(straight(Frame(cone->Position()), cone->RefRadius(), std::sin(angle),
                           std::cos(angle), box.v),
                  box.u, cuts);
  }
  if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull())
    return turned(circular(Frame(sphere->Position()), 0, sphere->Radius(), box.v, cuts), box.u,
                  cuts);
  if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface); !torus.IsNull())
    return turned(
        circular(Frame(torus->Position()), torus->MajorRadius(), torus->MinorRadius(), box.v, cuts),
        box.u, cuts);
  if (const auto moved = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface); !moved.IsNull())
    return extruded(bezier_spans(moved->BasisCurve(), box.u, tolerance, cuts),
                    vec(moved->Direction().XYZ()), box.v);
  if (const auto revolved = Handle(Geom_SurfaceOfRevolution)::DownCast(surface); !revolved.IsNull())
    return turned(meridian_of(*revolved, box.v, tolerance, cuts), box.u, cuts);
  if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface); !offset.IsNull())
    if (const auto simple = elementary_offset(*offset, box); !simple.IsNull())
      return swept_patches(simple, box, tolerance, cuts);
  return {};
}

}  // namespace blossom::occt
