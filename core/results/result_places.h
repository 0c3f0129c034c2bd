// SPDX-License-Identifier: LGPL-2.1-or-later
// How a point lies to what a result already holds. Lengths are in model units.

#pragma once

#include "core/results/result.h"

namespace blossom {

/// True if a point of contact of the result is within `reach`.
bool is_known_contact(const SurfaceIntersection& result, const Vec3& point, double reach);

/// True if a curve passes within `reach`, by the chords of its samples; of tangential curves only,
/// if that is asked for.
bool is_on_curve(const SurfaceIntersection& result, const Vec3& point, double reach,
                 bool tangential_only = false);

/// True if a curve ends within `reach`, be it under other parameters of the same point.
bool ends_curve(const SurfaceIntersection& result, const Vec3& point, double reach);

/// True if a place of it is one where the surfaces coincide.
bool has_overlap(const SurfaceIntersection& result);

/// True if a point of an overlap's boundary is within `reach`.
bool bounds_overlap(const SurfaceIntersection& result, const Vec3& point, double reach);

}  // namespace blossom
