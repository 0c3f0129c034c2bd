// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_fill.h"

#include <chrono>
#include <sstream>
#include <utility>

#include "core/math/index.h"
#include "core/meshes/mesh_holes.h"
#include "plugin/meshes/formats/place_numbers.h"

namespace blossom::meshes {
namespace {

constexpr std::size_t kNamedHoles = 20;

}  // namespace

FileMesh with_points_joined(FileMesh mesh) {
  std::vector<Vec3> points;
  std::vector<int> number;
  PlaceNumbers places(points);
  for (const Vec3& point : mesh.points) number.push_back(places.number(point));
  const std::size_t others = mesh.points.size() - points.size();
  if (others == 0) return mesh;
  mesh.points = std::move(points);
  for (std::array<int, 3>& triangle : mesh.triangles)
    for (int& corner : triangle) corner = number[index(corner)];
  mesh.notes.push_back(reports::counted(others, "point") + (others == 1 ? " lies" : " lie") +
                       " where others are: points at one place count as one");
  return mesh;
}

FilledMesh with_holes_filled(FileMesh mesh, const std::function<void()>& stop) {
  const auto start = std::chrono::steady_clock::now();
  FilledMesh made{with_points_joined(std::move(mesh)), {}};
  const MeshHoles found = fill_mesh_holes(made.mesh.points, made.mesh.triangles, stop);
  made.left_sides = found.left_sides;
  const std::size_t first = made.mesh.triangles.size();
  for (const MeshHole& hole : found.holes) {
    FilledMesh::Hole& told = made.holes.emplace_back();
    for (const std::vector<int>& ring : hole.rings) told.sides.push_back(ring.size());
    told.triangles = hole.triangles.size();
    told.flat = hole.flat;
    made.mesh.triangles.insert(made.mesh.triangles.end(), hole.triangles.begin(),
                               hole.triangles.end());
  }
  if (made.mesh.triangles.size() > first) {
    if (made.mesh.groups.empty() || made.mesh.groups.front().first > 0)
      made.mesh.groups.insert(made.mesh.groups.begin(), {"mesh", 0});
    made.mesh.groups.push_back({"fill", first});
  }
  made.judged = judged_mesh(made.mesh, stop);
  made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return made;
}

reports::Json mesh_fill_report(const std::string& file, const FilledMesh& filled) {
  using reports::Json;
  Json holes = Json::array();
  for (const FilledMesh::Hole& hole : filled.holes)
    holes.push_back({{"sides", hole.sides}, {"triangles", hole.triangles}, {"flat", hole.flat}});
  const auto& judged = filled.judged;
  return {{"schema", "blossom.mesh-fill/1"},
          {"file", file},
          {"holes", std::move(holes)},
          {"left_sides", filled.left_sides},
          {"triangles", filled.mesh.triangles.size()},
          {"closed", judged ? Json(judged->closed()) : Json(nullptr)},
          {"crossings", judged ? Json(judged->crossings) : Json(nullptr)},
          {"volume", judged && judged->closed() ? Json(judged->volume) : Json(nullptr)},
          {"notes", filled.mesh.notes},
          {"seconds", filled.seconds}};
}

std::string mesh_fill_text(const std::string& file, const FilledMesh& filled) {
  using reports::counted;
  std::ostringstream text;
  text.precision(12);
  text << "filled " << counted(filled.holes.size(), "hole") << " of " << file << "\n";
  std::size_t named = 0;
  for (const FilledMesh::Hole& hole : filled.holes) {
    if (++named > kNamedHoles) break;
    text << "  of ";
    for (std::size_t k = 0; k < hole.sides.size(); ++k)
      text << (k > 0 ? " and " : "") << hole.sides[k];
    text << " sides: " << counted(hole.triangles, "triangle") << (hole.flat ? ", flat" : "")
         << "\n";
  }
  if (filled.holes.size() > kNamedHoles)
    text << "  and " << filled.holes.size() - kNamedHoles << " more\n";
  if (filled.left_sides > 0)
    text << "  " << counted(filled.left_sides, "open side")
         << " left: the way round them meets sides of more than two triangles, or triangles that "
            "are turned against each other\n";
  if (filled.judged) {
    text << (filled.judged->closed() ? "  closed now, volume " : "  not closed");
    if (filled.judged->closed()) text << filled.judged->volume;
    text << ", " << counted(filled.judged->crossings, "pair") << " of triangles that cross\n";
    if (filled.judged->turned_sides > 0)
      text << "  " << counted(filled.judged->turned_sides, "side")
           << " whose triangles are turned against each other, which is no hole\n";
  }
  return text.str() + notes_text(filled.mesh);
}

}  // namespace blossom::meshes
