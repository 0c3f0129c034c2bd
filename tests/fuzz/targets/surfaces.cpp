// SPDX-License-Identifier: LGPL-2.1-or-later
// Two surfaces are intersected, one with itself, their distance taken, and both joined by a strip.
#include <cmath>

#include "core/base/errors.h"
#include "core/blending/strips/strip.h"
#include "core/distance.h"
#include "core/self_intersection.h"
#include "core/surface_intersection.h"
#include "tests/fuzz/support/forms.h"

namespace blossom::fuzz {
namespace {

void look_at(const SurfaceIntersection& found) {
  for (const IntersectionCurve& curve : found.curves) {
    require(curve.samples.size() >= 2, "a curve has less than two samples");
    for (const SurfacePoint& sample : curve.samples)
      require(is_finite(sample.point), "a sample of a curve is not finite");
    for (const Vec3& point : curve.curve.points)
      require(is_finite(point), "a control point of a curve is not finite");
    require(!std::isnan(curve.length), "a length is no number");
  }
  for (const SurfacePoint& point : found.points)
    require(is_finite(point.point), "a point is not finite");
  require(found.status != Status::Stopped || !found.certificate.reasons.empty(),
          "nothing says why the search was stopped");
}

void measure(const BezierSurface& a, const BezierSurface& b) {
  DistanceOptions options;
  options.budget = 2000;
  options.time_limit = 0.5;  // seconds
  const DistanceResult found = least_distance(measured(a), measured(b), options);
  require(found.lower <= found.upper, "the bounds of a distance are the wrong way round");
}

}  // namespace

void try_input(Bytes input) try {
  Choices choices(input);
  const int kind = choices.within(0, 5);
  const IntersectionOptions options = options_of(choices);
  const BezierSurface a = surface_of(choices);
  if (kind == 5) return look_at(self_intersect(a, options));
  const BezierSurface b = surface_beside(a, choices);
  if (kind == 4) return measure(a, b);
  if (kind < 3) return look_at(intersect(a, b, options));
  constexpr SurfaceSide kSides[] = {SurfaceSide::UMin, SurfaceSide::UMax, SurfaceSide::VMin,
                                    SurfaceSide::VMax};
  strip_gap_bound(
      strip_between(a, kSides[choices.within(0, 3)], b, kSides[choices.within(0, 3)]).surface);
} catch (const InvalidInput&) {
}

}  // namespace blossom::fuzz
