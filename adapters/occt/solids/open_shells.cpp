// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the shells of a tool that is no solid are open.

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include "adapters/occt/faces/face_groups.h"
#include "adapters/occt/solid_trim.h"

namespace blossom::occt {
namespace {

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

// Edges at which faces that hang together end.
std::size_t free_edges(const std::vector<TopoDS_Face>& faces, const FaceGroup& group) {
  TopTools_IndexedMapOfShape edges;
  std::vector<int> uses;
  for (const std::size_t face : group)
    for (TopExp_Explorer it(faces[face], TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(edge) || edge.Orientation() == TopAbs_INTERNAL) continue;
      const auto number = static_cast<std::size_t>(edges.Add(edge)) - 1;
      uses.resize(std::max(uses.size(), number + 1));
      ++uses[number];
    }
  return static_cast<std::size_t>(std::ranges::count(uses, 1));
}

}  // namespace

std::string describe_open_shell(const TrimTool& tool) {
  const std::vector<TopoDS_Shape> faces(tool.faces.begin(), tool.faces.end());
  const std::vector<FaceGroup> shells = groups_over_edges(faces, [](const auto&) { return false; });
  std::size_t open = 0, edges = 0;
  for (const FaceGroup& shell : shells) {
    const std::size_t ends = free_edges(tool.faces, shell);
    open += ends > 0 ? 1 : 0;
    edges += ends;
  }
  if (open == 0) return "its shells close, but not all of them are in solids";
  if (shells.size() == 1) return "its shell is open, at " + counted(edges, "edge");
  return std::to_string(open) + " of its " + counted(shells.size(), "shell") +
         (open == 1 ? " is" : " are") + " open, at " + counted(edges, "edge");
}

}  // namespace blossom::occt
