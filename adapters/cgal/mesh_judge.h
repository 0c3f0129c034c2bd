// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with a mesh of triangles, decided exactly by CGAL's kernel: whether it is closed
// and turned one way, which triangles cross, and what it encloses.

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/math/vec.h"
#include "core/meshes/mesh_facts.h"

namespace blossom::cgal {

/// So many pairs are listed: all that is named one by one. Of triangles at one place there are as
/// many as the square of their number.
inline constexpr std::size_t kListedPairs = 1000;

struct MeshVerdict : MeshFacts {
  std::size_t degenerate = 0;  ///< triangles with corners on a line or repeated
  std::size_t crossings = 0;   ///< pairs of triangles that meet beyond what they share
  std::size_t repeated = 0;    ///< of these, pairs with the same corners, turned whichever way
  std::vector<std::array<int, 2>> crossing_pairs{};  ///< the first kListedPairs of them, by place
};

/// Degenerate triangles cross nothing here.
///
/// points      model units
/// triangles   three indices of points each
/// ask         asked now and then; may throw to end the work
/// crossing    called for each pair of `crossings`, the lower place first, in no order
///             Both are called on threads of oneTBB, too, but never by two at once.
/// throws      InvalidInput if an index is out of range or a coordinate is not finite
/// cost        O(n log n) for n triangles that meet few others; memory in proportion to n, however
///             many cross
MeshVerdict judge_mesh(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles,
                       const std::function<void()>& ask = {},
                       const std::function<void(int, int)>& crossing = {});

}  // namespace blossom::cgal
