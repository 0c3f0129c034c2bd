// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/face_data.h"

#include <algorithm>
#include <numbers>

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Surface.hxx>
#include <Geom_TrimmedCurve.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/elementary_faces.h"
#include "adapters/occt/faces/swept_faces.h"
#include "core/base/tolerances.h"
#include "core/base/unbounded.h"
#include "core/forms/meetings/recognition.h"

namespace blossom::occt {
namespace {

// Of the tolerance: two approximations are then together within half of it, and what they stand for
// is apart where they are by the tolerance.
constexpr double kApproximated = 0.25;

constexpr double kBeyondTrims = 1e-3;  // of the box of the trims, on every side

Interval wider(const Interval& side, const Interval& natural, double period) {
  double margin = kBeyondTrims * length(side);
  if (period > 0) margin = std::min(margin, 0.5 * (period - length(side)));
  return {std::max(side.from - margin, std::min(side.from, natural.from)),
          std::min(side.to + margin, std::max(side.to, natural.to))};
}

// Whether a rational surface goes on beyond any box of its parameters as it is inside.
bool goes_on(const GeomAdaptor_Surface& surface) {
  switch (surface.GetType()) {
    case GeomAbs_Plane:
    case GeomAbs_Cylinder:
    case GeomAbs_Sphere:
    case GeomAbs_Torus: return true;
    default: return false;
  }
}

// Of straight wires the ends are the box; of others the control points may lie outside of it.
ParameterBox box_of(const TopoDS_Face& face, const FaceTrims& trims) {
  const auto is_straight = [](const Coedge& coedge) {
    return std::ranges::all_of(coedge.curve.spans,
                               [](const PlanarSpan& span) { return span.curve.degree() <= 1; });
  };
  for (const auto& loop : trims.loops)
    if (!std::ranges::all_of(loop, is_straight)) return parameter_box(face);
  // The scales are powers of two, so this is what the curves have.
  const auto side = [&](int k) {
    return Interval{trims.box.low[k] / trims.scale[k], trims.box.high[k] / trims.scale[k]};
  };
  return parameter_box(face, {side(0), side(1)});
}

// Trims that are no rectangle touch their box, and what runs along them would touch the border of
// the surface. So it goes on beyond it, as may those that are one; then they have to be clipped.
BezierSurface surface_of(const TopoDS_Face& face, ParameterBox box, Extent extent, double tolerance,
                         ArcCuts cuts, FaceTrims& trims) {
  const Handle(Geom_Surface) surface = basis_of(BRep_Tool::Surface(face));
  if ((!trims.natural || extent == Extent::Extended) && goes_on(GeomAdaptor_Surface(surface))) {
    const ParameterBox own = box;
    Interval u, v;
    surface->Bounds(u.from, u.to, v.from, v.to);
    const bool in_u = surface->IsUPeriodic(), in_v = surface->IsVPeriodic();
    box.u = wider(box.u, in_u ? Interval{-kInfinity, kInfinity} : u, in_u ? surface->UPeriod() : 0);
    box.v = wider(box.v, in_v ? Interval{-kInfinity, kInfinity} : v, in_v ? surface->VPeriod() : 0);
    trims.natural =
        trims.natural && length(box.u) == length(own.u) && length(box.v) == length(own.v);
  }
  return bezier_surface(surface, box, kApproximated * tolerance, cuts);
}

Handle(Geom_Curve) space_curve(const IntersectionCurve& curve) {
  if (!curve.conic) return to_occt(curve.curve);
  const Handle(Geom_Curve) whole = to_occt(*curve.conic);
  const Interval range = curve.curve.domain();
  if (curve.conic->is_closed() && range == Interval{0, 2 * std::numbers::pi}) return whole;
  constexpr bool kSameSense = true, kIntoFirstPeriod = false;  // pcurves keep their parameter
  return guarded("trimming a conic", [&]() -> Handle(Geom_Curve) {
    return new Geom_TrimmedCurve(whole, range.from, range.to, kSameSense, kIntoFirstPeriod);
  });
}

// A spline may be a cylinder that a file has in that form.
void recognise(FaceData& data, double tolerance) {
  const double coordinate = std::max(max_norm(data.box.low), max_norm(data.box.high));
  const auto known = recognised(data.surface, one_within({tolerance}, coordinate));
  if (!known) return;
  data.elementary = known->elementary;
  data.off_elementary = known->gap;
}

}  // namespace

FaceData face_data(const TopoDS_Face& face, double tolerance, Extent extent, ArcCuts cuts) {
  FaceData data;
  data.trims = face_trims(face);
  const ParameterBox used = box_of(face, data.trims);
  data.surface = surface_of(face, used, extent, tolerance, cuts, data.trims);
  data.box = box_of(data.surface, data.surface.error + tolerance);
  data.elementary = elementary_of(BRep_Tool::Surface(face));
  if (!data.elementary) recognise(data, tolerance);
  if (!data.elementary)
    data.swept = swept_of(BRep_Tool::Surface(face), used, kApproximated * tolerance);
  return data;
}

EdgeCurves edge_curves(const IntersectionCurve& curve) {
  return {space_curve(curve), to_occt(curve.chart_a), to_occt(curve.chart_b),
          edge_tolerance(curve.deviation)};
}

}  // namespace blossom::occt
