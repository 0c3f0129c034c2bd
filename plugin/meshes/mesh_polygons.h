// SPDX-License-Identifier: LGPL-2.1-or-later
// Polygons of a file to triangles of a mesh. For this folder only.

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plugin/meshes/mesh_files.h"

namespace blossom::meshes {

/// throws   BadContent if so many do not go into so many bytes, or a number is negative
void refuse_large(std::uint64_t size, std::int64_t vertices, std::uint64_t vertex_bytes,
                  std::int64_t faces, std::uint64_t face_bytes);

class Polygons {
 public:
  /// place    tells of the last polygon where it is, for messages
  explicit Polygons(FileMesh& mesh, std::function<std::string()> place)
      : mesh_(mesh), place_(std::move(place)) {}

  /// A polygon as triangles, see polygon_triangles.
  /// corners  places of points, from 0
  /// throws   BadContent if there are less than three, or one is not there
  void add(std::span<const std::int64_t> corners);
  void colour(const std::optional<MeshColour>& colour);

  /// Neighbours of one colour, where there is any.
  void make_groups_of_colours();

 private:
  FileMesh& mesh_;
  std::function<std::string()> place_;
  std::size_t first_ = 0;  // triangle of the last polygon
  std::vector<int> corners_;
  bool any_ = false;
  std::vector<MeshGroup> coloured_;
};

}  // namespace blossom::meshes
