// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces without an exact Bezier form, by interpolation with a measured error.

#include <string>
#include <vector>

#include <GeomAdaptor_Surface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves_detail.h"
#include "adapters/occt/convert/limits.h"
#include "adapters/occt/convert/surfaces_detail.h"
#include "core/forms/spans/fitted_spans.h"
#include "core/forms/spans/swept_surface.h"

namespace blossom::occt {
namespace {

/// The ends of a range and the places inside where the surface is not smooth.
std::vector<double> smooth_breaks(const TColStd_Array1OfReal& found, const Interval& range) {
  std::vector<double> breaks{range.from};
  const double sliver = kRangeRounding * length(range);
  for (const double place : found)
    if (place > breaks.back() + sliver && place < range.to - sliver) breaks.push_back(place);
  breaks.push_back(range.to);
  return breaks;
}

std::vector<double> u_breaks(const Handle(Geom_Surface) & surface, const ParameterBox& box) {
  const GeomAdaptor_Surface adaptor(surface, box.u.from, box.u.to, box.v.from, box.v.to);
  TColStd_Array1OfReal u(1, adaptor.NbUIntervals(GeomAbs_CN) + 1);
  adaptor.UIntervals(u, GeomAbs_CN);
  return smooth_breaks(u, box.u);
}

std::vector<double> v_breaks(const Handle(Geom_Surface) & surface, const ParameterBox& box) {
  const GeomAdaptor_Surface adaptor(surface, box.u.from, box.u.to, box.v.from, box.v.to);
  TColStd_Array1OfReal v(1, adaptor.NbVIntervals(GeomAbs_CN) + 1);
  adaptor.VIntervals(v, GeomAbs_CN);
  return smooth_breaks(v, box.v);
}

// The point of a surface at (u, v).
Vec3 finite(const gp_Pnt& point, double u, double v) {
  // The words of a message are made only where there is one to write.
  if (!is_finite(point.XYZ()))
    check_finite(point.XYZ(),
                 "the surface at (" + std::to_string(u) + ", " + std::to_string(v) + ")");
  return vec(point);
}

}  // namespace

BezierSurface swept_offset(const Handle(Geom_OffsetSurface) & offset, const ParameterBox& box,
                           double tolerance, ArcCuts cuts) {
  const Handle(Geom_Surface) basis = basis_of(offset->BasisSurface());
  if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(basis); !turned.IsNull()) {
    const auto meridian = [&](double v) { return finite(offset->Value(0, v), 0, v); };
    return turned_surface(curved_meridian(fitted_spans(meridian, v_breaks(offset, box), tolerance),
                                          vec(turned->Location()), vec(turned->Direction().XYZ())),
                          box.u, cuts);
  }
  if (const auto moved = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(basis); !moved.IsNull()) {
    const auto profile = [&](double u) { return finite(offset->Value(u, 0), u, 0); };
    return extruded_surface(fitted_spans(profile, u_breaks(offset, box), tolerance),
                            vec(moved->Direction().XYZ()), box.v);
  }
  return {};
}

BezierSurface fitted_patches(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                             double tolerance) {
  // The adaptor keeps the span of a spline below an offset that was asked for last.
  const GeomAdaptor_Surface adaptor(surface);
  const auto value = [&](double u, double v) { return finite(adaptor.Value(u, v), u, v); };
  return fitted_surface(value, u_breaks(surface, box), v_breaks(surface, box), tolerance);
}

}  // namespace blossom::occt
