// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles of a polygon, as files have them.

#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/math/vec.h"

namespace blossom {

/// Triangles that cover a polygon once, turned as it is: a fan from its first corner where every
/// triangle of that goes round as the polygon does; else a constrained Delaunay triangulation of
/// what is seen of it along the axis that is most across to it. The fan, too, if the polygon then
/// crosses itself, touches itself, has no area, or is nearly as large as numbers can be.
///
/// points    model units; of the whole mesh
/// corners   numbers of points, at least 3
/// cost      O(n) for a fan of n corners, else about O(n log n)
std::vector<std::array<int, 3>> polygon_triangles(std::span<const Vec3> points,
                                                  std::span<const int> corners);

}  // namespace blossom
