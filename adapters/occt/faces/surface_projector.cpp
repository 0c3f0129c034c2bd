// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/surface_projector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/math/interval.h"

namespace blossom::occt {
namespace {

constexpr int kPlaces = 24;  // in each direction: 15 degrees of a circle, from where Newton's
                             // method comes to a point of an elementary surface

// The point that a border of a surface is; none if it has a length, lies at infinity, or has no
// points at all, as some offsets.
std::optional<Vec3> one_point(const std::function<gp_Pnt(double)>& border, const Interval& along,
                              double value) {
  for (const double end : {along.from, along.to, value})
    if (Precision::IsInfinite(end)) return std::nullopt;
  try {
    const gp_Pnt first = border(along.from);
    for (const double part : {0.2, 0.4, 0.6, 0.8})
      if (first.Distance(border(at(along, part))) > Precision::Confusion()) return std::nullopt;
    return vec(first);
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

bool is_endless(const Interval& range) {
  return Precision::IsInfinite(range.from) || Precision::IsInfinite(range.to);
}

// Whether the borders at both ends of a range are one: also of an arc that closes but for rounding,
// which Open CASCADE does not count as closed.
bool meet(const std::function<gp_Pnt(double)>& first, const std::function<gp_Pnt(double)>& last,
          const Interval& range, const Interval& along) {
  if (is_endless(range) || is_endless(along)) return false;
  try {
    for (const double part : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0})
      if (first(at(along, part)).Distance(last(at(along, part))) > Precision::Confusion())
        return false;
    return true;
  } catch (const Standard_Failure&) {
    return false;
  }
}

// Not the rectangle of it: wires bound the face, and what goes round keeps its period.
Handle(Geom_Surface) whole_surface(const TopoDS_Face& face) {
  return basis_of(BRep_Tool::Surface(face));
}

// The parameters of the nearest point by a formula; null if there is none for the surface.
std::function<Vec2(const Vec3&)> formula_of(const Handle(Geom_Surface) & surface) {
  if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull())
    return [plane](const Vec3& point) {
      Vec2 uv;
      ElSLib::Parameters(plane->Pln(), pnt(point), uv[0], uv[1]);
      return uv;
    };
  if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
    return [cylinder](const Vec3& point) {
      Vec2 uv;
      ElSLib::Parameters(cylinder->Cylinder(), pnt(point), uv[0], uv[1]);
      return uv;
    };
  return {};
}

// The same by Open CASCADE's search, within tolerance.
std::function<Vec2(const Vec3&)> search_of(const Handle(Geom_Surface) & surface, double tolerance) {
  const Handle(ShapeAnalysis_Surface) finder = new ShapeAnalysis_Surface(surface);
  return [finder, tolerance](const Vec3& point) {
    const gp_Pnt2d found = finder->ValueOfUV(pnt(point), tolerance);
    return Vec2{found.X(), found.Y()};
  };
}

bool is_spline(const Handle(Geom_Surface) & surface) {
  return surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface)) ||
         surface->IsKind(STANDARD_TYPE(Geom_BezierSurface));
}

// The parameters of the nearest one of points all over a surface.
std::function<Vec2(const Vec3&)> nearest_of_points(const Handle(Geom_Surface) & surface,
                                                   const Vec2& low, const Vec2& high) {
  std::vector<std::pair<Vec3, Vec2>> points;
  for (int i = 0; i < kPlaces; ++i)
    for (int j = 0; j < kPlaces; ++j) {
      const Vec2 uv{at({low[0], high[0]}, (i + 0.5) / kPlaces),
                    at({low[1], high[1]}, (j + 0.5) / kPlaces)};
      points.emplace_back(vec(surface->Value(uv[0], uv[1])), uv);
    }
  return [points = std::move(points)](const Vec3& point) {
    return std::ranges::min_element(points, {},
                                    [&](const auto& place) { return distance(place.first, point); })
        ->second;
  };
}

bool is_pole(const std::vector<SurfacePole>& poles, int fixed, double value) {
  return std::ranges::any_of(
      poles, [&](const SurfacePole& pole) { return pole.fixed == fixed && pole.value == value; });
}

ProjectedSurface projected(const Handle(Geom_Surface) & surface, double tolerance) {
  ProjectedSurface made;
  made.jet = [surface](const Vec2& uv) { return frame_at(surface, uv); };
  made.search = formula_of(surface);
  made.exact = made.search != nullptr;
  if (!made.exact) made.search = search_of(surface, tolerance);
  if (surface->IsUPeriodic()) made.period[0] = surface->UPeriod();
  if (surface->IsVPeriodic()) made.period[1] = surface->VPeriod();
  surface->Bounds(made.low[0], made.high[0], made.low[1], made.high[1]);
  const Interval u{made.low[0], made.high[0]}, v{made.low[1], made.high[1]};
  const auto at_v = [&](double fixed) {
    return [&surface, fixed](double t) { return surface->Value(t, fixed); };
  };
  const auto at_u = [&](double fixed) {
    return [&surface, fixed](double t) { return surface->Value(fixed, t); };
  };
  if (made.period[0] == 0 && meet(at_u(u.from), at_u(u.to), u, v)) made.closed[0] = length(u);
  if (made.period[1] == 0 && meet(at_v(v.from), at_v(v.to), v, u)) made.closed[1] = length(v);
  made.poles = poles_of(surface);
  return made;
}

}  // namespace

SurfaceJet frame_at(const Handle(Geom_Surface) & surface, const Vec2& uv) {
  gp_Pnt p;
  gp_Vec du, dv;
  surface->D1(uv[0], uv[1], p, du, dv);
  return {vec(p), vec(du), vec(dv)};
}

SurfaceBend bend_at(const Handle(Geom_Surface) & surface, const Vec2& uv) {
  gp_Pnt p;
  gp_Vec du, dv, uu, vv, both;
  surface->D2(uv[0], uv[1], p, du, dv, uu, vv, both);
  return {vec(uu), vec(both), vec(vv)};
}

std::vector<SurfacePole> poles_of(const Handle(Geom_Surface) & surface) {
  const GeomAdaptor_Surface adaptor(surface);
  if (adaptor.GetType() == GeomAbs_Cone) {
    const gp_Cone cone = adaptor.Cone();
    return {{vec(cone.Apex()), 1, -cone.RefRadius() / std::sin(cone.SemiAngle())}};
  }
  Interval u, v;
  surface->Bounds(u.from, u.to, v.from, v.to);
  std::vector<SurfacePole> poles;
  for (const double value : {v.from, v.to})
    if (const auto point = one_point([&](double t) { return surface->Value(t, value); }, u, value))
      poles.push_back({*point, 1, value});
  for (const double value : {u.from, u.to})
    if (const auto point = one_point([&](double t) { return surface->Value(value, t); }, v, value))
      poles.push_back({*point, 0, value});
  return poles;
}

SurfaceProjector::SurfaceProjector(const TopoDS_Face& face, double tolerance, PolledLimit* limit)
    : SurfaceProjector(whole_surface(face), projected(whole_surface(face), tolerance), tolerance,
                       limit) {}

SurfaceProjector::SurfaceProjector(Handle(Geom_Surface) surface, ProjectedSurface projected,
                                   double tolerance, PolledLimit* limit)
    : ChartProjector(std::move(projected), tolerance, limit), surface_(std::move(surface)) {}

SurfaceProjector SurfaceProjector::going_on(const TopoDS_Face& face, double tolerance,
                                            double beyond) {
  const Handle(Geom_Surface) surface = whole_surface(face);
  ProjectedSurface made = projected(surface, tolerance);
  if (is_spline(surface)) {
    const Vec2 low = made.low, high = made.high;
    for (int d = 0; d < 2; ++d) {
      if (made.period[d] + made.closed[d] > 0) continue;
      const double step = beyond * (high[d] - low[d]);
      if (!is_pole(made.poles, d, low[d])) made.low[d] -= step;
      if (!is_pole(made.poles, d, high[d])) made.high[d] += step;
    }
    made.search = nearest_of_points(surface, made.low, made.high);
    made.rough = true;
  }
  return {surface, std::move(made), tolerance, nullptr};
}

}  // namespace blossom::occt
