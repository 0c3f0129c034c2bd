// SPDX-License-Identifier: LGPL-2.1-or-later
// What a mesh of triangles is: whether it is closed, in how many parts, and what it encloses.

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/math/vec.h"

namespace blossom {

/// A side whose triangles do not close the mesh there, or are more than two.
struct FaultySide {
  std::array<int, 2> points;  ///< the lesser one first
  bool open = false;          ///< of one triangle alone, or an odd number
  bool crowded = false;       ///< of more than two
  bool turned = false;        ///< of two, or an even number, that not half go round each way

  bool operator==(const FaultySide&) const = default;
};

struct MeshFacts {
  std::size_t open_sides = 0, crowded_sides = 0, turned_sides = 0;
  std::size_t parts = 0;  ///< connected by sides
  double area = 0;
  /// Enclosed where the mesh is closed, negative if it is turned inside out; to rounding.
  double volume = 0;

  /// All sides are gone along as often one way as the other; bodies may share a side.
  bool closed() const { return open_sides == 0 && turned_sides == 0; }
};

/// points      model units
/// triangles   three indices of points each, counter-clockwise from outside
/// throws      InvalidInput if an index is out of range
/// ask         asked now and then; may throw to end the work
/// cost        O(n log n) for n triangles
MeshFacts mesh_facts(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles,
                     const std::function<void()>& ask = {});

/// All that mesh_facts counts, by their points; to draw them. See mesh_facts.
std::vector<FaultySide> faulty_sides(std::size_t points,
                                     std::span<const std::array<int, 3>> triangles,
                                     const std::function<void()>& ask = {});

}  // namespace blossom
