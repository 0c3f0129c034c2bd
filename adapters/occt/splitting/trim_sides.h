// SPDX-License-Identifier: LGPL-2.1-or-later
// On which side of a tool the pieces of a part lie.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/splitting/face_splitter.h"
#include "adapters/occt/trim_tool.h"

namespace blossom::occt {

/// The tool's part in a cut.
struct CutSource {
  int tool = 0;             ///< index of the tool
  TopoDS_Face tool_face;    ///< as oriented in the tool
  Spline2 tool_chart;       ///< in the parameters of the tool's face; the cut's own parameter
  bool tangential = false;  ///< a contact, beside which no side can be told
};

/// A piece of a part with the cuts of its face.
struct SidedPiece {
  const FacePiece* piece = nullptr;
  const std::vector<FaceCut>* cuts = nullptr;
  const std::vector<CutSource>* sources = nullptr;  ///< one for each cut
};

enum class ToolSide { Unknown, Above, Below, On };

/// The side of a piece next to a cut on its border, from directions into the piece at several
/// points of the cut; unknown when they disagree or the surfaces are tangential there.
ToolSide side_at_cut(const SidedPiece& piece, const CutUse& use);

/// Whether a piece lies on a face: a point inside of it is within reach of it, inside of its trims.
bool lies_on(const TopoDS_Face& piece, const TopoDS_Face& face, double reach);

/// The side of each piece with respect to one tool, in the order of `pieces`.
///
/// Pieces next to a cut of the tool are decided there; pieces that hang together over edges that
/// the tool does not cut are on one side; what is left is decided at a point inside: by a
/// classifier for solids (above is outside), by the nearest point of the tool otherwise. Unknown
/// when that is ambiguous, or where the tool ends inside of the part so that its sides join.
///
/// number   the tool's index in the sources
/// limit    asked before each group; what it leaves is Unknown; null: none
std::vector<ToolSide> sides_of(const std::vector<SidedPiece>& pieces, const TrimTool& tool,
                               int number, const WorkLimit* limit = nullptr);

}  // namespace blossom::occt
