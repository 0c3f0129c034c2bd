// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces far from the origin, moved there for the search: coordinates of 1e6 are rounded to
// 1e-10, and what is told by squares of them to much more.

#pragma once

#include "core/bounds/box_tree.h"
#include "core/forms/surface.h"
#include "core/results/options.h"
#include "core/results/result.h"

namespace blossom {

/// What is taken off the coordinates in a box; 0 along axes on which they are small, or not within
/// a factor of 2 of each other. If they are, the differences are exact.
///
/// tolerance   coordinates that are rounded to less than 1e-4 of it are small
/// Source: Sterbenz 1974: x - y is exact if y / 2 <= x <= 2 y.
Vec3 far_origin(const Box& box, double tolerance);

/// The surface seen from the origin, and the options with their known curves.
BezierSurface seen_from(const Vec3& origin, BezierSurface surface);
IntersectionOptions seen_from(const Vec3& origin, IntersectionOptions options);

/// What was found there, back in its place: bounds hold the roundings of that.
SurfaceIntersection moved_back(const Vec3& origin, SurfaceIntersection found);

}  // namespace blossom
