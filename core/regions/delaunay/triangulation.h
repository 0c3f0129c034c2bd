// SPDX-License-Identifier: LGPL-2.1-or-later
// A region of the plane between straight borders as triangles: the constrained Delaunay
// triangulation of its borders' ends, without points of its own.

#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/math/vec.h"

namespace blossom {

/// A directed side of the region, which lies on its left; ends are places in the list of points.
struct BorderSide {
  int from = 0;
  int to = 0;

  friend bool operator==(const BorderSide&, const BorderSide&) = default;
};

struct Triangulation {
  /// Counter-clockwise, of the region alone; every side of the region is a side of one of them.
  std::vector<std::array<int, 3>> triangles;
  /// Sides that cross another one, pass through a point or join the same points as another: the
  /// region is no region then, and there are no triangles.
  std::vector<int> conflicts;
  /// False if the sides cross nowhere but do not enclose a region: loops are open, turn the wrong
  /// way or lie one in another. There are no triangles then.
  bool consistent = true;
};

/// Triangulates a region with any number of loops, holes and parts, which may touch at points.
///
/// points     those that no side has are left out
/// sides      they meet only at points; a side and its reverse are no conflict: they cancel
/// throws     InvalidInput if an index is out of range, a side has equal ends, a coordinate is not
///            finite, or two points that sides use are equal
/// cost       O(n^(3/2)) for points in good order, O(n^2) at worst
///
/// Source: de Berg et al. 2008, chapter 9; sides are forced in by flips as in Sloan 1993.
Triangulation triangulate(std::span<const Vec2> points, std::span<const BorderSide> sides);

}  // namespace blossom
