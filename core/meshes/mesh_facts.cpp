// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/mesh_facts.h"

#include <algorithm>
#include <string>

#include "core/base/disjoint_sets.h"
#include "core/base/errors.h"
#include "core/math/index.h"

namespace blossom {
namespace {

// A side, its lower point first, and the triangle that has it.
struct SideUse {
  int low, high, triangle;
  bool forward;
};

std::vector<SideUse> side_uses(std::size_t points, std::span<const std::array<int, 3>> triangles) {
  std::vector<SideUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      if (a < 0 || index(a) >= points)
        throw InvalidInput("triangle " + std::to_string(t) + " has corner " + std::to_string(a) +
                           ", but there are " + std::to_string(points) + " points");
      if (a != b) uses.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), a < b});
    }
  std::ranges::sort(uses, {}, [](const SideUse& use) {
    return std::array{use.low, use.high, use.triangle};
  });
  return uses;
}

void add_sides(std::size_t points, std::span<const std::array<int, 3>> triangles,
               MeshFacts& facts) {
  const std::vector<SideUse> uses = side_uses(points, triangles);
  DisjointSets parts(triangles.size());
  for (std::size_t first = 0, end = 0; first < uses.size(); first = end) {
    std::size_t forward = 0;
    for (end = first; end < uses.size() && uses[end].low == uses[first].low &&
                      uses[end].high == uses[first].high;
         ++end) {
      forward += uses[end].forward;
      parts.join(index(uses[end].triangle), index(uses[first].triangle));
    }
    const std::size_t count = end - first;
    const FaultySide side{{uses[first].low, uses[first].high},
                          count % 2 == 1,
                          count > 2,
                          count % 2 == 0 && 2 * forward != count};
    facts.open_sides += side.open;
    facts.crowded_sides += side.crowded;
    facts.turned_sides += side.turned;
    if (side.open || side.crowded || side.turned) facts.faulty_sides.push_back(side);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) facts.parts += parts.find(t) == t;
}

}  // namespace

MeshFacts mesh_facts(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles) {
  MeshFacts facts;
  add_sides(points.size(), triangles, facts);
  // Far from the origin the volumes of its cones cancel.
  const Vec3 apex = points.empty() ? Vec3{} : points.front();
  for (const std::array<int, 3>& t : triangles) {
    const Vec3 a = points[index(t[0])] - apex, b = points[index(t[1])] - apex,
               c = points[index(t[2])] - apex;
    facts.area += 0.5 * norm(cross(b - a, c - a));
    facts.volume += dot(a, cross(b, c)) / 6;
  }
  if (!facts.closed()) facts.volume = 0;
  return facts;
}

}  // namespace blossom
