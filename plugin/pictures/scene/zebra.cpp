// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/scene/zebra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "plugin/pictures/scene/scene.h"
#include "plugin/pictures/scene/view.h"

namespace blossom::pictures {
namespace {

constexpr int kStripes = 32;  // of half a turn: a choice, some ten pixels each on a ball
constexpr Vec3 kDarkStripe = {0.13, 0.15, 0.19};
constexpr Vec3 kLightStripe = {0.93, 0.94, 0.96};
// Of triangles that look smooth when shaded: a reflection turns twice as far as its normal.
constexpr double kFiner = 0.25;

/// A corner of a part of a triangle.
struct Corner {
  Vec3 point, normal;
  double height = 0;  ///< of the reflection, in widths of a stripe
};

double stripe_height(const Vec3& normal, const Vec3& to_eye, const Vec3& up) {
  const Vec3 reflected = 2 * dot(normal, to_eye) * normal - to_eye;
  return std::asin(std::clamp(dot(reflected, up), -1.0, 1.0)) * kStripes / std::numbers::pi;
}

Corner between(const Corner& a, const Corner& b, double height) {
  const double t = (height - a.height) / (b.height - a.height);
  const Vec3 normal = (1 - t) * a.normal + t * b.normal;
  return {(1 - t) * a.point + t * b.point, norm(normal) > 0 ? unit(normal) : normal, height};
}

// What of a polygon lies above a height, or below it.
std::vector<Corner> cut(const std::vector<Corner>& polygon, double height, bool above) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const bool has_a = above ? a.height >= height : a.height <= height;
    const bool has_b = above ? b.height >= height : b.height <= height;
    if (has_a) kept.push_back(a);
    if (has_a != has_b && a.height != height && b.height != height)
      kept.push_back(between(a, b, height));
  }
  return kept;
}

void add_fan(PictureMesh& mesh, const std::vector<Corner>& polygon) {
  if (polygon.size() < 3) return;
  const int first = static_cast<int>(mesh.points.size());
  for (const Corner& corner : polygon) {
    mesh.points.push_back(corner.point);
    mesh.normals.push_back(corner.normal);
  }
  for (int i = 2; i < static_cast<int>(polygon.size()); ++i)
    mesh.triangles.push_back({first, first + i - 1, first + i});
}

void add_triangle(StripedMesh& made, std::vector<Corner> rest) {
  const auto [least, most] = std::ranges::minmax(rest, {}, &Corner::height);
  const double last = std::ceil(most.height);
  for (double band = std::floor(least.height); band < last; ++band) {
    const bool is_dark = std::fmod(std::abs(band), 2) == 0;
    const bool is_last = band + 1 >= last;
    add_fan(is_dark ? made.dark : made.light, is_last ? rest : cut(rest, band + 1, false));
    if (!is_last) rest = cut(rest, band + 1, true);
  }
  if (least.height == most.height && std::floor(least.height) == last)
    add_fan(std::fmod(std::abs(last), 2) == 0 ? made.dark : made.light, rest);
}

}  // namespace

StripedMesh striped(const PictureMesh& mesh, const Vec3& to_eye, const Vec3& up) {
  StripedMesh made;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec3, 3> points;
    for (std::size_t k = 0; k < 3; ++k)
      points[k] = mesh.points[static_cast<std::size_t>(triangle[k])];
    const Vec3 across = cross(points[1] - points[0], points[2] - points[0]);
    if (!(norm(across) > 0)) continue;
    std::vector<Corner> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& own = mesh.normals[static_cast<std::size_t>(triangle[k])];
      const Vec3 normal = max_norm(own) > 0 ? own : unit(across);
      corners.push_back({points[k], normal, stripe_height(normal, to_eye, up)});
    }
    add_triangle(made, std::move(corners));
  }
  const int first = static_cast<int>(made.dark.points.size());
  made.dark.points.insert(made.dark.points.end(), mesh.points.begin(), mesh.points.end());
  made.dark.normals.insert(made.dark.normals.end(), mesh.normals.begin(), mesh.normals.end());
  for (const auto& [from, to] : mesh.border) made.dark.border.push_back({first + from, first + to});
  made.dark.obstacle = mesh.obstacle;
  return made;
}

void paint_zebra(Picture& picture) {
  const std::vector<SceneMesh> scene = scene_meshes(picture, kFiner);
  const std::vector<Vec3> corners = scene_corners(scene);
  const View view = view_from(scene_direction(picture, corners), corners, Frame{});
  PictureFaces dark{{}, kDarkStripe, 1, "zebra stripes"}, light{{}, kLightStripe};
  for (const SceneMesh& item : scene) {
    StripedMesh made = striped(item.mesh(), -view.forward, view.up);
    const std::vector<std::string>& labels = picture.groups[item.group].labels;
    const std::string label = item.face < labels.size() ? labels[item.face] : std::string();
    for (PictureFaces* group : {&dark, &light}) {
      group->meshes.push_back(std::move(group == &dark ? made.dark : made.light));
      group->labels.push_back(label);
    }
  }
  picture.groups = {std::move(dark), std::move(light)};
  picture.subtitle = "stripes as faces would reflect rows of lamps";
}

}  // namespace blossom::pictures
