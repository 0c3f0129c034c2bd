// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_polygons.h"

#include <array>
#include <limits>

#include "core/meshes/polygon_triangles.h"
#include "plugin/meshes/formats/mesh_formats.h"

namespace blossom::meshes {

void refuse_large(std::uint64_t size, std::int64_t vertices, std::uint64_t vertex_bytes,
                  std::int64_t faces, std::uint64_t face_bytes) {
  const std::string counts =
      std::to_string(vertices) + " vertices and " + std::to_string(faces) + " faces";
  if (vertices < 0 || faces < 0) throw BadContent("its header promises " + counts);
  // Each for itself, so that no sum is too large for the type.
  if (static_cast<std::uint64_t>(vertices) > size / vertex_bytes ||
      static_cast<std::uint64_t>(faces) > size / face_bytes)
    throw BadContent("its header promises " + counts + ", more than its " + std::to_string(size) +
                     " bytes can hold: it is cut off or damaged");
  constexpr std::int64_t kMaxCount = std::numeric_limits<int>::max();
  if (vertices > kMaxCount || faces > kMaxCount)
    throw BadContent("has more than " + std::to_string(kMaxCount) + " vertices or faces");
}

void Polygons::add(std::span<const std::int64_t> corners) {
  if (corners.size() < 3)
    throw BadContent(place_() + "a face has " + std::to_string(corners.size()) + " corners");
  for (const std::int64_t corner : corners)
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= mesh_.points.size())
      throw BadContent(place_() + "a face names a vertex that is not there");
  first_ = mesh_.triangles.size();
  corners_.assign(corners.begin(), corners.end());
  if (corners_.size() == 3) {
    mesh_.triangles.push_back({corners_[0], corners_[1], corners_[2]});
    return;
  }
  const std::vector<std::array<int, 3>> made = polygon_triangles(mesh_.points, corners_);
  mesh_.triangles.insert(mesh_.triangles.end(), made.begin(), made.end());
}

void Polygons::colour(const std::optional<MeshColour>& colour) {
  any_ = any_ || colour.has_value();
  if (coloured_.empty() || coloured_.back().colour != colour)
    coloured_.push_back({"", first_, colour});
}

void Polygons::make_groups_of_colours() {
  if (any_) mesh_.groups = coloured_;
}

}  // namespace blossom::meshes
