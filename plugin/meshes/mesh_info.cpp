// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/mesh_info.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "core/bounds/box_tree.h"
#include "core/math/index.h"
#include "plugin/meshes/formats/place_numbers.h"
#include "plugin/meshes/mesh_judge.h"
#include "plugin/reports/text/number_text.h"

namespace blossom::meshes {
namespace {

using reports::counted;
using reports::Json;

// Of the triangles: points of a file that none has are not counted.
Box box_of_triangles(const FileMesh& mesh) {
  Box box;
  for (const std::array<int, 3>& triangle : mesh.triangles)
    for (const int corner : triangle)
      box = joined(box, {mesh.points[index(corner)], mesh.points[index(corner)]});
  return box;
}

std::size_t end_of(const FileMesh& mesh, std::size_t group) {
  return group + 1 < mesh.groups.size() ? mesh.groups[group + 1].first : mesh.triangles.size();
}

Json groups_json(const FileMesh& mesh) {
  Json groups = Json::array();
  for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
    const MeshGroup& group = mesh.groups[g];
    groups.push_back({{"name", group.name}, {"triangles", end_of(mesh, g) - group.first}});
    if (group.colour) groups.back()["colour"] = *group.colour;
  }
  return groups;
}

std::string groups_text(const FileMesh& mesh) {
  std::ostringstream text;
  for (std::size_t g = 0; g < mesh.groups.size(); ++g)
    text << std::setw(6) << g + 1 << "  " << mesh.groups[g].name << ", "
         << counted(end_of(mesh, g) - mesh.groups[g].first, "triangle") << "\n";
  return text.str();
}

constexpr int kDigits = 6;      // of a box's size that its corners have
constexpr int kAllDigits = 17;  // of a number

// Far from the origin corners need more digits than the box's size has.
int digits_for(const Box& box) {
  double largest = 0;
  for (int k = 0; k < 3; ++k)
    largest = std::max({largest, std::abs(box.low[k]), std::abs(box.high[k])});
  const double more = std::ceil(std::log10(largest / diagonal(box)));
  return more > 0 ? static_cast<int>(std::min<double>(kDigits + more, kAllDigits)) : kDigits;
}

std::string corner_text(const Vec3& corner, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << "[" << corner[0] << ", " << corner[1] << ", " << corner[2] << "]";
  return text.str();
}

}  // namespace

MeshFacts facts_of(const FileMesh& mesh, const std::function<void()>& ask) {
  return mesh_facts(mesh.points, mesh.triangles, ask);
}

Json mesh_info_report(const std::string& file, const FileMesh& mesh, const MeshFacts& facts) {
  const Box box = box_of_triangles(mesh);
  return {{"schema", "blossom.mesh-info/1"},
          {"file", file},
          {"points", mesh.points.size()},
          {"triangles", mesh.triangles.size()},
          {"parts", facts.parts},
          {"closed", facts.closed()},
          {"open_sides", facts.open_sides},
          {"non_manifold_sides", facts.crowded_sides},
          {"turned_sides", facts.turned_sides},
          {"area", facts.area},
          {"volume", facts.closed() ? Json(facts.volume) : Json(nullptr)},
          {"box", {box.low.coordinates, box.high.coordinates}},
          {"groups", groups_json(mesh)},
          {"notes", mesh.notes}};
}

std::string enclosed_text(const MeshFacts& facts) {
  std::ostringstream text;
  text.precision(12);
  if (facts.closed())
    text << "closed, volume " << facts.volume;
  else
    text << "not closed, area " << facts.area;
  return text.str();
}

std::string loose_text(const FileMesh& mesh, const MeshFacts& facts) {
  if (facts.open_sides == 0) return "";
  std::vector<Vec3> points;
  PlaceNumbers places(points);
  for (const Vec3& point : mesh.points) places.number(point);
  if (const std::size_t others = mesh.points.size() - points.size(); others > 0)
    return "  " + counted(others, "point") + (others == 1 ? " lies" : " lie") +
           " where others are: triangles that meet there have no side in common\n";
  const std::size_t triangles = mesh.triangles.size();
  if (triangles < 2 || facts.parts < triangles) return "";
  return "  no two triangles have a side in common: where they meet, their points differ\n";
}

std::string mesh_info_text(const std::string& file, const FileMesh& mesh, const MeshFacts& facts,
                           bool groups) {
  const Box box = box_of_triangles(mesh);
  std::ostringstream text;
  text.precision(12);
  text << file << "\n  " << counted(mesh.triangles.size(), "triangle") << ", "
       << counted(mesh.points.size(), "point") << ", " << counted(facts.parts, "part");
  if (!mesh.groups.empty()) text << ", " << counted(mesh.groups.size(), "group");
  text << "\n  " << enclosed_text(facts);
  if (facts.closed()) text << ", area " << facts.area;
  if (facts.closed() && facts.volume < 0) text << ", turned inside out";
  const int digits = digits_for(box);
  text << "\n  box: " << corner_text(box.low, digits) << " to " << corner_text(box.high, digits)
       << "\n";
  const auto line = [&](std::size_t count, const char* what) {
    if (count > 0) text << "  " << counted(count, "side") << " " << what << "\n";
  };
  line(facts.open_sides, "of one triangle, or an odd number");
  line(facts.crowded_sides, "of more than two triangles");
  line(facts.turned_sides, "whose triangles are turned against each other");
  return text.str() + loose_text(mesh, facts) + (groups ? groups_text(mesh) : "") +
         notes_text(mesh);
}

}  // namespace blossom::meshes
