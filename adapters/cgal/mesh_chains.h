// SPDX-License-Identifier: LGPL-2.1-or-later
// Polylines made of the pieces that single triangles have of them. For this folder only.

#pragma once

#include <array>
#include <vector>

#include "adapters/cgal/mesh_intersection.h"
#include "core/math/vec.h"

namespace blossom::cgal {

/// What tells a node of polylines from all others: a side of one mesh and a triangle of another.
using NodeKey = std::array<int, 3>;

/// A piece within a triangle, or a pair of triangles.
struct MeshPiece {
  NodeKey from, to;
};

/// Nodes of a mesh's polylines, sorted, with the pieces between them as places in them.
struct MeshNodes {
  std::vector<NodeKey> keys;
  std::vector<std::array<int, 2>> pieces;
};

MeshNodes numbered(const std::vector<MeshPiece>& pieces);

/// Pieces chained through nodes that have two of them; equal neighbours become one point, and a
/// chain of no length a lone point.
///
/// places   of the nodes, model units
void chain(const MeshNodes& nodes, const std::vector<Vec3>& places, MeshMeeting& found);

/// Whether both have the same curves by number, closedness, length and place, within rounding.
bool have_equal_curves(const MeshMeeting& a, const MeshMeeting& b);

}  // namespace blossom::cgal
