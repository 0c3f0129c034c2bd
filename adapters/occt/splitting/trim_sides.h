// SPDX-License-Identifier: LGPL-2.1-or-later
// On which side of a tool the pieces of a part lie.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/splitting/face_splitter.h"

namespace blossom::occt {

/// What parts are trimmed with. Faces are oriented: above is where their normals point.
struct TrimTool {
  std::vector<TopoDS_Face> faces;
  std::vector<TopoDS_Solid> solids;  ///< those that the faces bound; empty for an open tool
  std::string name{};                ///< in messages; empty: "the part" or "the tool"

  bool is_solid() const { return !solids.empty(); }
};

/// Whether a solid has faces, and each of their edges bounds two of them, or one twice.
bool is_closed_solid(const TopoDS_Shape& solid);

/// A tool of all the shape's faces; solid if all belong to closed solids. Empty ones are left out.
/// throws   BadModel if faces of a closed solid are turned differently, or all inwards
TrimTool trim_tool(const TopoDS_Shape& shape);

/// The same of solids that are known to be closed and turned outwards: nothing is checked.
TrimTool solid_tool(const std::vector<TopoDS_Solid>& solids);

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

/// Whether a piece lies on a face: a point inside of it is within reach of it, inside of its trims
/// or on its border.
bool lies_on(const TopoDS_Face& piece, const TopoDS_Face& face, double reach);

/// A point inside of a face; none if Open CASCADE finds none.
std::optional<gp_Pnt> point_inside(const TopoDS_Face& face);

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
