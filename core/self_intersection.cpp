// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/self_intersection.h"

#include <cmath>

#include "core/base/errors.h"
#include "core/base/parallel.h"
#include "core/surfaces/assembly/surface_assembly.h"
#include "core/surfaces/search/self_pairs.h"

namespace blossom {

SurfaceIntersection self_intersect(const BezierSurface& surface,
                                   const IntersectionOptions& options) {
  if (!(options.tolerances.point > 0) || !std::isfinite(options.tolerances.point))
    throw InvalidInput("self_intersect: the point tolerance must be positive and finite");
  if (options.threads < 0) throw InvalidInput("self_intersect: the number of threads is negative");
  SurfaceIntersection result;
  with_threads(options.threads, [&] {
    validate(surface, "surface");
    const GluedBorders glued = glued_borders(surface);
    BezierSurface marked = surface;
    marked.closed_u = glued.seam_u;
    marked.closed_v = glued.seam_v;
    const BoxedSurface boxed{marked, PatchBoxes(marked)};
    result = assembled(boxed, boxed, options);
  });
  return result;
}

}  // namespace blossom
