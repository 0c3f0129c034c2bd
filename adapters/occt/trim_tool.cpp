// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/trim_tool.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <BRepCheck_Shell.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/faces/point_inside.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/queries/solid_rays.h"

namespace blossom::occt {
namespace {

// Whether the solid's faces are turned inwards, by the first line that tells. What cannot be
// converted says so when it is used.
bool is_inside_out(const TopoDS_Solid& solid) try {
  const std::vector<TopoDS_Face> faces = faces_of(solid);
  SolidRays rays(faces, Precision::Confusion());
  for (const TopoDS_Face& face : faces) {
    const std::optional<gp_Pnt> point = point_inside(face);
    if (!point) continue;
    for (const Vec3& direction : kRayDirections)
      if (const auto outwards = rays.leaves({point->X(), point->Y(), point->Z()}, direction))
        return !*outwards;
  }
  return false;
} catch (const std::runtime_error&) {
  return false;
}

// Of a closed solid whose faces are turned differently, or inwards, nothing is inside for sure.
void check_orientation(const TopoDS_Solid& solid) {
  for (TopExp_Explorer shell(solid, TopAbs_SHELL); shell.More(); shell.Next()) {
    BRepCheck_Shell check(TopoDS::Shell(shell.Current()));
    if (check.Orientation() != BRepCheck_NoError)
      throw BadModel("the faces of a solid are not all turned the same way");
  }
  if (is_inside_out(solid)) throw BadModel("a solid is turned inside out");
}

void drop_loose_faces(TrimTool& tool, const TopTools_IndexedMapOfShape& bounding) {
  if (bounding.Extent() == static_cast<int>(tool.faces.size())) return;
  const std::vector<TopoDS_Face> all = std::exchange(tool.faces, {});
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!bounding.Contains(all[i])) continue;
    tool.faces.push_back(all[i]);
    tool.places.push_back(static_cast<int>(i));
  }
  tool.loose = static_cast<int>(all.size() - tool.faces.size());
}

}  // namespace

bool is_closed_solid(const TopoDS_Shape& solid) {
  if (!TopExp_Explorer(solid, TopAbs_FACE).More()) return false;
  TopTools_IndexedMapOfShape edges;
  std::vector<int> uses;
  for (TopExp_Explorer it(solid, TopAbs_EDGE); it.More(); it.Next()) {
    const TopAbs_Orientation turned = it.Current().Orientation();
    const bool bounds = turned == TopAbs_FORWARD || turned == TopAbs_REVERSED;
    if (!bounds || BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) continue;
    const auto number = static_cast<std::size_t>(edges.Add(it.Current())) - 1;
    uses.resize(std::max(uses.size(), number + 1));
    ++uses[number];
  }
  return std::ranges::all_of(uses, [](int count) { return count > 1; });
}

TrimTool trim_tool(const TopoDS_Shape& shape) {
  TrimTool tool;
  TopTools_IndexedMapOfShape bounding;
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) {
    if (!is_closed_solid(it.Current())) continue;
    check_orientation(TopoDS::Solid(it.Current()));
    TopExp::MapShapes(it.Current(), TopAbs_FACE, bounding);
    tool.solids.push_back(TopoDS::Solid(it.Current()));
  }
  tool.faces = faces_of(shape);
  if (tool.faces.empty() && !shape.IsNull() && TopExp_Explorer(shape, TopAbs_VERTEX).More())
    tool.wires = shape;
  if (tool.is_solid()) drop_loose_faces(tool, bounding);
  return tool;
}

std::string face_name(const TrimTool& of, std::size_t face, const std::string& owner) {
  if (!of.face_names.empty()) return of.face_names[face];
  const int place = of.places.empty() ? static_cast<int>(face) : of.places[face];
  return "face " + std::to_string(place + 1) + " of " + owner;
}

std::string describe_loose_faces(const TrimTool& tool, const std::string& name) {
  if (tool.loose == 0) return {};
  return std::to_string(tool.loose) + (tool.loose == 1 ? " face of " : " faces of ") + name +
         (tool.loose == 1 ? " is" : " are") + " in no closed solid and left out";
}

TrimTool solid_tool(const std::vector<TopoDS_Solid>& solids) {
  TopTools_IndexedMapOfShape faces;
  for (const TopoDS_Solid& solid : solids) TopExp::MapShapes(solid, TopAbs_FACE, faces);
  TrimTool tool;
  for (int i = 1; i <= faces.Extent(); ++i) tool.faces.push_back(TopoDS::Face(faces(i)));
  tool.solids = solids;
  return tool;
}

}  // namespace blossom::occt
