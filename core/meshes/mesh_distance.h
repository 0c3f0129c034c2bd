// SPDX-License-Identifier: LGPL-2.1-or-later
// How far a mesh of triangles is from another one at worst, between proven bounds.
//
// The distance of points from a triangle is convex, so on a flat facet it is largest at a corner:
// the largest distance of the corners from any one triangle of the other mesh is a bound for the
// facet. The distance of any point is a bound from below. Facets of which more is wanted are
// divided into four, the farthest first.

#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/math/vec.h"

namespace blossom {

/// The largest distance of the points of one set from another set.
struct FarthestPoint {
  double lower = 0;  ///< taken at `point`
  double upper = 0;  ///< no point is farther
  Vec3 point;
  int triangle = -1;  ///< that has the point; -1 if there is none
};

using IndexTriangles = std::span<const std::array<int, 3>>;

/// The largest distance of a mesh's triangles from the other mesh.
///
/// accuracy   the bounds are to be this near, or the upper one below it; model units
/// ask        asked now and then whether to go on; the bounds hold if it ends
/// throws     InvalidInput if the other mesh has no triangle, an index is out of range, or the
///            accuracy is not positive
///
/// Source: Tang, Lee, Kim 2009 (culling by bounds); the bound by one triangle is theirs, too.
FarthestPoint farthest_point(std::span<const Vec3> points, IndexTriangles triangles,
                             std::span<const Vec3> other_points, IndexTriangles others,
                             double accuracy, const std::function<bool()>& ask = {});

}  // namespace blossom
