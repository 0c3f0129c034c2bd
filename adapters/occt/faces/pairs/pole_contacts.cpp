// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/pairs/pole_contacts.h"

#include <optional>

#include "adapters/occt/faces/surface_projector.h"
#include "core/topology/clipping/curve_clip.h"

namespace blossom::occt {
namespace {

// A pole is one point, whatever its free parameter: that of its edge's beginning stands for all.
void add_poles(const FaceData& of_a, const TopoDS_Face& b, const FaceData& of_b, double tolerance,
               bool exchanged, std::vector<Touch>& found) {
  const Box near = widened(of_b.box, tolerance);
  std::optional<SurfaceProjector> feet;
  for (const auto& loop : of_a.trims.loops)
    for (const Coedge& coedge : loop) {
      if (!coedge.degenerated) continue;
      const Vec2 chart = end_point(coedge, false);
      const Vec2 uv{chart[0] / of_a.trims.scale[0], chart[1] / of_a.trims.scale[1]};
      const Vec3 pole = of_a.trims.jet(uv).point;
      if (!meet(near, {pole, pole})) continue;
      if (!feet) feet.emplace(b, tolerance);
      const Vec2 foot = feet->foot(pole, {});
      const double gap = feet->gap(pole, foot);
      if (gap > tolerance || distance_outwards(of_b.trims, foot) > tolerance) continue;
      found.push_back(
          {exchanged ? SurfacePoint{pole, foot, uv} : SurfacePoint{pole, uv, foot}, gap});
    }
}

}  // namespace

std::vector<Touch> pole_contacts(const TopoDS_Face& a, const FaceData& of_a, const TopoDS_Face& b,
                                 const FaceData& of_b, double tolerance) {
  std::vector<Touch> found;
  add_poles(of_a, b, of_b, tolerance, false, found);
  add_poles(of_b, a, of_a, tolerance, true, found);
  return found;
}

}  // namespace blossom::occt
