// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves are intersected with each other, themselves and surfaces; feet of points are sought.
#include <cmath>
#include <functional>

#include "core/base/errors.h"
#include "core/curve_intersection.h"
#include "core/curve_surface_intersection.h"
#include "core/foot_points.h"
#include "tests/fuzz/support/forms.h"

namespace blossom::fuzz {
namespace {

template <class Found>
void look_at(const Found& found) {
  for (const auto& point : found.points)
    require(!std::isnan(point.point[0] + point.point[1] + point.point[2]),
            "a coordinate is no number");
  require(found.status != Status::Stopped || !found.certificate.reasons.empty(),
          "nothing says why the search was stopped");
}

void seek_feet(const BezierSurface& surface, Choices& choices) {
  const Vec3 point{0.5 * choices.within(-4, 4), choices.between(-2, 2), choices.between(-2, 2)};
  const std::function<bool()> never;  // which the limit refers to
  const WorkLimit limit(0.5, never);
  for (const FootPoint& foot : foot_points(measured(surface), point, 1e-7, &limit))
    require(!std::isnan(foot.distance), "the distance to a foot is no number");
}

}  // namespace

void try_input(Bytes input) try {
  Choices choices(input);
  const int kind = choices.within(0, 4);
  const IntersectionOptions options = options_of(choices);
  if (kind >= 3) {
    const BezierSurface surface = surface_of(choices);
    if (kind == 4) return seek_feet(surface, choices);
    return look_at(intersect(curve_near(surface, choices), surface, options));
  }
  const CurveSpans a = curve_of(choices);
  if (kind == 2) return look_at(self_intersections(a, options));
  look_at(intersect(a, curve_beside(a, choices), options));
} catch (const InvalidInput&) {
}

}  // namespace blossom::fuzz
