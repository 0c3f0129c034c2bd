// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/area_surface.h"

#include <algorithm>

#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_SweptSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>

namespace blossom::occt {

AreaSurface::AreaSurface(const TopoDS_Face& face, const ParameterBox& box) : box_(box) {
  const Handle(Geom_Surface) surface = basis_of(BRep_Tool::Surface(face));
  const ParameterBox natural = natural_bounds(*surface);
  const auto common = [](const Interval& a, const Interval& b) {
    return Interval{std::max(a.from, b.from), std::min(a.to, b.to)};
  };
  const ParameterBox inside{common(box.u, natural.u), common(box.v, natural.v)};
  if (inside.u.from < inside.u.to && inside.v.from < inside.v.to) {
    box_ = inside;
    spans_ = spans_of(surface, inside);
  }
  adaptor_.Load(surface, box_.u.from, box_.u.to, box_.v.from, box_.v.to);
}

BezierSurface AreaSurface::spans_of(const Handle(Geom_Surface) & surface, const ParameterBox& box) {
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull())
    return spline_patches(*spline, box);
  if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface); !bezier.IsNull())
    return spline_patches(*bezier, box);
  if (Handle(Geom_SweptSurface)::DownCast(surface).IsNull()) return {};
  BezierSurface swept = swept_patches(surface, box, Precision::Confusion());
  return swept.error == 0 ? swept : BezierSurface{};
}

std::vector<double> AreaSurface::knots(Along along) const {
  const bool u = along == Along::U;
  if (!spans_.patches.empty()) {
    std::vector<double> knots = u ? spans_.u_knots : spans_.v_knots;
    const Interval& side = u ? box_.u : box_.v;
    knots.front() = side.from;
    knots.back() = side.to;
    return knots;
  }
  const int count = u ? adaptor_.NbUIntervals(GeomAbs_CN) : adaptor_.NbVIntervals(GeomAbs_CN);
  TColStd_Array1OfReal ends(1, count + 1);
  if (u)
    adaptor_.UIntervals(ends, GeomAbs_CN);
  else
    adaptor_.VIntervals(ends, GeomAbs_CN);
  return {ends.begin(), ends.end()};
}

Lines AreaSurface::lines() const {
  switch (adaptor_.GetType()) {
    case GeomAbs_Plane: return Lines::Constant;
    case GeomAbs_Cylinder:
    case GeomAbs_SurfaceOfExtrusion: return Lines::Even;
    case GeomAbs_Cone:
    case GeomAbs_Sphere:
    case GeomAbs_Torus: return Lines::Turning;
    default: return Lines::Any;
  }
}

}  // namespace blossom::occt
