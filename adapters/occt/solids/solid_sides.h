// SPDX-License-Identifier: LGPL-2.1-or-later
// On which side of the other solid the pieces of two split solids lie.

#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/splitting/trim_sides.h"
#include "core/base/work_limit.h"

namespace blossom::occt {

enum class SolidSide {
  Unknown,
  Outside,   ///< of the other solid
  Inside,    ///< of it
  Same,      ///< on its surface, material on the same side
  Opposite,  ///< on its surface, material on the other side
};

struct SolidPiece {
  TopoDS_Face face;  ///< oriented as the face that it comes from
  int from = 0;      ///< place of that face among the solid's faces
  SolidSide side = SolidSide::Unknown;
};

/// The pieces of a solid and what is known of them.
struct SplitSolid {
  const char* name = "";  ///< in messages
  const TrimTool* solid = nullptr;
  std::vector<SolidPiece> pieces;  ///< with the edges that both solids share
  /// Edges that intersection curves run along, or that lie in a face of the other solid: beyond
  /// them a piece may be on another side.
  TopTools_MapOfShape crossed;
};

/// What `find_sides` has to tell.
struct SidesTold {
  std::vector<std::string> obstacles;  ///< what is not decided
  std::vector<std::string> merged;     ///< what counts as one although it is apart
  double between = 0;  ///< about the volume between pieces that do, cubic model units
};

/// Finds the sides of all pieces.
///
/// Pieces with the same edges and the same surface between them coincide. All others that hang
/// together over edges that the other solid does not cross lie on one side: what is known of them
/// already has to agree, and rays from points inside of them with that and each other.
///
/// Sheets have no inside: pieces of the other input have sides only where they coincide with one.
///
/// overlaps    pairs of faces of a and b that coincide somewhere
/// tolerance   model units; ten times as near to the other surface is on it where faces coincide,
///             twice elsewhere
/// limit       asked at each piece; null: none
/// throws      Failure when the limit is reached
SidesTold find_sides(SplitSolid& a, SplitSolid& b,
                     const std::vector<std::pair<std::size_t, std::size_t>>& overlaps,
                     double tolerance, const WorkLimit* limit = nullptr);

}  // namespace blossom::occt
