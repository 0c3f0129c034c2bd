// SPDX-License-Identifier: LGPL-2.1-or-later
// Trimmed shapes as untrimmed faces that meet without gaps.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "core/watertight/watertight.h"

namespace blossom::occt {

/// How many tolerances of a trim its result may be off when it is made watertight: trims' own edges
/// are about one tolerance off, and triangles need room beside them. A choice.
inline constexpr double kWatertightFactor = 10;

struct WatertightShape {
  WatertightPieces pieces;
  /// For each face of the shape, in the order of TopExp::MapShapes, the faces of its pieces,
  /// oriented as it is. All share their edges and vertices; triangles are halves of patches or on
  /// planes (watertight_faces.h).
  std::vector<std::vector<TopoDS_Face>> faces;
  /// The shape's solids and shells, and a compound of the rest, of these faces.
  TopoDS_Shape shape;
};

/// Why a shape of pieces is not to be used in the place of a given one: where the model's own edges
/// are farther from its faces than the pieces are wide, these may fold over or miss each other.
/// Empty if closed shells stay closed and the pieces are valid by BRepCheck.
std::string watertight_fault(const TopoDS_Shape& given, const TopoDS_Shape& made);

/// All faces of a shape as patches and triangles with common sides.
///
/// Faces meet where they have an edge in common, or free edges that run along each other
/// (edge_joins.h). The common sides are those of the edge's curve in space; where the images of its
/// two borders are apart by more than the tolerance, of the curve in the middle between them; where
/// it has one border, of its image. If there is an obstacle, only that is set. Closed shells stay
/// closed and the shape is valid by BRepCheck; if it were not, `watertight_fault` is the obstacle.
///
/// throws   BadModel if a face cannot be converted, an edge has no curve in space or another range
///          of parameters on a face; InvalidInput as watertight_pieces
WatertightShape watertight(const TopoDS_Shape& shape, const WatertightOptions& options = {});

}  // namespace blossom::occt
