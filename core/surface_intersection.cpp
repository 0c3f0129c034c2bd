// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surface_intersection.h"

#include <cmath>

#include "core/base/errors.h"
#include "core/base/parallel.h"
#include "core/surface_assembly.h"

namespace blossom {

SurfaceIntersection intersect(const BezierSurface& a, const BezierSurface& b,
                              const IntersectionOptions& options) {
  validate(a, "a");
  validate(b, "b");
  if (!(options.tolerances.point > 0) || !std::isfinite(options.tolerances.point))
    throw InvalidInput("intersect: the point tolerance must be positive and finite");
  if (options.threads < 0) throw InvalidInput("intersect: the number of threads is negative");
  SurfaceIntersection result;
  with_threads(options.threads, [&] { result = assembled(a, b, options); });
  return result;
}

}  // namespace blossom
