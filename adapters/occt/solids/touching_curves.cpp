// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/touching_curves.h"

#include <algorithm>
#include <cmath>

#include <Bnd_Box.hxx>

#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/faces/surface_projector.h"

namespace blossom::occt {
namespace {

// How far beside a contact the surfaces are looked at first: of its length, and of the root of that
// times the tolerance, within which surfaces with a radius of that length do not leave each other.
// Then twice as far and so on, until they do or the smaller face ends.
constexpr double kBeside = 1e-2;
constexpr double kLeave = 4;

// Beside a tangential curve, the sides of the second face on which the first one lies.
struct Beside {
  bool above = false, below = false, open = false;
};

void look_beside(const IntersectionCurve& curve, const SurfaceProjector& on_a,
                 const SurfaceProjector& on_b, double tolerance, double farthest, Beside& beside) {
  const double step =
      std::max(kBeside * curve.length, kLeave * std::sqrt(tolerance * curve.length));
  for (const double part : {0.2, 0.5, 0.8}) {
    const double s = at(curve.curve.domain(), part);
    const SurfaceJet frame = frame_at(on_a.surface(), point_at(curve.chart_a, s));
    const Vec3 across = cross(cross(frame.du, frame.dv), derivative_at(curve.curve, s));
    for (const double sign : {1.0, -1.0}) {
      double height = 0;
      for (double far = step; far <= farthest && std::abs(height) <= tolerance; far *= 2) {
        const Vec3 aside = frame.point + sign * far / norm(across) * across;
        height = on_b.height(frame_at(on_a.surface(), on_a.foot(aside, {})).point);
      }
      (std::abs(height) <= tolerance ? beside.open
       : height > 0                  ? beside.above
                                     : beside.below) = true;
    }
  }
}

double extent(const TopoDS_Face& face) { return std::sqrt(bounds_of(face).SquareExtent()); }

}  // namespace

bool only_touch(const IntersectionCurve& curve, const TopoDS_Face& a, const TopoDS_Face& b,
                double tolerance) {
  Beside beside;
  look_beside(curve, SurfaceProjector(a, tolerance), SurfaceProjector(b, tolerance), tolerance,
              std::min(extent(a), extent(b)), beside);
  return !beside.open && beside.above != beside.below;
}

}  // namespace blossom::occt
