// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles over the holes of a mesh.
//
// A hole is a ring of sides that one triangle has. Rings that lie in a plane are filled in it,
// several at once where one lies in another, by a constrained Delaunay triangulation. Of all
// triangulations of another ring the one is taken whose largest angle between neighbours, those
// round the hole included, is least, and then its area:
//
//   W(i, j) = min over m of W(i, m) + W(m, j) + w(i, m, j)
//
// No points are added. Source: Barequet, Sharir 1995 (the recursion); Liepa 2003 (the weight).

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/math/vec.h"

namespace blossom {

/// Rings that were filled together: one, or those of a plane that lie in each other.
struct MeshHole {
  std::vector<std::vector<int>> rings;  ///< points; the triangles have their sides in this order
  std::vector<std::array<int, 3>> triangles;
  bool flat = false;
};

struct MeshHoles {
  std::vector<MeshHole> holes;
  /// Open sides that are in no ring, since the way round them meets sides of more than two
  /// triangles, or triangles that are turned against each other.
  std::size_t left_sides = 0;
};

/// Triangles for all holes; with those of the mesh, each side of a ring has two.
///
/// triangles   counter-clockwise from outside
/// ask         asked now and then; may throw to end the work
/// throws      InvalidInput if an index is out of range
/// cost        O(n log n) for n triangles, and O(k^3) for a ring of k sides that is not flat; of
///             more than 300 sides ears are cut off first
MeshHoles fill_mesh_holes(std::span<const Vec3> points,
                          std::span<const std::array<int, 3>> triangles,
                          const std::function<void()>& ask = {});

}  // namespace blossom
