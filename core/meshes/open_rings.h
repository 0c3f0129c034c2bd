// SPDX-License-Identifier: LGPL-2.1-or-later
// The borders of a mesh. For this room only.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

/// Sides of triangles, numbered 3 t + k for that from corner k of triangle t.
struct MeshSides {
  static constexpr int kOpen = -1;   ///< no other triangle has the side
  static constexpr int kWrong = -2;  ///< more than one has, or one that is turned over

  std::vector<int> across;  ///< of each side the same one of the other triangle, or one of these

  /// throws   InvalidInput if an index is not below `points`
  MeshSides(std::size_t points, std::span<const std::array<int, 3>> triangles);
};

/// A closed way along open sides, by points, against the direction of the triangles beside it.
struct OpenRing {
  std::vector<int> points;
  std::vector<int> sides;  ///< the one that ends at each point, which its triangle begins there
};

struct OpenRings {
  std::vector<OpenRing> rings;  ///< none has a point twice, or less than three
  std::size_t left_sides = 0;   ///< in no ring
};

OpenRings open_rings(std::span<const std::array<int, 3>> triangles, const MeshSides& sides);

}  // namespace blossom
