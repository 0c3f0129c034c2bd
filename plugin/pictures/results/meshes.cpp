// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/results/meshes.h"

#include <algorithm>
#include <array>
#include <compare>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "core/math/index.h"
#include "core/meshes/mesh_facts.h"
#include "core/meshes/smooth_triangles.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::pictures {
namespace {

using meshes::FileMesh;
using meshes::MeshColour;

constexpr Vec3 kOpenSide = {0.93, 0.50, 0.05};
constexpr Vec3 kCrowdedSide = {0.42, 0.13, 0.62};

// The corner k of the triangle t has the number 3 t + k; of those of one group with one point and
// one normal the first is told for each, from the group's first on. By a sort: a map has a node for
// each.
class FirstCorners {
 public:
  FirstCorners(const FileMesh& mesh, const std::vector<CornerNormals>& normals, std::size_t first,
               std::size_t end)
      : mesh_(mesh), normals_(normals), least_(3 * first), first_(3 * (end - first)) {
    std::vector<std::size_t> corners(first_.size());
    std::iota(corners.begin(), corners.end(), least_);
    std::ranges::sort(corners, [this](std::size_t a, std::size_t b) {
      const std::weak_ordering order = compared(a, b);
      return order == 0 ? a < b : order < 0;
    });
    for (std::size_t i = 0, of = 0; i < corners.size(); ++i) {
      if (i == 0 || compared(corners[i], of) != 0) of = corners[i];
      first_[corners[i] - least_] = of;
    }
  }

  std::size_t of(std::size_t corner) const { return first_[corner - least_]; }

 private:
  // Also normals that are no numbers have their place.
  std::weak_ordering compared(std::size_t a, std::size_t b) const {
    std::weak_ordering order = mesh_.triangles[a / 3][a % 3] <=> mesh_.triangles[b / 3][b % 3];
    const Vec3 &m = normals_[a / 3][a % 3], &n = normals_[b / 3][b % 3];
    for (int k = 0; k < 3 && order == 0; ++k) order = std::weak_order(m[k], n[k]);
    return order;
  }

  const FileMesh& mesh_;
  const std::vector<CornerNormals>& normals_;
  std::size_t least_;
  std::vector<std::size_t> first_;
};

// Of one triangle. A corner that is repeated makes none.
std::vector<std::array<int, 2>> lonely_sides(const std::vector<std::array<int, 3>>& triangles) {
  std::vector<std::array<int, 2>> sides, lonely;
  sides.reserve(3 * triangles.size());
  for (const std::array<int, 3>& corners : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
      if (low < high) sides.push_back({low, high});
    }
  std::ranges::sort(sides);
  for (auto at = sides.begin(); at != sides.end();) {
    const auto next = std::find_if(at, sides.end(), [&](const auto& side) { return side != *at; });
    if (next - at == 1) lonely.push_back(*at);
    at = next;
  }
  return lonely;
}

// A point has one place for each of its normals. Sides of one triangle, as places have them, are
// the group's borders and its creases.
PictureMesh picture_mesh(const FileMesh& mesh, const std::vector<CornerNormals>& normals,
                         std::size_t first, std::size_t end, const std::function<void()>& stop) {
  PictureMesh made;
  {
    const FirstCorners firsts(mesh, normals, first, end);
    std::vector<int> places(3 * (end - first));
    for (std::size_t t = first; t < end; ++t) {
      std::array<int, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t corner = 3 * t + k, same = firsts.of(corner);
        int& place = places[same - 3 * first];
        if (same == corner) {
          place = static_cast<int>(made.points.size());
          made.points.push_back(mesh.points[index(mesh.triangles[t][k])]);
          made.normals.push_back(normals[t][k]);
        }
        corners[k] = place;
      }
      made.triangles.push_back(corners);
    }
  }
  stop();
  made.border = lonely_sides(made.triangles);
  return made;
}

Vec3 colour_of(const MeshColour& colour) {
  return Vec3{double(colour[0]), double(colour[1]), double(colour[2])} * (1 / 255.0);
}

}  // namespace

std::vector<PictureFaces> mesh_faces(const FileMesh& mesh, const std::string& name,
                                     const Vec3& colour, double opacity,
                                     const std::function<void()>& stop) {
  const std::vector<CornerNormals> normals =
      corner_normals(mesh.points, mesh.triangles, kUsualCrease, stop);
  std::map<std::optional<MeshColour>, PictureFaces> groups;
  const auto add = [&](const std::string& label, const std::optional<MeshColour>& of,
                       std::size_t first, std::size_t end) {
    if (first == end) return;
    stop();
    PictureFaces& group = groups[of];
    group.meshes.push_back(picture_mesh(mesh, normals, first, end, stop));
    group.labels.push_back((label.empty() ? name : label) + "\n" +
                           reports::counted(end - first, "triangle"));
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

std::vector<PictureLayer> faulty_side_layers(const FileMesh& mesh,
                                             const std::function<void()>& stop) {
  PictureLayer open{"open side", kOpenSide};
  PictureLayer crowded{"side of more than two triangles", kCrowdedSide};
  PictureLayer turned{"side of triangles turned against each other", kCurveColour};
  for (const FaultySide& side : faulty_sides(mesh.points.size(), mesh.triangles, stop)) {
    PictureLayer& layer = side.crowded ? crowded : side.open ? open : turned;
    layer.items.push_back(
        {{mesh.points[index(side.points[0])], mesh.points[index(side.points[1])]}, layer.name});
  }
  return {std::move(open), std::move(crowded), std::move(turned)};
}

Picture mesh_picture(const std::string& input, const FileMesh& mesh, const std::string& subtitle,
                     const std::function<void()>& stop) {
  Picture picture;
  picture.title = reports::short_name(input);
  picture.subtitle = subtitle;
  picture.groups = mesh_faces(mesh, picture.title, kFirstColour, kFirstOpacity, stop);
  picture.layers = faulty_side_layers(mesh, stop);
  return picture;
}

}  // namespace blossom::pictures
