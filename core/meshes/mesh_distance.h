// SPDX-License-Identifier: LGPL-2.1-or-later
// How far a mesh of triangles is from another one at worst, between proven bounds.
//
// The distance of points from a triangle is convex, so on a flat piece of a facet it is largest at
// a corner: the largest distance of the corners from any one triangle of the other mesh is a bound
// for the piece. The distance of any point is a bound from below. Pieces of which more is wanted
// are divided, the farthest first: by the planes through the sides of the triangle nearest to their
// middle, across it, and in half where that divides nothing. Over a triangle the bound is taken at
// a corner, so that facets are divided about as often as sides of both meshes cross.

#pragma once

#include <array>
#include <functional>
#include <span>

#include "core/base/unbounded.h"
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

struct WantedBounds {
  double accuracy = 0;  ///< the bounds are to be this near, or the upper one below it; model units
  double enough = 0;    ///< an upper bound of at most this is as good
  double too_far = kUnbounded;  ///< a lower bound above this is as good
};

/// The largest distance of a mesh's triangles from the other mesh.
///
/// ask        asked now and then whether to go on; the bounds hold if it ends
/// throws     InvalidInput if the other mesh has no triangle, an index is out of range, or the
///            accuracy is not positive
/// cost       a search for the nearest triangle for each piece: in all about as many as the meshes
///            have triangles and crossings of their sides
///
/// Source: Tang, Lee, Kim 2009 (culling by bounds); the bound by one triangle is theirs, too.
FarthestPoint farthest_point(std::span<const Vec3> points, IndexTriangles triangles,
                             std::span<const Vec3> other_points, IndexTriangles others,
                             const WantedBounds& wanted, const std::function<bool()>& ask = {});

}  // namespace blossom
