// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/results/mesh_answers.h"

#include <cstddef>
#include <numeric>
#include <utility>

#include "core/math/index.h"
#include "plugin/meshes/mesh_parts.h"
#include "plugin/pictures/results/meshes.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"
#include "plugin/reports/text/number_text.h"

namespace blossom::pictures {
namespace {

using reports::counted;
using reports::number_text;
using reports::rounded;
using reports::short_name;

std::vector<Vec3> ring_of(const meshes::FileMesh& mesh, int triangle) {
  std::vector<Vec3> ring;
  for (const std::size_t k : {0u, 1u, 2u, 0u})
    ring.push_back(mesh.points[index(mesh.triangles[index(triangle)][k])]);
  return ring;
}

PictureLayer curve_layer(const std::vector<meshes::MeshPolyline>& curves, const std::string& name) {
  PictureLayer layer{name, kCurveColour};
  for (const meshes::MeshPolyline& curve : curves)
    layer.items.push_back({curve.points, name + "\n" + (curve.closed ? "closed" : "open") +
                                             ", length " + number_text(rounded(curve.length))});
  return layer;
}

PictureLayer point_layer(const std::vector<Vec3>& points) {
  PictureLayer layer{"point in common", kTouchColour, LayerStyle::Dot};
  for (const Vec3& point : points) layer.items.push_back({{point}, layer.name});
  return layer;
}

}  // namespace

Picture mesh_check_picture(const std::string& input, const meshes::FileMesh& mesh,
                           const meshes::JudgedMesh& found, const std::function<void()>& stop) {
  Picture picture = mesh_picture(input, mesh, found.sound() ? "sound" : "not sound", stop);
  PictureLayer crossing{"triangle that crosses another", kCurveColour};
  for (const std::array<int, 2>& pair : found.crossing_pairs)
    for (const std::size_t k : {0u, 1u})
      crossing.items.push_back({ring_of(mesh, pair[k]), "triangle " + std::to_string(pair[k] + 1) +
                                                            " crosses triangle " +
                                                            std::to_string(pair[1 - k] + 1)});
  picture.layers.push_back(std::move(crossing));
  if (found.crossings > found.crossing_pairs.size())
    picture.facts.push_back("shown are the first " + std::to_string(found.crossing_pairs.size()) +
                            " of " + counted(found.crossings, "pair") + " of triangles that cross");
  return picture;
}

Picture mesh_pair_picture(const meshes::MeshPair& pair,
                          const std::array<const meshes::MeshSource*, 2>& inputs,
                          const std::function<void()>& stop) {
  Picture picture;
  picture.title = short_name(pair.a) + " x " + short_name(pair.b);
  picture.subtitle = to_string(pair.status()) + std::string(", ") + counted_curves(pair.found);
  for (const std::size_t k : {0u, 1u})
    for (PictureFaces& group : mesh_faces(inputs[k]->mesh(), short_name(inputs[k]->name()),
                                          k == 0 ? kFirstColour : kSecondColour,
                                          k == 0 ? kFirstOpacity : kSecondOpacity, stop))
      picture.groups.push_back(std::move(group));
  picture.layers = {curve_layer(pair.found.curves, "intersection"), point_layer(pair.found.points)};
  return picture;
}

Picture mesh_sections_picture(const std::string& input, const meshes::FileMesh& mesh,
                              const std::vector<meshes::PlaneOfMesh>& planes,
                              const std::function<void()>& stop) {
  Picture picture;
  picture.title = short_name(input);
  picture.subtitle = counted(planes.size(), "plane");
  picture.groups = mesh_faces(mesh, picture.title, kFirstColour, kSecondOpacity, stop);
  for (const meshes::PlaneOfMesh& plane : planes) {
    picture.layers.push_back(curve_layer(plane.found.curves, plane.name));
    picture.layers.push_back(point_layer(plane.found.points));
  }
  return picture;
}

Picture mesh_fill_picture(const std::string& input, const meshes::FilledMesh& filled,
                          const std::function<void()>& stop) {
  const meshes::FileMesh& mesh = filled.mesh;
  Picture picture;
  picture.title = short_name(input);
  picture.subtitle = counted(filled.holes.size(), "hole") + " filled";
  // What fills the holes is its last group.
  const std::size_t first = filled.holes.empty() ? mesh.triangles.size() : mesh.groups.back().first;
  std::vector<std::size_t> old(first), filling(mesh.triangles.size() - first);
  std::iota(old.begin(), old.end(), std::size_t{0});
  std::iota(filling.begin(), filling.end(), first);
  picture.groups =
      mesh_faces(meshes::chosen_triangles(mesh, old), picture.title, kFirstColour, 1, stop);
  for (PictureFaces& group :
       mesh_faces(meshes::chosen_triangles(mesh, filling), "fill", kTouchColour, 1, stop))
    picture.groups.push_back(std::move(group));
  picture.layers = faulty_side_layers(mesh, stop);
  return picture;
}

}  // namespace blossom::pictures
