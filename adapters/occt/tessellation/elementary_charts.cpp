// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/tessellation/elementary_charts.h"

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/surfaces.h"

namespace blossom::occt {

std::optional<ElementaryChart> elementary_chart(const Handle(Geom_Surface) & given) {
  const auto surface = Handle(Geom_ElementarySurface)::DownCast(basis_of(given));
  if (surface.IsNull()) return {};
  const gp_Ax3& place = surface->Position();
  ElementaryChart chart;
  chart.origin = vec(place.Location());
  chart.x = vec(place.XDirection().XYZ());
  chart.y = vec(place.YDirection().XYZ());
  chart.z = vec(place.Direction().XYZ());
  if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface);
      !cylinder.IsNull()) {
    chart.kind = ElementaryKind::Cylinder;
    chart.radius = cylinder->Radius();
  } else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) {
    chart.kind = ElementaryKind::Cone;
    chart.radius = cone->RefRadius();
    chart.angle = cone->SemiAngle();
  } else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface);
             !sphere.IsNull()) {
    chart.kind = ElementaryKind::Sphere;
    chart.radius = sphere->Radius();
  } else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface); !torus.IsNull()) {
    chart.kind = ElementaryKind::Torus;
    chart.radius = torus->MajorRadius();
    chart.minor = torus->MinorRadius();
  } else if (Handle(Geom_Plane)::DownCast(surface).IsNull()) {
    return {};
  }
  return chart;
}

}  // namespace blossom::occt
