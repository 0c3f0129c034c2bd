// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes, quadrics, tori, surfaces of extrusion and of revolution, and offsets of them, as Bezier
// patches.

#include <array>
#include <cmath>
#include <utility>

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
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
#include "core/forms/spans/swept_surface.h"

namespace blossom::occt {
namespace {

MeridianFrame frame_of(const gp_Ax3& axes) {
  return {vec(axes.Location()), vec(axes.XDirection().XYZ()), vec(axes.YDirection().XYZ()),
          vec(axes.Direction().XYZ())};
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
    return turned_surface(
        straight_meridian(frame_of(cylinder->Position()), cylinder->Radius(), 0, 1, box.v), box.u,
        cuts);
  if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) {
    const double angle = cone->SemiAngle();
    return turned_surface(straight_meridian(frame_of(cone->Position()), cone->RefRadius(),
                                            std::sin(angle), std::cos(angle), box.v),
                          box.u, cuts);
  }
  if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull())
    return turned_surface(
        circular_meridian(frame_of(sphere->Position()), 0, sphere->Radius(), box.v, cuts), box.u,
        cuts);
  if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface); !torus.IsNull())
    return turned_surface(circular_meridian(frame_of(torus->Position()), torus->MajorRadius(),
                                            torus->MinorRadius(), box.v, cuts),
                          box.u, cuts);
  if (const auto moved = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface); !moved.IsNull())
    return extruded_surface(profile_spans(moved->BasisCurve(), box.u, tolerance, cuts),
                            vec(moved->Direction().XYZ()), box.v);
  if (const auto revolved = Handle(Geom_SurfaceOfRevolution)::DownCast(surface); !revolved.IsNull())
    return turned_surface(
        curved_meridian(profile_spans(revolved->BasisCurve(), box.v, tolerance, cuts),
                        vec(revolved->Location()), vec(revolved->Direction().XYZ())),
        box.u, cuts);
  if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface); !offset.IsNull()) {
    if (const auto simple = elementary_offset(*offset, box); !simple.IsNull())
      return swept_patches(simple, box, tolerance, cuts);
    return swept_offset(offset, box, tolerance, cuts);
  }
  return {};
}

}  // namespace blossom::occt
