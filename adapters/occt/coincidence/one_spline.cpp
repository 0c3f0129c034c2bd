// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/coincidence/one_spline.h"

#include <array>

#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/forms/surface_match.h"
#include "core/math/interval.h"
#include "core/self_intersection.h"

namespace blossom::occt {
namespace {

Handle(Geom_Surface) spline_of(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = basis_of(BRep_Tool::Surface(face));
  const bool is_spline = surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface)) ||
                         surface->IsKind(STANDARD_TYPE(Geom_BezierSurface));
  return is_spline ? surface : nullptr;
}

ParameterBox bounds_of(const Handle(Geom_Surface) & surface) {
  ParameterBox box;
  surface->Bounds(box.u.from, box.u.to, box.v.from, box.v.to);
  return box;
}

bool holds(const ParameterBox& outer, const ParameterBox& inner) {
  return within(inner.u, outer.u) && within(inner.v, outer.v);
}

std::array<Vec3, 4> corners(const Handle(Geom_Surface) & surface, const ParameterBox& box) {
  return {vec(surface->Value(box.u.from, box.v.from)), vec(surface->Value(box.u.to, box.v.from)),
          vec(surface->Value(box.u.from, box.v.to)), vec(surface->Value(box.u.to, box.v.to))};
}

// The surface over a box, divided at the knots of another one as well; they change nothing but
// that.
BezierSurface divided(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                      const Handle(Geom_Surface) & other, double tolerance) {
  const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
  const auto knots = Handle(Geom_BSplineSurface)::DownCast(other);
  if (spline.IsNull() || knots.IsNull()) return bezier_surface(surface, box, tolerance);
  const auto is_inside = [](const Interval& range, double knot) {
    return range.from < knot && knot < range.to;
  };
  constexpr double kSameKnot = 0x1p-40;  // of the range
  for (int k = 1; k <= knots->NbUKnots(); ++k)
    if (is_inside(box.u, knots->UKnot(k)))
      spline->InsertUKnot(knots->UKnot(k), 1, kSameKnot * length(box.u), false);
  for (int k = 1; k <= knots->NbVKnots(); ++k)
    if (is_inside(box.v, knots->VKnot(k)))
      spline->InsertVKnot(knots->VKnot(k), 1, kSameKnot * length(box.v), false);
  return bezier_surface(spline, box, tolerance);
}

// Of the smaller surface, or of either, with the other one over the same bounds.
std::optional<double> gap_over(const Handle(Geom_Surface) & a, const ParameterBox& over_a,
                               const Handle(Geom_Surface) & b, const ParameterBox& over_b,
                               double tolerance) {
  // Corners agree in some order, which most surfaces tell apart without conversion.
  for (const Vec3& p : corners(a, over_a)) {
    bool is_corner = false;
    for (const Vec3& q : corners(b, over_b)) is_corner |= distance(p, q) <= tolerance;
    if (!is_corner) return {};
  }
  auto same =
      match(bezier_surface(a, over_a, tolerance), bezier_surface(b, over_b, tolerance), tolerance);
  if (!same)
    same = match(divided(a, over_a, b, tolerance), divided(b, over_b, a, tolerance), tolerance);
  return same ? same->gap : std::optional<double>{};
}

}  // namespace

std::optional<double> gap_of_one_spline(const TopoDS_Face& a, const TopoDS_Face& b,
                                        const IntersectionOptions& options) {
  const Handle(Geom_Surface) on_a = spline_of(a), on_b = spline_of(b);
  if (on_a.IsNull() || on_b.IsNull()) return {};
  const double tolerance = options.tolerances.point;
  const ParameterBox of_a = bounds_of(on_a), of_b = bounds_of(on_b);
  const bool b_in_a = holds(of_a, of_b), a_in_b = holds(of_b, of_a);
  std::optional<double> gap = gap_over(on_a, of_a, on_b, of_b, tolerance);
  if (!gap && b_in_a) gap = gap_over(on_a, of_b, on_b, of_b, tolerance);
  if (!gap && a_in_b) gap = gap_over(on_a, of_a, on_b, of_a, tolerance);
  if (!gap || *gap > tolerance) return {};
  const SurfaceIntersection own =
      self_intersect(a_in_b ? bezier_surface(on_b, of_b) : bezier_surface(on_a, of_a), options);
  const bool is_simple = own.status == Status::Complete && own.curves.empty() &&
                         own.points.empty() && own.nodes.empty() && own.overlaps.empty();
  return is_simple ? gap : std::optional<double>{};
}

}  // namespace blossom::occt
