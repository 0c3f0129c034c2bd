// SPDX-License-Identifier: LGPL-2.1-or-later
// Two solids split along their intersection, so that both sides of each curve have the same edge.

#pragma once

#include <string>
#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/trim_sides.h"
#include "core/surface_intersection.h"

namespace blossom::occt {

struct SolidPiece {
  TopoDS_Face face;                   ///< oriented as the face that it comes from
  int from = 0;                       ///< place of that face among the solid's faces
  ToolSide side = ToolSide::Unknown;  ///< Below is inside of the other solid
};

/// The pieces of both solids, or why there are none.
struct SolidPieces {
  Status status = Status::Complete;  ///< of the intersection
  Certificate certificate;
  std::vector<SolidPiece> a;
  std::vector<SolidPiece> b;
  std::vector<std::string> obstacles;  ///< none if the pieces can be used
};

/// Splits the faces of two solids along each other.
///
/// Every intersection curve becomes edges that pieces of both solids share, with curves in the
/// parameters of both. The sides of pieces are decided at the cuts and checked by rays, or decided
/// by rays that agree where the cuts do not tell.
///
/// Contacts without crossing (surfaces that touch or coincide, curves along an edge) are obstacles.
///
/// throws   BadModel if a face cannot be converted
SolidPieces solid_pieces(const TrimTool& a, const TrimTool& b, const IntersectionOptions& options);

}  // namespace blossom::occt
