// SPDX-License-Identifier: LGPL-2.1-or-later
// Loops in a chart: what they enclose, and how much.

#pragma once

#include <vector>

#include "core/plane/planar_curves.h"

namespace blossom {

/// A directed way through the chart: Bezier curves, each of which starts where the one before ends.
using PlanarPath = std::vector<PlanarBezier>;

Vec2 start_of(const PlanarPath& path);
Vec2 end_of(const PlanarPath& path);

/// A point in the middle of the path (of the middle one of its curves).
Vec2 middle_of(const PlanarPath& path);

/// How often the ray from `point` to the right is crossed from below to above, less the other way.
///
/// A path through an end of another counts each crossing once, because what counts for an end is
/// only whether it lies above the ray. The straight ways over gaps between neighbouring curves of
/// the path count as well. Decided by boxes and halving; a point on the path itself gets either
/// answer.
int ray_crossings(const PlanarPath& path, const Vec2& point);

/// Likewise for the straight line between two points; closes the gaps that tolerances leave
/// between the paths of a loop.
int ray_crossings(const Vec2& from, const Vec2& to, const Vec2& point);

/// What the path adds to the area of a loop, to the left positive: 1/2 integral of
/// (x - x0) dy - (y - y0) dx with (x0, y0) = `origin`. Exact to rounding for polynomial curves
/// up to degree 11.
double area_along(const PlanarPath& path, const Vec2& origin);

}  // namespace blossom
