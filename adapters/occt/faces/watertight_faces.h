// SPDX-License-Identifier: LGPL-2.1-or-later
// Watertight pieces as faces that share edges and vertices.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <BRep_Builder.hxx>
#include <Geom_BezierSurface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "core/base/tolerances.h"
#include "core/watertight/flat_pieces.h"
#include "core/watertight/watertight.h"

namespace blossom::occt {

/// A patch is a face with its surface's own borders. A triangle is
///
///   a face on a plane, where it is flat to half of the edges' tolerance;
///   or else the half of a patch on one side of the diagonal, which is its longest side inside of a
///   face of the model; sides on edges have the points of the patch's rows;
///   of a slender one the diagonal is the shortest side, so that its parameters are not slender;
///   or, if no side is inside of a face, a patch with one collapsed side.
class PieceFaces {
 public:
  explicit PieceFaces(const WatertightPieces& pieces);

  TopoDS_Face face_of(const WatertightPiece& piece);

  /// How far faces are from the pieces that they are of, at most; model units.
  double flattened() const { return flattened_; }

 private:
  static constexpr double kTolerance = Tolerances{}.point;
  static constexpr double kInPlane = 0.5 * kTolerance;
  static constexpr double kNarrow = 100 * kTolerance;  // no mesher finds triangles in less than 1
  static constexpr double kSlender = 2 * kNarrow;      // nor beside long diagonals in less than 2

  TopoDS_Face flat_face(const WatertightPiece& piece, const PiecePlane& plane);
  TopoDS_Face half_face(const WatertightPiece& piece, const BezierTriangle& triangle,
                        std::size_t diagonal);
  TopoDS_Face collapsed_face(const WatertightPiece& piece, const BezierTriangle& triangle);

  const WatertightSide& side_of_piece(const WatertightPiece& piece, std::size_t k) const;
  bool has_point(const WatertightPiece& piece) const;
  double length_of(const WatertightPiece& piece, std::size_t k) const;
  std::optional<std::size_t> diagonal_of(const WatertightPiece& piece,
                                         const BezierTriangle& triangle) const;
  std::size_t shortest_side(const WatertightPiece& piece) const;
  std::optional<std::size_t> longest_inner_side(const WatertightPiece& piece) const;
  std::size_t first_corner(const WatertightPiece& piece) const;

  TopoDS_Edge edge_on(const WatertightSide& side) const;
  void add_ends(TopoDS_Edge& edge, int from, int to) const;
  void begin(const BezierPatch& patch);
  void add_side(const WatertightPiece& piece, std::size_t side, std::size_t border);
  void add_curved(const WatertightPiece& piece, std::size_t side, const std::vector<Vec2>& points);
  void add_point(int vertex, std::size_t border);
  void add_pcurve(TopoDS_Edge& edge, std::size_t border, bool along) const;
  TopoDS_Face finished();

  const WatertightPieces& pieces_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<TopoDS_Edge> edges_;  // null for sides that are points
  double flattened_ = 0;
  Handle(Geom_BezierSurface) surface_;  // of the face at hand
  TopoDS_Face face_;
  TopoDS_Wire wire_;
};

}  // namespace blossom::occt
