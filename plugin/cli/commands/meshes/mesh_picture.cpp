// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/meshes/mesh_picture.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "core/math/index.h"
#include "core/meshes/smooth_triangles.h"
#include "plugin/cli/output/output.h"

namespace blossom::cli {
namespace {

using meshes::FileMesh;
using meshes::MeshColour;

constexpr Vec3 kOpenSide = {0.93, 0.50, 0.05};
constexpr Vec3 kCrowdedSide = {0.42, 0.13, 0.62};

// A point has one place for each of its normals. Sides of one triangle, as places have them, are
// the mesh's borders and its creases.
PictureMesh picture_mesh(const FileMesh& mesh, const std::vector<CornerNormals>& normals,
                         std::size_t first, std::size_t end) {
  PictureMesh made;
  std::map<std::pair<int, std::array<double, 3>>, int> places;
  std::map<std::array<int, 2>, int> uses;
  for (std::size_t t = first; t < end; ++t) {
    std::array<int, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int point = mesh.triangles[t][k];
      const Vec3& normal = normals[t][k];
      const auto [at, is_new] =
          places.try_emplace({point, normal.coordinates}, static_cast<int>(made.points.size()));
      corners[k] = at->second;
      if (!is_new) continue;
      made.points.push_back(mesh.points[index(point)]);
      made.normals.push_back(normal);
    }
    made.triangles.push_back(corners);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
      ++uses[{low, high}];
    }
  }
  for (const auto& [side, count] : uses)
    if (count == 1) made.border.push_back(side);
  return made;
}

Vec3 colour_of(const MeshColour& colour) {
  return Vec3{double(colour[0]), double(colour[1]), double(colour[2])} * (1 / 255.0);
}

}  // namespace

std::vector<PictureFaces> mesh_faces(const FileMesh& mesh, const std::string& name,
                                     const Vec3& colour, double opacity) {
  const std::vector<CornerNormals> normals =
      corner_normals(mesh.points, mesh.triangles, kUsualCrease);
  std::map<std::optional<MeshColour>, PictureFaces> groups;
  const auto add = [&](const std::string& label, const std::optional<MeshColour>& of,
                       std::size_t first, std::size_t end) {
    if (first == end) return;
    PictureFaces& group = groups[of];
    group.meshes.push_back(picture_mesh(mesh, normals, first, end));
    group.labels.push_back((label.empty() ? name : label) + "\n" +
                           counted(end - first, "triangle"));
  };
  const std::size_t all = mesh.triangles.size();
  add({}, {}, 0, mesh.groups.empty() ? all : mesh.groups.front().first);
  for (std::size_t g = 0; g < mesh.groups.size(); ++g)
    add(mesh.groups[g].name, mesh.groups[g].colour, mesh.groups[g].first,
        g + 1 < mesh.groups.size() ? mesh.groups[g + 1].first : all);
  std::vector<PictureFaces> made;
  for (auto& [of, group] : groups) {
    group.colour = of ? colour_of(*of) : colour;
    group.opacity = opacity;
    if (!of) group.name = name;
    made.push_back(std::move(group));
  }
  return made;
}

std::vector<PictureLayer> faulty_side_layers(const FileMesh& mesh, const MeshFacts& facts) {
  PictureLayer open{"open side", kOpenSide};
  PictureLayer crowded{"side of more than two triangles", kCrowdedSide};
  PictureLayer turned{"side of triangles turned against each other", kCurveColour};
  for (const FaultySide& side : facts.faulty_sides) {
    PictureLayer& layer = side.crowded ? crowded : side.open ? open : turned;
    layer.items.push_back(
        {{mesh.points[index(side.points[0])], mesh.points[index(side.points[1])]}, layer.name});
  }
  return {std::move(open), std::move(crowded), std::move(turned)};
}

}  // namespace blossom::cli
