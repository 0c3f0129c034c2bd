// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangle meshes of shapes by Open CASCADE's BRepMesh_IncrementalMesh.

#pragma once

#include <map>
#include <stdexcept>
#include <utility>

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

/// The mesh of all faces. Nodes on an edge or a vertex are those of all faces that have it.
class IncrementalMesh {
 public:
  /// throws   runtime_error if a face has no triangles
  IncrementalMesh(const TopoDS_Shape& shape, double deflection) {
    const BRepMesh_IncrementalMesh mesher(shape, deflection);
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      add(TopoDS::Face(it.Current()));
  }

  const Mesh& mesh() const { return mesh_; }

 private:
  void add(const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) own = BRep_Tool::Triangulation(face, location);
    if (own.IsNull()) throw std::runtime_error("a face has no triangles");
    std::map<int, int> names;  // of the face's nodes
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      add_edge(TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD)), own, location, names);
    const auto node = [&](int i) {
      const auto [found, is_new] = names.try_emplace(i, 0);
      if (is_new) found->second = point(own->Node(i).Transformed(location));
      return found->second;
    };
    for (int k = 1; k <= own->NbTriangles(); ++k) {
      int a = 0, b = 0, c = 0;
      own->Triangle(k).Get(a, b, c);
      if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
      mesh_.add(node(a), node(b), node(c));
    }
  }

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
    mesh_.points.push_back({p.X(), p.Y(), p.Z()});
    return static_cast<int>(mesh_.points.size()) - 1;
  }

  Mesh mesh_;
  TopTools_IndexedMapOfShape edges_, vertices_;
  std::map<std::pair<int, int>, int> shared_;  // by the number in an edge; 0 and a vertex
};

}  // namespace blossom::testing
