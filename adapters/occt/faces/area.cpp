// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/area.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_SweptSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/surfaces_detail.h"
#include "adapters/occt/faces/border_strips.h"
#include "adapters/occt/faces/face_trims.h"

namespace blossom::occt {
namespace {

// Splines, and what is swept from them, are taken in Bezier form, since to look up spans and expand
// them anew for every point takes many times longer.
BezierSurface spans_of(const Handle(Geom_Surface) & surface, const ParameterBox& box) {
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull())
    return spline_patches(*spline, box);
  if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface); !bezier.IsNull())
    return spline_patches(*bezier, box);
  if (Handle(Geom_SweptSurface)::DownCast(surface).IsNull()) return {};
  BezierSurface swept = swept_patches(surface, box, Precision::Confusion());
  return swept.error == 0 ? swept : BezierSurface{};
}

std::vector<double> with_ends(std::vector<double> knots, const Interval& side) {
  knots.front() = side.from;
  knots.back() = side.to;
  return knots;
}

std::vector<double> smooth_ends(const GeomAdaptor_Surface& surface, bool u) {
  const int count = u ? surface.NbUIntervals(GeomAbs_CN) : surface.NbVIntervals(GeomAbs_CN);
  TColStd_Array1OfReal ends(1, count + 1);
  if (u)
    surface.UIntervals(ends, GeomAbs_CN);
  else
    surface.VIntervals(ends, GeomAbs_CN);
  return {ends.begin(), ends.end()};
}

DensityLines lines_of(const GeomAdaptor_Surface& surface) {
  switch (surface.GetType()) {
    case GeomAbs_Plane: return DensityLines::Constant;
    case GeomAbs_Cylinder:
    case GeomAbs_SurfaceOfExtrusion: return DensityLines::Even;
    case GeomAbs_Cone:
    case GeomAbs_Sphere:
    case GeomAbs_Torus: return DensityLines::Turning;
    default: return DensityLines::Any;
  }
}

std::function<SurfaceJet(const Vec2&)> jet_of(const Handle(GeomAdaptor_Surface) & surface) {
  return [surface](const Vec2& uv) {
    gp_Pnt point;
    gp_Vec du, dv;
    surface->D1(uv[0], uv[1], point, du, dv);
    return SurfaceJet{vec(point), vec(du.XYZ()), vec(dv.XYZ())};
  };
}

// The surface of a face over the box of its trims, no farther than it goes.
IntegrandSurface integrand_surface(const TopoDS_Face& face, const FaceTrims& trims) {
  ParameterBox box{{trims.box.low[0] / trims.scale[0], trims.box.high[0] / trims.scale[0]},
                   {trims.box.low[1] / trims.scale[1], trims.box.high[1] / trims.scale[1]}};
  const Handle(Geom_Surface) surface = basis_of(BRep_Tool::Surface(face));
  const ParameterBox natural = natural_bounds(*surface);
  const auto common = [](const Interval& a, const Interval& b) {
    return Interval{std::max(a.from, b.from), std::min(a.to, b.to)};
  };
  const ParameterBox inside{common(box.u, natural.u), common(box.v, natural.v)};
  IntegrandSurface made;
  if (inside.u.from < inside.u.to && inside.v.from < inside.v.to) {
    box = inside;
    made.spans = spans_of(surface, inside);
  }
  const Handle(GeomAdaptor_Surface) adaptor =
      new GeomAdaptor_Surface(surface, box.u.from, box.u.to, box.v.from, box.v.to);
  const bool has_spans = !made.spans.patches.empty();
  made.u_knots = has_spans ? with_ends(made.spans.u_knots, box.u) : smooth_ends(*adaptor, true);
  made.v_knots = has_spans ? with_ends(made.spans.v_knots, box.v) : smooth_ends(*adaptor, false);
  made.lines = lines_of(*adaptor);
  made.jet = jet_of(adaptor);
  return made;
}

// Of the cone over the strips from the face to its edges' curves.
ConeMoments moments_beside(const TopoDS_Face& face, const Vec3& apex) {
  ConeMoments sum;
  over_border_strips(face, [&](const Vec3& point, const Vec3& normal) {
    sum += cone_density(point, normal, apex);
  });
  return sum;
}

}  // namespace

double area(const TopoDS_Face& face, int cells) {
  const FaceTrims trims = face_trims(face);
  return trimmed_area(integrand_surface(face, trims), trims, cells);
}

double cone_volume(const TopoDS_Face& face, const Vec3& apex, double enough) {
  const FaceTrims trims = face_trims(face);
  const double volume = trimmed_cone_volume(integrand_surface(face, trims), trims, apex, enough);
  return face.Orientation() == TopAbs_REVERSED ? -volume : volume;
}

double cone_volume_beside(const TopoDS_Face& face, const Vec3& apex) {
  const double volume = moments_beside(face, apex).volume;
  return face.Orientation() == TopAbs_REVERSED ? -volume : volume;
}

double cone_volume_beside(const TopoDS_Face& face, const TopoDS_Edge& edge, const Interval& part,
                          const Vec3& apex) {
  double volume = 0;
  over_border_strip(edge, face, part, [&](const Vec3& point, const Vec3& normal) {
    volume += dot(point - apex, normal) / 3;
  });
  return face.Orientation() == TopAbs_REVERSED ? -volume : volume;
}

ConeMoments cone_moments(const TopoDS_Face& face, const Vec3& apex) {
  const FaceTrims trims = face_trims(face);
  ConeMoments moments = trimmed_cone_moments(integrand_surface(face, trims), trims, apex);
  moments += moments_beside(face, apex);
  return face.Orientation() == TopAbs_REVERSED ? -moments : moments;
}

Vec3 area_moment(const TopoDS_Face& face, const Vec3& origin) {
  const FaceTrims trims = face_trims(face);
  return trimmed_area_moment(integrand_surface(face, trims), trims, origin);
}

double polygon_area(const TopoDS_Face& face, std::span<const Vec2> polygon) {
  return blossom::polygon_area(jet_of(new GeomAdaptor_Surface(BRep_Tool::Surface(face))), polygon);
}

}  // namespace blossom::occt
