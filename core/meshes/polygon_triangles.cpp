// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/meshes/polygon_triangles.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/base/errors.h"
#include "core/math/index.h"
#include "core/regions/delaunay/constrained_delaunay.h"

namespace blossom {
namespace {

using PolygonCorners = std::span<const int>;
using PolygonTriangles = std::vector<std::array<int, 3>>;

Vec3 across_fan(std::span<const Vec3> points, PolygonCorners corners, std::size_t k) {
  const Vec3& a = points[index(corners[0])];
  return cross(points[index(corners[k - 1])] - a, points[index(corners[k])] - a);
}

// Twice the polygon's area, along its normal.
Vec3 across_polygon(std::span<const Vec3> points, PolygonCorners corners) {
  Vec3 sum;
  for (std::size_t k = 2; k < corners.size(); ++k) sum += across_fan(points, corners, k);
  return sum;
}

PolygonTriangles fan_of(PolygonCorners corners) {
  PolygonTriangles made;
  for (std::size_t k = 2; k < corners.size(); ++k)
    made.push_back({corners[0], corners[k - 1], corners[k]});
  return made;
}

// The polygon without the coordinate in which its normal is longest: no number is rounded.
std::vector<Vec2> places_of(std::span<const Vec3> points, PolygonCorners corners,
                            const Vec3& across) {
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(across[k]) > std::abs(across[axis])) axis = k;
  int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (across[axis] < 0) std::swap(x, y);
  std::vector<Vec2> places;
  for (const int corner : corners)
    places.push_back({points[index(corner)][x], points[index(corner)][y]});
  return places;
}

std::optional<PolygonTriangles> delaunay(std::vector<Vec2> places, PolygonCorners corners) {
  const int count = static_cast<int>(places.size());
  try {
    ConstrainedDelaunay mesh(std::move(places));
    SideWindings windings;
    for (int k = 0; k < count; ++k) {
      const int to = (k + 1) % count;
      std::pair<int, int> obstacle;
      if (!mesh.fix(k, to, obstacle)) return {};
      ++windings[{k, to}];
      --windings[{to, k}];
    }
    if (!mesh.mark_region(windings)) return {};
    PolygonTriangles made;
    for (const ConstrainedDelaunay::Face& face : mesh.faces())
      if (face.inside)
        made.push_back({corners[index(face.corner[0])], corners[index(face.corner[1])],
                        corners[index(face.corner[2])]});
    return made;
  } catch (const InvalidInput&) {
    return {};  // two corners are at one place, or near the largest number apart
  }
}

}  // namespace

PolygonTriangles polygon_triangles(std::span<const Vec3> points, PolygonCorners corners) {
  if (corners.size() == 3) return fan_of(corners);
  const Vec3 across = across_polygon(points, corners);
  bool is_fan = true;
  for (std::size_t k = 2; k < corners.size(); ++k)
    is_fan = is_fan && dot(across_fan(points, corners, k), across) > 0;
  if (is_fan || !(dot(across, across) > 0)) return fan_of(corners);
  std::optional<PolygonTriangles> made = delaunay(places_of(points, corners, across), corners);
  return made ? *std::move(made) : fan_of(corners);
}

}  // namespace blossom
