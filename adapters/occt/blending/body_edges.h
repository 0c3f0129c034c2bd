// SPDX-License-Identifier: LGPL-2.1-or-later
// How the faces of a body hang together at its edges and vertices, and how they meet there.

#pragma once

#include <map>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/faces/face_trims.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// An end of an edge at a vertex.
struct DirectedEdge {
  int edge = 0;
  bool at_start = true;  ///< of the forward edge
  friend bool operator==(const DirectedEdge&, const DirectedEdge&) = default;
};

/// One use of an edge by a face, as the outward face uses it: the face lies to its left.
struct EdgeUseInFace {
  int face = 0;
  int edge = 0;
  bool forward = true;
  const Coedge* coedge = nullptr;  ///< in the trims, which are those of the forward face
  int next = -1;                   ///< along the wire, among the uses of the face
  int previous = -1;
};

/// A face's part between two edges at a vertex.
struct VertexSector {
  DirectedEdge half;  ///< that begins it
  int face = 0;
  int use = 0;  ///< of that edge in the face, walking away from the vertex
};

/// Edges, vertices and faces of a solid by number, and how they are connected.
class BodyEdges {
 public:
  /// body   faces turned outwards
  explicit BodyEdges(const TopoDS_Shape& body);

  const TopoDS_Shape& body() const { return body_; }
  int edge_count() const { return edges_.Extent(); }
  int face_count() const { return faces_.Extent(); }
  /// Forward.
  TopoDS_Edge edge(int number) const;
  /// As the body has it.
  const TopoDS_Face& face(int number) const { return faces_of_[static_cast<std::size_t>(number)]; }
  int number(const TopoDS_Edge& edge) const { return edges_.FindIndex(edge); }
  TopoDS_Vertex vertex(const DirectedEdge& half) const;

  /// throws   BadModel as `face_trims`
  const FaceTrims& trims(int face) const;
  const std::vector<EdgeUseInFace>& uses(int face) const;

  /// The use in which the edge runs forward, or the other one.
  /// throws   BadModel, naming the edge, unless it has just these two
  const EdgeUseInFace& use(int edge, bool forward) const;

  /// The use of an edge by the face on the other side of it.
  const EdgeUseInFace& behind(const EdgeUseInFace& of) const { return use(of.edge, !of.forward); }
  /// The use of an edge by a face that has it once.
  const EdgeUseInFace& use_in(int edge, int face) const {
    return use(edge, use(edge, true).face == face);
  }

  /// All edges round a vertex, beginning with the given one; between each and the next the face
  /// that lies to the left of the one, as seen from outside, walking away from the vertex.
  /// Edges without length are left out.
  /// throws   BadModel if they make no ring
  std::vector<VertexSector> round(const DirectedEdge& half) const;

  /// Of the outward face at a point of an edge's use.
  /// inwards   along the tangent plane into the face, unit, across the edge
  struct Corner {
    Vec3 point, along, normal, inwards;
  };
  Corner corner(const EdgeUseInFace& use, double parameter) const;

 private:
  struct FaceUses {
    FaceTrims trims;
    std::vector<EdgeUseInFace> uses;
  };
  const FaceUses& uses_of(int face) const;

  TopoDS_Shape body_;
  TopTools_IndexedMapOfShape edges_;
  TopTools_IndexedMapOfShape faces_;
  std::vector<TopoDS_Face> faces_of_;            // by number
  std::vector<std::vector<int>> faces_at_edge_;  // by number of the edge
  mutable std::map<int, FaceUses> known_;
};

/// Edges whose directions at a vertex differ by less go on as one. Radians.
inline constexpr double kSmoothJoint = 1e-3;

/// The direction of an edge at a vertex, away from it, unit.
Vec3 direction_at(const BodyEdges& body, const DirectedEdge& half);

/// Whether the face of a sector at a vertex turns by less than half a circle there, so that
/// contacts of blends along its edges come to each other.
///
/// next   the edge at which the sector ends
bool is_narrow(const BodyEdges& body, const VertexSector& sector, const DirectedEdge& next);

/// The kind of an edge of a body, and the largest angle between the normals along it.
EdgeKind edge_kind(const BodyEdges& body, int edge, double& angle);

/// Convex, concave or smooth: how the faces meet at one place of an edge, or at one of its ends.
/// Along edges of mixed kind that changes, but how blends end there depends on the end alone.
EdgeKind kind_at(const BodyEdges& body, int edge, double parameter);
EdgeKind kind_at(const BodyEdges& body, const DirectedEdge& half);

}  // namespace blossom::occt
