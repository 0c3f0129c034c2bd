// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces that meet along common curves get common edges and vertices.

#pragma once

#include <cstddef>
#include <vector>

#include <TopTools_DataMapOfShapeListOfShape.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "core/base/disjoint_sets.h"

namespace blossom::occt {

/// First all edges are joined, then all faces rebuilt.
class EdgeUnion {
 public:
  /// Makes two edges one, as well as the vertices at their ends. They lie on the same curve with
  /// the same parameter, over ranges that agree but for the tolerance. The edge that comes of them
  /// has the range of the first and the chart curves of both.
  /// returns    false if the second one is an edge that was joined to another: nothing is done
  bool join(const TopoDS_Edge& a, const TopoDS_Edge& b);

  /// Makes two edges one that run along each other with parameters of their own. The first one
  /// stays.
  /// image      the chart curves of the second one's faces, with the parameters of the first
  /// reversed   whether they run in opposite directions
  /// returns    false if the second one is an edge that was joined to another: nothing is done
  bool join(const TopoDS_Edge& a, const TopoDS_Edge& b, const TopoDS_Edge& image, bool reversed);

  /// The edge that an edge was joined to as the second one; itself if it was to none. Turned as the
  /// edge that is given runs.
  TopoDS_Edge first(const TopoDS_Edge& edge) const;

  /// Makes two vertices one.
  void join(const TopoDS_Vertex& a, const TopoDS_Vertex& b);

  /// What stands for an edge; itself if nothing does.
  TopoDS_Edge united(const TopoDS_Edge& edge);

  /// The face with its edges and vertices replaced; itself if none is, null if nothing is left of
  /// it. Its border stays where it was: vertices get tolerances that cover all those they stand
  /// for. An edge whose ends became one vertex, and that lies in it as a whole, is left out, and so
  /// is a wire of such edges.
  TopoDS_Face rebuilt(const TopoDS_Face& face);

  /// Edges whose ends became one, and that do not lie in their vertex; the faces cannot be used
  /// then.
  int collapsed() const { return collapsed_; }

  /// Edges of which a vertex reaches the middle, since it was united with others that are that far
  /// away: it stands for more than a point then.
  int swallowed() const { return swallowed_; }

  /// Wires that rebuilt faces lost: holes, and the borders of faces of which nothing is left.
  int lost_wires() const { return lost_wires_; }

 private:
  std::size_t number(const TopoDS_Vertex& vertex);
  TopoDS_Vertex united(const TopoDS_Vertex& vertex);

  TopTools_IndexedMapOfShape vertices_;
  DisjointSets sets_;                              // of vertices, by number
  std::vector<TopoDS_Vertex> made_;                // for roots, once needed
  TopTools_DataMapOfShapeShape first_of_;          // of joined edges
  TopTools_DataMapOfShapeListOfShape curves_for_;  // edges whose chart curves a first one takes
  TopTools_MapOfShape reversed_;                   // second ones that run against their first
  TopTools_DataMapOfShapeShape made_edges_;
  TopTools_MapOfShape left_out_;
  int collapsed_ = 0;
  int swallowed_ = 0;
  int lost_wires_ = 0;
};

}  // namespace blossom::occt
