// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the edges of faces meet a plane: the nodes in which section curves of neighbouring faces
// end together. For the plane section only.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/plane_section.h"
#include "adapters/occt/queries/section_frame.h"
#include "core/curve_surface_intersection.h"

namespace blossom::occt {

class SectionNodes {
 public:
  /// section   gets the nodes, and edges in the plane as curves; lives as long as this
  SectionNodes(const SectionFrame& frame, const IntersectionOptions& options, std::size_t faces,
               PlaneSection& section);

  /// Finds the nodes on the edges of a face; those of an edge of two faces are found once.
  void add_edges(std::size_t index, const TopoDS_Face& face);

  /// Finds the nodes on edges that no face has, and which of these edges lie in the plane.
  void add_loose(const std::vector<TopoDS_Edge>& edges);

  /// The node in which a curve on a face ends: the nearest of the face, if it is near enough for
  /// what is not known of either, or a new one. Farther ones are taken up to `far`, as where an
  /// edge is off its face by more than it says; then, and where there is none, the status is
  /// `tolerance`.
  /// reach    of the curve's end, model units
  int end_node(std::size_t face, const Vec3& point, double reach, double far);

  /// The node of an isolated contact, or of a branching.
  /// reach    how far off it the contact may be, model units
  int contact_node(std::size_t face, const Vec3& point, double reach);

  /// Ends of curves that are left alone, and lie within tolerance of each other, become one node:
  /// faces that meet without sharing an edge.
  void join_free_ends();

  /// Nodes that no curve comes near: there faces only touch the plane.
  std::vector<std::size_t> lone_nodes() const;

  /// Where a curve on a face does not run along edges of it that lie in the plane: intervals of its
  /// parameter, in order. It is cut where such edges end, and each part asked at three points.
  std::vector<Interval> beside_edges(std::size_t face, const IntersectionCurve& curve) const;

 private:
  struct KnownEdge {
    std::vector<int> nodes;
    int curve = -1;        // place in the section's curves, of an edge in the plane
    bool in_part = false;  // whether a part of it lies there
  };

  void drop_joined(const std::vector<int>& becomes);
  KnownEdge known_edge(std::size_t face, const TopoDS_Edge& edge);
  void add_curve(std::size_t face, const TopoDS_Edge& edge, KnownEdge& known);
  void add_points(const TopoDS_Edge& edge, const CurveSurfaceIntersection& found, KnownEdge& known);
  bool lies_on_edge(std::size_t face, const Vec3& point) const;
  int nearest_node(std::size_t face, const Vec3& point) const;
  void weaken(const std::string& reason);
  int new_node(const TopoDS_Shape& on, const Vec3& point, double slack, bool proven);
  bool touches(const TopoDS_Vertex& vertex) const;
  int node_of_vertex(const TopoDS_Vertex& vertex);

  const SectionFrame& frame_;
  const IntersectionOptions& options_;
  double tolerance_;
  PlaneSection& section_;
  TopTools_IndexedMapOfShape edges_;  // KnownEdge k - 1 is that of edge k
  std::vector<KnownEdge> known_;
  TopTools_IndexedMapOfShape vertices_;  // in the plane; vertex_nodes_[k - 1] is that of vertex k
  std::vector<int> vertex_nodes_;
  std::vector<double> slack_;                // by node: how far off it a curve may end in it
  std::vector<std::vector<int>> nodes_of_;   // by face
  std::vector<std::vector<int>> curves_of_;  // by face: its edges in the plane
};

}  // namespace blossom::occt
