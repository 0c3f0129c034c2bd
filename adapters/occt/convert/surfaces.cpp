// SPDX-License-Identifier: LGPL-2.1-or-later
// Any surface as Bezier patches: checks, the choice of the way, and what holds for all ways.

#include "adapters/occt/convert/surfaces.h"

#include <cmath>

#include <BRep_Tool.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SweptSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves_detail.h"
#include "adapters/occt/convert/surfaces_detail.h"

namespace blossom::occt {
namespace {

/// Weights of two borders that are the same curve agree to this, after scaling.
constexpr double kWeightRounding = 1e-9;

/// A border of the grid: a row of control points in one direction.
std::vector<Vec4> border(const BezierSurface& surface, bool along_v, bool last) {
  std::vector<Vec4> points;
  const auto& patches = surface.patches;
  const int count = along_v ? patches.columns() : patches.rows();
  for (int k = 0; k < count; ++k) {
    const Grid<Vec4>& net = (along_v ? patches(last ? patches.rows() - 1 : 0, k)
                                     : patches(k, last ? patches.columns() - 1 : 0))
                                .points;
    const int size = along_v ? net.columns() : net.rows();
    for (int i = 0; i < size; ++i)
      points.push_back(along_v ? net(last ? net.rows() - 1 : 0, i)
                               : net(i, last ? net.columns() - 1 : 0));
  }
  return points;
}

bool meet(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (euclidean(a[i]).Distance(euclidean(b[i])) > Precision::Confusion()) return false;
    if (std::abs(a[i][3] * b[0][3] / (b[i][3] * a[0][3]) - 1) > kWeightRounding) return false;
  }
  return true;
}

void note_properties(BezierSurface& surface) {
  surface.closed_u = meet(border(surface, true, false), border(surface, true, true));
  surface.closed_v = meet(border(surface, false, false), border(surface, false, true));
  surface.rational = false;
  for (const RationalBezierPatch& patch : surface.patches.values())
    for (const Vec4& point : patch.points.values())
      surface.rational = surface.rational || point[3] != 1;
}

BezierSurface patches_of(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                         double tolerance, ArcCuts cuts) {
  if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface); !bezier.IsNull())
    return spline_patches(*bezier, box);
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull())
    return spline_patches(*spline, box);
  BezierSurface swept = swept_patches(surface, box, tolerance, cuts);
  return swept.patches.empty() ? fitted_patches(surface, box, tolerance) : swept;
}

template <class Surface>
void check_surface_poles(const Surface& surface) {
  const bool rational = surface.IsURational() || surface.IsVRational();
  WeightRange weights;
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      const gp_XYZ pole = surface.Pole(i, j).XYZ();
      const double weight = rational ? surface.Weight(i, j) : 1;
      weights.add(weight);
      if (is_bounded(pole) && weight > 0 && std::isfinite(weight)) continue;
      const std::string place = " (" + std::to_string(i) + ", " + std::to_string(j) + ")";
      check_bounded(pole, "control point" + place);
      check_weight(weight, "weight" + place);
    }
  weights.check();
}

void check_knots(const Geom_BSplineSurface& surface) {
  for (int i = 1; i <= surface.NbUKnots(); ++i)
    check_finite({surface.UKnot(i), 0, 0}, "u knot " + std::to_string(i));
  for (int i = 1; i <= surface.NbVKnots(); ++i)
    check_finite({surface.VKnot(i), 0, 0}, "v knot " + std::to_string(i));
}

}  // namespace

Handle(Geom_Surface) basis_of(Handle(Geom_Surface) surface) {
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
    surface = trimmed->BasisSurface();
  return surface;
}

ParameterBox natural_bounds(const Geom_Surface& surface) {
  const Interval endless{-Precision::Infinite(), Precision::Infinite()};
  ParameterBox bounds;
  surface.Bounds(bounds.u.from, bounds.u.to, bounds.v.from, bounds.v.to);
  if (surface.IsUPeriodic()) bounds.u = endless;
  if (surface.IsVPeriodic()) bounds.v = endless;
  return bounds;
}

namespace {

void check_radius(const Geom_Surface& surface) {
  double radius = 1;
  if (const auto* sphere = dynamic_cast<const Geom_SphericalSurface*>(&surface))
    radius = sphere->Radius();
  else if (const auto* cylinder = dynamic_cast<const Geom_CylindricalSurface*>(&surface))
    radius = cylinder->Radius();
  else if (const auto* torus = dynamic_cast<const Geom_ToroidalSurface*>(&surface))
    radius = torus->MinorRadius();
  if (!(radius > 0)) throw BadModel("its radius is " + std::to_string(radius));
}

}  // namespace

void check_numbers(const Geom_Surface& surface) {
  if (const auto* bezier = dynamic_cast<const Geom_BezierSurface*>(&surface)) {
    check_surface_poles(*bezier);
  } else if (const auto* spline = dynamic_cast<const Geom_BSplineSurface*>(&surface)) {
    check_surface_poles(*spline);
    check_knots(*spline);
  } else if (const auto* trimmed = dynamic_cast<const Geom_RectangularTrimmedSurface*>(&surface)) {
    check_numbers(*trimmed->BasisSurface());
  } else if (const auto* offset = dynamic_cast<const Geom_OffsetSurface*>(&surface)) {
    check_finite({offset->Offset(), 0, 0}, "the offset");
    check_numbers(*offset->BasisSurface());
  } else {
    if (const auto* swept = dynamic_cast<const Geom_SweptSurface*>(&surface))
      check_numbers(*swept->BasisCurve());
    else
      check_bounded(surface.Value(0.5, 0.5).XYZ(), "a number of the surface");
    check_radius(surface);
  }
}

BezierSurface bezier_surface(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                             double tolerance, ArcCuts cuts) {
  if (surface.IsNull()) throw BadModel("there is no surface");
  return guarded("converting a surface", [&] {
    const Handle(Geom_Surface) basis = basis_of(surface);
    check_numbers(*basis);
    const ParameterBox natural = natural_bounds(*basis);
    const ParameterBox inside{checked_range(box.u, natural.u, "the parameter box in u"),
                              checked_range(box.v, natural.v, "the parameter box in v")};
    BezierSurface result = patches_of(basis, inside, tolerance, cuts);
    note_properties(result);
    return result;
  });
}

BezierSurface bezier_surface(const TopoDS_Face& face, double tolerance) {
  const ParameterBox box = parameter_box(face);
  return bezier_surface(BRep_Tool::Surface(face), box, tolerance);
}

}  // namespace blossom::occt
