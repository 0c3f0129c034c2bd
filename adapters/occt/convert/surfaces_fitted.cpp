// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces without an exact Bezier form, by interpolation with a measured error.

#include <string>
#include <vector>

#include <GeomAdaptor_Surface.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves_detail.h"
#include "adapters/occt/convert/limits.h"
#include "adapters/occt/convert/surfaces_detail.h"
#include "core/forms/spans/fitted_spans.h"

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

}  // namespace

BezierSurface fitted_patches(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                             double tolerance) {
  const GeomAdaptor_Surface adaptor(surface, box.u.from, box.u.to, box.v.from, box.v.to);
  TColStd_Array1OfReal u(1, adaptor.NbUIntervals(GeomAbs_CN) + 1);
  TColStd_Array1OfReal v(1, adaptor.NbVIntervals(GeomAbs_CN) + 1);
  adaptor.UIntervals(u, GeomAbs_CN);
  adaptor.VIntervals(v, GeomAbs_CN);
  const auto value = [&](double s, double t) {
    const gp_Pnt point = surface->Value(s, t);
    check_finite(point.XYZ(),
                 "the surface at (" + std::to_string(s) + ", " + std::to_string(t) + ")");
    return vec(point);
  };
  return fitted_surface(value, smooth_breaks(u, box.u), smooth_breaks(v, box.v), tolerance);
}

}  // namespace blossom::occt
