// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/image/drawing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/index.h"
#include "plugin/pictures/image/annotations.h"
#include "plugin/pictures/image/raster/canvas.h"
#include "plugin/pictures/image/raster/png.h"
#include "plugin/pictures/scene/scene.h"
#include "plugin/pictures/scene/view.h"

namespace blossom::pictures {
namespace {

constexpr double kLift = 4e-3;         // of the frame's width: lines on a face are before it
constexpr double kBehind = 1.5e-3;     // of the frame's width: more than triangles leave surfaces
constexpr double kCurveWidth = 4.5;    // pixels
constexpr double kOutlineWidth = 1.2;  // pixels
constexpr double kNetWidth = 1.2;      // pixels
constexpr double kHatchWidth = 1.6;    // pixels
constexpr Vec3 kOutlineColour = {0.22, 0.26, 0.32};

View view_of(const Picture& picture, const std::vector<SceneMesh>& meshes) {
  std::vector<Vec3> points = scene_corners(meshes);
  const Vec3 to_eye = scene_direction(picture, points);
  for (const PictureLayer& layer : all_layers(picture))
    for (const PictureItem& item : layer.items)
      points.insert(points.end(), item.points.begin(), item.points.end());
  Frame frame = free_frame(picture);
  for (double* length : {&frame.left, &frame.top, &frame.width, &frame.height}) *length *= kSamples;
  return view_from(to_eye, points, frame);
}

// A lamp above the left shoulder, a soft highlight, and light from everywhere: enough to know the
// colours of faces that are turned away. As viewer.js has it.
Vec3 shaded(const Vec3& colour, Vec3 normal, const View& view) {
  const Vec3 to_eye = -view.forward;
  if (dot(normal, to_eye) < 0) normal = -normal;
  const Vec3 lamp = unit(0.45 * view.up - 0.35 * view.right + 0.8 * to_eye);
  const double lit = std::max(0.0, dot(normal, lamp));
  const double shine = std::pow(std::max(0.0, dot(normal, unit(lamp + to_eye))), 40.0);
  return (0.62 + 0.43 * lit) * colour + 0.16 * shine * Vec3{1, 1, 1};
}

// Translucent faces that coincide with opaque ones lie behind them, whatever their triangles.
double depth_behind(const Picture& picture, double opacity) {
  return opacity < kFirstOpacity ? kBehind * picture.width * kSamples : 0;
}

void add_mesh(Canvas& canvas, const PictureMesh& mesh, const PictureFaces& look, const View& view,
              double behind) {
  for (const auto& triangle : mesh.triangles) {
    CanvasTriangle out;
    out.opacity = look.opacity;
    const auto point = [&](int k) {
      return mesh.points[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
    };
    const Vec3 flat = unit(cross(point(1) - point(0), point(2) - point(0)));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = static_cast<std::size_t>(triangle[k]);
      const bool has_normal = max_norm(mesh.normals[i]) > 0;
      out.corners[k] = view(mesh.points[i]);
      out.corners[k][2] += behind;
      out.colours[k] = shaded(look.colour, has_normal ? mesh.normals[i] : flat, view);
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

// What of a style's lines is seen behind opaque faces, and how thick they are in pixels.
struct LineLook {
  double width = kCurveWidth;
  double hidden = 0.45;
};

LineLook look_of(LayerStyle style) {
  if (style == LayerStyle::Net) return {kNetWidth, 0.25};
  if (style == LayerStyle::Hatch) return {kHatchWidth, 0.3};
  return {};
}

// A face that is not filled has thick borders in its own colour.
void add_outlines(Canvas& canvas, const Picture& picture, const std::vector<SceneMesh>& meshes,
                  const View& view, double lift) {
  for (const SceneMesh& item : meshes) {
    const bool is_filled = item.mesh().obstacle.empty();
    for (const auto& [from, to] : item.mesh().border) {
      canvas.lines.push_back(
          line_of({item.mesh().points[index(from)], item.mesh().points[index(to)]}, view, lift));
      canvas.lines.back().colour = is_filled ? kOutlineColour : picture.groups[item.group].colour;
      canvas.lines.back().width = (is_filled ? kOutlineWidth : kCurveWidth) * kSamples;
      canvas.lines.back().hidden = 0.12;
    }
  }
}

// Marks are none of the canvas: they are drawn over everything.
void add_layer(Canvas& canvas, const PictureLayer& layer, const View& view, double lift) {
  if (layer.style > LayerStyle::Hatch) return;
  const LineLook look = look_of(layer.style);
  for (const PictureItem& item : layer.items) {
    canvas.lines.push_back(line_of(item.points, view, lift));
    canvas.lines.back().colour = layer.colour;
    canvas.lines.back().width = look.width * kSamples;
    canvas.lines.back().hidden = look.hidden;
  }
}

}  // namespace

Image picture_image(const Picture& picture, const std::vector<SceneMesh>& meshes) {
  const View view = view_of(picture, meshes);
  const double lift = kLift * picture.width * kSamples;
  Canvas canvas{picture.width, picture.height, {}, {}};
  for (const SceneMesh& item : meshes) {
    const PictureFaces& look = picture.groups[item.group];
    add_mesh(canvas, item.mesh(), look, view, depth_behind(picture, look.opacity));
  }
  add_outlines(canvas, picture, meshes, view, lift / 2);
  for (const PictureLayer& layer : all_layers(picture)) add_layer(canvas, layer, view, lift);
  Image image = drawn(canvas);
  annotate(picture, view, image);
  return image;
}

std::string picture_png(const Picture& picture, const std::vector<SceneMesh>& meshes) {
  return png_bytes(picture_image(picture, meshes));
}

}  // namespace blossom::pictures
