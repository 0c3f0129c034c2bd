// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/elementary_faces.h"

#include <algorithm>
#include <cmath>

#include <ElSLib.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomAdaptor_SurfaceOfLinearExtrusion.hxx>
#include <GeomAdaptor_SurfaceOfRevolution.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Precision.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/base/unbounded.h"

namespace blossom::occt {
namespace {

constexpr double kRounding = 0x1p-48;  // of the coordinates
// Sine of the angle between planes whose line has no direction: normals are known to 1e-16.
constexpr double kParallel = 1e-13;

std::optional<Elementary> elementary_of(const Adaptor3d_Surface& surface) {
  Elementary of;
  const auto place = [&](const gp_Ax1& axis) {
    of.centre = vec(axis.Location().XYZ());
    of.axis = vec(axis.Direction().XYZ());
  };
  switch (surface.GetType()) {
    case GeomAbs_Plane: place(surface.Plane().Axis()); return of;
    case GeomAbs_Cylinder:
      of.kind = ElementaryKind::Cylinder;
      place(surface.Cylinder().Axis());
      of.radius = surface.Cylinder().Radius();
      return of;
    case GeomAbs_Cone:
      of.kind = ElementaryKind::Cone;
      place(surface.Cone().Axis());
      of.centre = vec(surface.Cone().Apex().XYZ());
      of.angle = std::abs(surface.Cone().SemiAngle());
      return of;
    case GeomAbs_Sphere:
      of.kind = ElementaryKind::Sphere;
      of.centre = vec(surface.Sphere().Location().XYZ());
      of.radius = surface.Sphere().Radius();
      return of;
    case GeomAbs_Torus:
      of.kind = ElementaryKind::Torus;
      place(surface.Torus().Axis());
      of.radius = surface.Torus().MajorRadius();
      of.minor = surface.Torus().MinorRadius();
      return of;
    default: return {};
  }
}

// The torus of a circle in a plane through the axis, which Open CASCADE does not always know.
std::optional<Elementary> turned_circle(const Geom_SurfaceOfRevolution& turned) {
  const GeomAdaptor_Curve basis(turned.BasisCurve());
  if (basis.GetType() != GeomAbs_Circle) return {};
  const gp_Circ circle = basis.Circle();
  if (!circle.Position().IsCoplanar(turned.Axis(), Precision::Confusion(), Precision::Angular()))
    return {};
  Elementary torus;
  torus.kind = ElementaryKind::Torus;
  torus.axis = vec(turned.Direction().XYZ());
  const Vec3 foot = vec(turned.Location().XYZ()), middle = vec(circle.Location().XYZ());
  torus.centre = foot + dot(middle - foot, torus.axis) * torus.axis;
  torus.radius = distance(middle, torus.centre);
  torus.minor = circle.Radius();
  if (torus.radius <= torus.minor) return {};
  return torus;
}

// Where a line is inside of a box; empty, from > to, if it misses it.
Interval inside(const Box& box, const Vec3& start, const Vec3& direction) {
  Interval range{-kUnbounded, kUnbounded};
  for (int k = 0; k < 3; ++k) {
    if (direction[k] == 0) {
      if (start[k] < box.low[k] || start[k] > box.high[k]) return {1, 0};
      continue;
    }
    const double s = (box.low[k] - start[k]) / direction[k];
    const double t = (box.high[k] - start[k]) / direction[k];
    range.from = std::max(range.from, std::min(s, t));
    range.to = std::min(range.to, std::max(s, t));
  }
  return range;
}

IntersectionCurve line_curve(const gp_Pln& a, const gp_Pln& b, const Vec3& start,
                             const Vec3& direction, const Interval& range, double error) {
  IntersectionCurve curve;
  curve.curve.degree = curve.chart_a.degree = curve.chart_b.degree = 1;
  const auto uv = [](const gp_Pln& plane, const Vec3& p) {
    Vec2 at;
    ElSLib::Parameters(plane, gp_Pnt(p[0], p[1], p[2]), at[0], at[1]);
    return at;
  };
  for (const double t : {range.from, range.to}) {
    const Vec3 point = start + t * direction;
    curve.samples.push_back({point, uv(a, point), uv(b, point)});
    curve.sample_parameters.push_back(t);
    curve.curve.points.push_back(point);
    curve.chart_a.points.push_back(curve.samples.back().uv_a);
    curve.chart_b.points.push_back(curve.samples.back().uv_b);
  }
  curve.curve.knots = curve.chart_a.knots = curve.chart_b.knots = {range.from, range.to};
  curve.curve.multiplicities = curve.chart_a.multiplicities = curve.chart_b.multiplicities = {2, 2};
  curve.conic = Conic{ConicKind::Line, start, direction, {}, 0, 0};
  curve.ends = {CurveEnd::Trim, CurveEnd::Trim};
  curve.length = length(range);
  curve.deviation = {error, error, 2 * error, true, error};
  return curve;
}

}  // namespace

std::optional<Elementary> elementary_of(const Handle(Geom_Surface) & surface) {
  const Handle(Geom_Surface) basis = basis_of(surface);
  if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(basis)) {
    GeomAdaptor_SurfaceOfRevolution adaptor(new GeomAdaptor_Curve(turned->BasisCurve()),
                                            turned->Axis());
    const auto known = elementary_of(static_cast<const Adaptor3d_Surface&>(adaptor));
    return known ? known : turned_circle(*turned);
  }
  if (const auto drawn = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(basis)) {
    GeomAdaptor_SurfaceOfLinearExtrusion adaptor(new GeomAdaptor_Curve(drawn->BasisCurve()),
                                                 drawn->Direction());
    return elementary_of(static_cast<const Adaptor3d_Surface&>(adaptor));
  }
  return elementary_of(static_cast<const Adaptor3d_Surface&>(GeomAdaptor_Surface(basis)));
}

std::optional<SurfaceIntersection> crossing_of_planes(const Handle(Geom_Surface) & a,
                                                      const Handle(Geom_Surface) & b,
                                                      const Box& box, double beyond,
                                                      double tolerance) {
  const auto plane_a = Handle(Geom_Plane)::DownCast(basis_of(a));
  const auto plane_b = Handle(Geom_Plane)::DownCast(basis_of(b));
  if (plane_a.IsNull() || plane_b.IsNull()) return {};
  const Vec3 na = vec(plane_a->Axis().Direction().XYZ()),
             nb = vec(plane_b->Axis().Direction().XYZ());
  const Vec3 along = cross(na, nb);
  const double sine = norm(along);
  const Vec3 middle = 0.5 * (box.low + box.high);
  const double off_a = dot(vec(plane_a->Location().XYZ()) - middle, na);
  const double off_b = dot(vec(plane_b->Location().XYZ()) - middle, nb);
  const double opposite = dot(na, nb) < 0 ? -1 : 1;
  if (sine < kParallel) return {};
  if (std::abs(off_a - opposite * off_b) + 0.5 * diagonal(box) * sine <= tolerance) return {};
  // The point of the line next to the middle of the box, which keeps the digits. At a small angle
  // rounding moves it along the planes, but not off them: it is put into one of them, and moved in
  // it to the other one.
  const Vec3 direction = unit(along - dot(along, na) * na), across = cross(direction, na);
  const Vec3 in_a = middle + off_a * na;
  const double rise = dot(vec(plane_b->Location().XYZ()) - in_a, nb);
  const Vec3 start = in_a + (rise / dot(across, nb)) * across;
  const Interval range = inside(widened(box, tolerance), start, direction);
  const double angle = std::atan2(sine, std::abs(dot(na, nb)));
  if (!(range.from <= range.to) && angle < kSlowAngle) return {};
  SurfaceIntersection found;
  found.certificate.certified = range.from <= range.to ? 1 : 0;
  found.certificate.excluded = 1 - found.certificate.certified;
  if (!(range.from <= range.to)) return found;
  const double coordinate = std::max(max_norm(box.low), max_norm(box.high));
  found.curves.push_back(line_curve(plane_a->Pln(), plane_b->Pln(), start, direction,
                                    {range.from - beyond, range.to + beyond},
                                    kRounding * coordinate));
  found.curves.back().least_angle = found.certificate.least_angle = angle;
  return found;
}

}  // namespace blossom::occt
