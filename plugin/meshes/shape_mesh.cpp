// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/shape_mesh.h"

#include <algorithm>
#include <array>
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
// Looking for crossings takes longer than meshing; of so many triangles some seconds.
constexpr std::size_t kMaxJudged = 2'000'000;

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

// What is wrong with facets, by the places of their faces.
class FaultSearch {
 public:
  FaultSearch(const MeshedFaces& faces, const std::function<void()>& stop)
      : faces_(faces), stop_(stop) {
    for (std::size_t k = 0; k < faces.numbers.size(); ++k)
      place_of_[faces.numbers[k]] = static_cast<int>(k);
  }

  std::optional<std::map<int, std::size_t>> faults_of(const ShapeFacets& facets) {
    FileMesh mesh;
    std::vector<int> number_of;
    for (std::size_t f = 0; f < facets.faces.size(); ++f)
      for (const std::array<int, 3>& triangle : facets.faces[f].triangles) {
        std::array<int, 3>& made = mesh.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
          made[k] = facets.faces[f].vertices[static_cast<std::size_t>(triangle[k])];
        number_of.push_back(faces_.numbers[f]);
      }
    if (mesh.triangles.size() > kMaxJudged) return {};
    mesh.points = facets.points;
    std::optional<JudgedParts> judged = judged_parts(mesh, number_of, faces_.parts, stop_);
    if (!judged) return {};
    std::map<int, std::size_t> faults;
    for (const auto& [number, count] : judged->crossings.of_face) faults[place_of_[number]] = count;
    for (std::size_t f = 0; f < facets.faces.size(); ++f)
      if (facets.faces[f].folded > 0)
        faults[static_cast<int>(f)] += static_cast<std::size_t>(facets.faces[f].folded);
    seen_.push_back(std::move(judged->crossings));
    return faults;
  }

  const Crossings& crossings(int looked) const { return seen_[static_cast<std::size_t>(looked)]; }

 private:
  const MeshedFaces& faces_;
  const std::function<void()>& stop_;
  std::map<int, int> place_of_;
  std::vector<Crossings> seen_;
};

void tell(const Crossings& crossings, reports::MeshAnswer& answer) {
  answer.crossings = crossings.inside + crossings.between;
  answer.between_parts = crossings.between;
  answer.crossing_faces.assign(crossings.faces.begin(), crossings.faces.end());
  answer.faces_of_one.assign(crossings.faces_inside.begin(), crossings.faces_inside.end());
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

ShapeMesh mesh_of(const std::string& name, const TopoDS_Shape& shape, const MeshedFaces& faces,
                  const std::function<bool()>& ask, const std::function<void()>& stop) {
  FacetOptions wanted = faces.options;
  if (!(wanted.deviation > 0)) wanted.deviation = kSizePart * diagonal_of(shape);
  const auto start = std::chrono::steady_clock::now();
  FaultSearch search(faces, stop);
  ShapeMesh result{
      occt::tessellation(shape, wanted, ask,
                         [&](const ShapeFacets& facets) { return search.faults_of(facets); }),
      {}};
  if (result.made.facets.stopped) return result;
  result.mesh.points = result.made.facets.points;
  result.mesh.triangles = occt::triangles_of(result.made, &result.face_of);
  if (result.mesh.triangles.empty()) throw occt::BadModel(name + ": no face can be meshed");
  result.mesh.groups = groups_of(result.face_of, faces.groups);
  result.answer = reports::answer_of(result.made, shape, faces.numbers, wanted);
  if (result.made.looked >= 0) tell(search.crossings(result.made.looked), result.answer);
  result.answer.points = result.mesh.points.size();
  result.answer.triangles = result.mesh.triangles.size();
  result.answer.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace blossom::meshes
