// SPDX-License-Identifier: GPL-3.0-or-later
// Is a triangle mesh a closed surface without self-intersections? By CGAL's Polygon Mesh
// Processing, whose licence is the GPL; this file and everything that links it is GPL too.

#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/math/vec.h"

namespace blossom::cgal {

struct MeshCheck {
  /// Every edge has one or two triangles, which agree on the orientation, and the triangles round
  /// a vertex form one fan. The other answers are for such meshes only.
  bool manifold = false;

  bool closed = false;           ///< no border edge
  int self_intersections = 0;    ///< pairs of triangles that meet beyond what they share
  int degenerate_triangles = 0;  ///< corners on a line, decided exactly
  double volume = 0;             ///< enclosed when closed; negative if the normals point inwards
};

/// points      model units
/// triangles   three different indices of points each, counter-clockwise from outside
/// throws      InvalidInput if an index is out of range or repeated in a triangle, or a
///             coordinate is not finite
/// cost        O(n log n) for n triangles that meet few others
MeshCheck check_mesh(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles);

/// The pairs of triangles that `check_mesh` counts, by their places; none unless the mesh is a
/// manifold.
std::vector<std::array<int, 2>> crossing_triangles(std::span<const Vec3> points,
                                                   std::span<const std::array<int, 3>> triangles);

}  // namespace blossom::cgal
