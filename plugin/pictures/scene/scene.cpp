// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/scene/scene.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <Bnd_Box.hxx>

#include "adapters/occt/convert/hulls.h"
#include "plugin/pictures/scene/view.h"
#include "plugin/reports/text/json.h"

namespace blossom::pictures {
namespace {

// How far triangles may be off, in pixels of a picture whose frame the box of the scene fills: the
// box may be three times as wide as what is in it, so that the picture shows less than a pixel.
constexpr double kPixels = 0.25;
constexpr double kAngle = 0.2;  // radians between neighbouring triangles: looks smooth when shaded
constexpr double kLargestAngle = 1;  // radians; a full turn keeps six sides

std::vector<Vec3> box_corners(const std::vector<TopoDS_Face>& faces) {
  Bnd_Box box;
  for (const TopoDS_Face& face : faces) box.Add(occt::bounds_of(face));
  std::vector<Vec3> corners;
  if (box.IsVoid()) return corners;
  std::array<Vec3, 2> ends;
  box.Get(ends[0][0], ends[0][1], ends[0][2], ends[1][0], ends[1][1], ends[1][2]);
  for (std::size_t k = 0; k < 8; ++k)
    corners.push_back({ends[k & 1][0], ends[k >> 1 & 1][1], ends[k >> 2][2]});
  return corners;
}

// Of the picture. The direction that no one names is known only when there are triangles; it is
// iso, or one that sees more.
double model_units_per_pixel(const Picture& picture, const std::vector<TopoDS_Face>& faces) {
  const Frame whole = {0, 0, double(picture.width), double(picture.height)};
  const Vec3 to_eye = view_direction(picture.view.empty() ? "iso" : picture.view);
  return 1 / view_from(to_eye, box_corners(faces), whole).scale;
}

}  // namespace

std::vector<SceneMesh> scene_meshes(const Picture& picture, double coarseness) {
  std::vector<TopoDS_Face> faces;
  std::vector<SceneMesh> scene;
  for (std::size_t g = 0; g < picture.groups.size(); ++g)
    for (std::size_t f = 0; f < picture.groups[g].faces.size(); ++f) {
      faces.push_back(picture.groups[g].faces[f]);
      scene.push_back({{}, g, f});
    }
  // A sagitta grows with the square of the length of triangles.
  const double deviation =
      kPixels * model_units_per_pixel(picture, faces) * coarseness * coarseness;
  const double angle = std::min(kAngle * coarseness, kLargestAngle);
  std::vector<PictureMesh> meshes = picture_meshes(faces, deviation, angle);
  for (std::size_t k = 0; k < scene.size(); ++k) scene[k].own = std::move(meshes[k]);
  for (std::size_t g = 0; g < picture.groups.size(); ++g) {
    std::size_t face = picture.groups[g].faces.size();
    for (const PictureMesh& mesh : picture.groups[g].meshes)
      scene.push_back({{}, g, face++, &mesh});
  }
  return scene;
}

std::vector<Vec3> scene_corners(const std::vector<SceneMesh>& meshes) {
  std::vector<Vec3> corners;
  for (const SceneMesh& item : meshes)
    for (const auto& triangle : item.mesh().triangles)
      for (const int i : triangle)
        corners.push_back(item.mesh().points[static_cast<std::size_t>(i)]);
  return corners;
}

Vec3 scene_direction(const Picture& picture, const std::vector<Vec3>& corners) {
  return picture.view.empty() ? default_direction(corners) : view_direction(picture.view);
}

std::vector<std::string> notes_on(const std::vector<SceneMesh>& meshes) {
  std::map<std::string, std::size_t> faces;  // by the cause
  for (const SceneMesh& item : meshes)
    if (!item.mesh().obstacle.empty()) ++faces[item.mesh().obstacle];
  std::vector<std::string> notes;
  for (const auto& [cause, count] : faces)
    notes.push_back("the picture shows " + reports::counted(count, "face") +
                    " by edges alone: " + cause);
  return notes;
}

}  // namespace blossom::pictures
