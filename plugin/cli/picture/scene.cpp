// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/picture/scene.h"

#include <algorithm>

#include "plugin/cli/picture/view.h"

namespace blossom::cli {
namespace {

constexpr double kDeflection = 5e-4;  // of the scene's size: below a pixel

}  // namespace

std::vector<SceneMesh> scene_meshes(const Picture& picture, double coarseness) {
  double size = 0;
  for (const PictureFaces& group : picture.groups) size = std::max(size, size_of(group.faces));
  std::vector<SceneMesh> meshes;
  for (std::size_t g = 0; g < picture.groups.size(); ++g) {
    const std::vector<TopoDS_Face>& faces = picture.groups[g].faces;
    // A sagitta grows with the square of the length of triangles.
    for (std::size_t f = 0; f < faces.size(); ++f)
      meshes.push_back(
          {picture_mesh(faces[f], kDeflection * size * coarseness * coarseness, coarseness), g, f});
  }
  return meshes;
}

std::vector<Vec3> scene_corners(const std::vector<SceneMesh>& meshes) {
  std::vector<Vec3> corners;
  for (const SceneMesh& item : meshes)
    for (const auto& triangle : item.mesh.triangles)
      for (const int i : triangle) corners.push_back(item.mesh.points[static_cast<std::size_t>(i)]);
  return corners;
}

Vec3 scene_direction(const Picture& picture, const std::vector<Vec3>& corners) {
  return picture.view.empty() ? default_direction(corners) : view_direction(picture.view);
}

}  // namespace blossom::cli
