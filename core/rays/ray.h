// SPDX-License-Identifier: LGPL-2.1-or-later
// Rays, and what they hit.

#pragma once

#include "core/base/status.h"
#include "core/base/unbounded.h"
#include "core/math/vec.h"

namespace blossom {

/// The points origin + t direction, from <= t <= to. A whole line runs from -infinity to infinity.
struct Ray {
  Vec3 origin;     ///< model units
  Vec3 direction;  ///< of any length but 0
  double from = 0;
  double to = kInfinity;
};

inline Vec3 point_at(const Ray& ray, double parameter) {
  return ray.origin + parameter * ray.direction;
}

/// A point, or a stretch, that a ray has in common with a surface.
struct RayHit {
  double parameter = 0;  ///< of the ray: a length in model units if the direction is a unit vector
  double first = 0;      ///< the stretch; both equal `parameter` at a point
  double last = 0;
  int surface = 0;
  Vec2 uv;               ///< the surface's own parameters
  Vec3 point;            ///< on the surface, model units
  double beyond = 0;     ///< how far outside of the surface's border the line passes, model units
  Vec3 normal;           ///< of the surface, unit, along S_u x S_v; zero at a singular point
  bool grazing = false;  ///< the ray is tangent to the surface, or nearly so
  bool border = false;   ///< on the border of a patch, within tolerance

  /// Complete: the ray crosses the surface here, proven, and once. Tolerance: the surface comes
  /// within tolerance of the ray, but whether they meet once, twice or not at all is below
  /// rounding, or the stretch is shorter than the tolerance. Stopped: the budget was spent before
  /// it was known whether there is a hit within the stretch.
  Status status = Status::Complete;

  /// Complete, but of a surface that stands for another one within its error: the status is
  /// Tolerance for that alone.
  bool approximate = false;

  /// The filter's own note about the hit; of joined hits the largest one is kept.
  int mark = 0;

  int patch = 0;  ///< patches are numbered row after row, surface after surface
  Vec2 local;     ///< parameters of the patch, in [0, 1]^2
};

/// |sin| of the angle between ray and surface below which a hit is called grazing: at 1e-6 a
/// deviation of the surface by the default tolerance moves the hit by 0.1 model units.
inline constexpr double kGrazing = 1e-6;

}  // namespace blossom
