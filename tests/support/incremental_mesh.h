// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangle meshes of shapes by Open CASCADE's BRepMesh_IncrementalMesh.

#pragma once

#include <array>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "tests/support/watertight_mesh.h"

namespace blossom::testing {

/// The triangles of meshed faces, one face after the other. Nodes on an edge or a vertex are those
/// of all faces that have it.
class SharedNodes {
 public:
  /// points   the nodes are put at their end
  explicit SharedNodes(std::vector<Vec3>& points) : points_(points) {}

  /// Calls take(corners, nodes, mesh) for each triangle of a face, turned as the face is: its
  /// corners among the points, and its nodes in the face's own mesh.
  ///
  /// returns   false if the face has no mesh
  template <class Take>
  bool for_each_triangle(const TopoDS_Face& face, Take take) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) own = BRep_Tool::Triangulation(face, location);
    if (own.IsNull()) return false;
    std::map<int, int> names;  // of the face's nodes
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      add_edge(TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD)), own, location, names);
    for (int k = 1; k <= own->NbTriangles(); ++k) {
      std::array<int, 3> nodes{}, corners{};
      own->Triangle(k).Get(nodes[0], nodes[1], nodes[2]);
      if (face.Orientation() == TopAbs_REVERSED) std::swap(nodes[1], nodes[2]);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto [found, is_new] = names.try_emplace(nodes[c], 0);
        if (is_new) found->second = point(own->Node(nodes[c]).Transformed(location));
        corners[c] = found->second;
      }
      take(corners, nodes, *own);
    }
    return true;
  }

 private:
  void add_edge(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & own,
                const TopLoc_Location& location, std::map<int, int>& names) {
    const Handle(Poly_PolygonOnTriangulation) line =
        BRep_Tool::PolygonOnTriangulation(edge, own, location);
    if (line.IsNull()) return;
    const int number = edges_.Add(edge), count = line->NbNodes();
    for (int k = 1; k <= count; ++k) {
      const bool at_vertex = k == 1 || k == count || BRep_Tool::Degenerated(edge);
      const TopoDS_Shape vertex = k == 1 ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge);
      const std::pair<int, int> key =
          at_vertex ? std::pair(0, vertices_.Add(vertex)) : std::pair(number, k);
      const auto [found, is_new] = shared_.try_emplace(key, 0);
      if (is_new) found->second = point(own->Node(line->Node(k)).Transformed(location));
      names[line->Node(k)] = found->second;
    }
  }

  int point(const gp_Pnt& p) {
    points_.push_back({p.X(), p.Y(), p.Z()});
    return static_cast<int>(points_.size()) - 1;
  }

  std::vector<Vec3>& points_;
  TopTools_IndexedMapOfShape edges_, vertices_;
  std::map<std::pair<int, int>, int> shared_;  // by the number in an edge; 0 and a vertex
};

/// The mesh of all faces.
/// throws   runtime_error if a face has no triangles
inline Mesh incremental_mesh(const TopoDS_Shape& shape, double deflection) {
  const BRepMesh_IncrementalMesh mesher(shape, deflection);
  Mesh mesh;
  SharedNodes nodes(mesh.points);
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (!nodes.for_each_triangle(TopoDS::Face(it.Current()),
                                 [&](const std::array<int, 3>& corners, const auto&, const auto&) {
                                   mesh.add(corners[0], corners[1], corners[2]);
                                 }))
      throw std::runtime_error("a face has no triangles");
  return mesh;
}

}  // namespace blossom::testing
