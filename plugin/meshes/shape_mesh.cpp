// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/shape_mesh.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

#include <Bnd_Box.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/face_colours.h"

namespace blossom::meshes {
namespace {

constexpr double kSizePart = 1e-3;  // of the diagonal, where no deviation is given

double diagonal_of(const TopoDS_Shape& shape) {
  const Bnd_Box box = occt::bounds_of(shape);
  return box.IsVoid() ? 1 : std::sqrt(box.SquareExtent());
}

std::vector<MeshGroup> groups_of(const std::vector<int>& face_of,
                                 const std::vector<MeshGroup>& of_faces) {
  std::vector<MeshGroup> groups;
  for (std::size_t k = 0; k < face_of.size(); ++k)
    if (k == 0 || face_of[k] != face_of[k - 1]) {
      groups.push_back(of_faces[static_cast<std::size_t>(face_of[k])]);
      groups.back().first = k;
    }
  return groups;
}

std::optional<MeshColour> bytes_of(const std::optional<occt::FaceColour>& colour) {
  if (!colour) return {};
  MeshColour made{};
  for (std::size_t k = 0; k < 3; ++k)
    made[k] = static_cast<std::uint8_t>(std::lround(std::clamp((*colour)[k], 0.0, 1.0) * 255));
  return made;
}

// Of each face of a model the number of its part, an instance of an assembly counted each time; 0
// if it is in none. As with names, of two parts that have a face the last one counts.
std::vector<int> part_numbers(const occt::Model& model) {
  std::vector<int> numbers(static_cast<std::size_t>(model.face_count()), 0);
  int parts = 0;
  const auto number = [&](const occt::AssemblyNode& node, const auto& self) -> void {
    if (node.parts.empty()) ++parts;
    for (const int face : node.faces) numbers[static_cast<std::size_t>(face) - 1] = parts;
    for (const occt::AssemblyNode& part : node.parts) self(part, self);
  };
  for (const occt::AssemblyNode& root : model.assembly()) number(root, number);
  return numbers;
}

}  // namespace

std::vector<MeshGroup> face_groups(const reports::Input& input) {
  std::vector<std::string> names;
  std::map<std::string, int> faces;
  for (const std::string& path : input.model.part_paths()) {
    const std::string part = reports::given_name(path);
    names.push_back((part.empty() ? "" : part + "/") + "Face" + std::to_string(++faces[part]));
  }
  const std::vector<std::optional<occt::FaceColour>> colours = occt::face_colours(input.model);
  const std::vector<int> parts = part_numbers(input.model);
  std::vector<MeshGroup> chosen;
  for (const int number : input.numbers) {
    const std::size_t place = static_cast<std::size_t>(number) - 1;
    chosen.push_back({names[place], 0, bytes_of(colours[place]), parts[place]});
  }
  return chosen;
}

ShapeMesh mesh_of(const std::string& name, const TopoDS_Shape& shape,
                  const std::vector<int>& numbers, const std::vector<MeshGroup>& groups,
                  const FacetOptions& options, const std::function<bool()>& ask) {
  FacetOptions wanted = options;
  if (!(wanted.deviation > 0)) wanted.deviation = kSizePart * diagonal_of(shape);
  const auto start = std::chrono::steady_clock::now();
  ShapeMesh result{occt::tessellation(shape, wanted, ask), {}};
  if (result.made.facets.stopped) return result;
  result.mesh.points = result.made.facets.points;
  result.mesh.triangles = occt::triangles_of(result.made, &result.face_of);
  if (result.mesh.triangles.empty()) throw occt::BadModel(name + ": no face can be meshed");
  result.mesh.groups = groups_of(result.face_of, groups);
  result.answer = reports::answer_of(result.made, shape, numbers, wanted);
  result.answer.points = result.mesh.points.size();
  result.answer.triangles = result.mesh.triangles.size();
  result.answer.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace blossom::meshes
