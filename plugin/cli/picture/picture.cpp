// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/picture/picture.h"

#include <algorithm>
#include <cmath>

#include "plugin/cli/picture/canvas.h"
#include "plugin/cli/picture/mesh.h"
#include "plugin/cli/picture/png.h"
#include "plugin/cli/picture/view.h"

namespace blossom::cli {
namespace {

constexpr double kDeflection = 5e-4;   // of the scene's size: below a pixel
constexpr double kLift = 4e-3;         // of the frame's width: lines on a face are before it
constexpr double kCurveWidth = 4.5;    // pixels
constexpr double kOutlineWidth = 1.2;  // pixels
constexpr double kPointWidth = 11;     // pixels
constexpr Vec3 kOutlineColour = {0.22, 0.26, 0.32};

struct ColouredMesh {
  PictureMesh mesh;
  Vec3 colour;
  double opacity = 1;
};

std::vector<ColouredMesh> meshes_of(const Picture& picture) {
  double size = 0;
  for (const PictureFaces& group : picture.groups) size = std::max(size, size_of(group.faces));
  std::vector<ColouredMesh> meshes;
  for (const PictureFaces& group : picture.groups)
    for (const TopoDS_Face& face : group.faces)
      meshes.push_back({picture_mesh(face, kDeflection * size), group.colour, group.opacity});
  return meshes;
}

View view_of(const Picture& picture, const std::vector<ColouredMesh>& meshes) {
  std::vector<Vec3> corners;
  for (const ColouredMesh& item : meshes)
    for (const auto& triangle : item.mesh.triangles)
      for (const int i : triangle) corners.push_back(item.mesh.points[static_cast<std::size_t>(i)]);
  auto lines = picture.curves;
  for (const PictureCurve& curve : picture.coloured) lines.push_back(curve.points);
  for (const Vec3& point : picture.points) lines.push_back({point});
  return chosen_view(corners, lines, picture.width * kSamples, picture.height * kSamples);
}

// A lamp above the left shoulder, a little light from everywhere, a soft highlight.
Vec3 shaded(const Vec3& colour, Vec3 normal, const View& view) {
  const Vec3 to_eye = -view.forward;
  if (dot(normal, to_eye) < 0) normal = -normal;
  const Vec3 lamp = unit(0.45 * view.up - 0.35 * view.right + 0.8 * to_eye);
  const double lit = std::max(0.0, dot(normal, lamp));
  const double shine = std::pow(std::max(0.0, dot(normal, unit(lamp + to_eye))), 40.0);
  return (0.5 + 0.55 * lit) * colour + 0.16 * shine * Vec3{1, 1, 1};
}

void add_mesh(Canvas& canvas, const ColouredMesh& item, const View& view) {
  const PictureMesh& mesh = item.mesh;
  for (const auto& triangle : mesh.triangles) {
    CanvasTriangle out;
    out.opacity = item.opacity;
    const auto point = [&](int k) {
      return mesh.points[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
    };
    const Vec3 flat = unit(cross(point(1) - point(0), point(2) - point(0)));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = static_cast<std::size_t>(triangle[k]);
      const bool has_normal = max_norm(mesh.normals[i]) > 0;
      out.corners[k] = view(mesh.points[i]);
      out.colours[k] = shaded(item.colour, has_normal ? mesh.normals[i] : flat, view);
    }
    canvas.triangles.push_back(out);
  }
}

CanvasLine line_of(const std::vector<Vec3>& points, const View& view, double lift) {
  CanvasLine line;
  for (const Vec3& point : points) line.points.push_back(view(point));
  if (line.points.size() == 1) line.points.push_back(line.points.front());
  line.lift = lift;
  return line;
}

}  // namespace

Image picture_image(const Picture& picture) {
  const std::vector<ColouredMesh> meshes = meshes_of(picture);
  const View view = view_of(picture, meshes);
  const double lift = kLift * picture.width * kSamples;

  Canvas canvas{picture.width, picture.height, {}, {}};
  for (const ColouredMesh& item : meshes) add_mesh(canvas, item, view);
  for (const ColouredMesh& item : meshes)
    for (const auto& outline : item.mesh.outlines) {
      canvas.lines.push_back(line_of(outline, view, lift / 2));
      canvas.lines.back().colour = kOutlineColour;
      canvas.lines.back().width = kOutlineWidth * kSamples;
      canvas.lines.back().hidden = 0.12;
    }
  const auto add_thick = [&](const std::vector<Vec3>& points, double width, const Vec3& colour) {
    if (points.empty()) return;
    canvas.lines.push_back(line_of(points, view, lift));
    canvas.lines.back().colour = colour;
    canvas.lines.back().width = width * kSamples;
    canvas.lines.back().hidden = 0.45;
  };
  for (const auto& curve : picture.curves) add_thick(curve, kCurveWidth, kCurveColour);
  for (const PictureCurve& curve : picture.coloured)
    add_thick(curve.points, kCurveWidth, curve.colour);
  for (const Vec3& point : picture.points) add_thick({point}, kPointWidth, kCurveColour);
  return drawn(canvas);
}

std::string picture_png(const Picture& picture) { return png_bytes(picture_image(picture)); }

}  // namespace blossom::cli
