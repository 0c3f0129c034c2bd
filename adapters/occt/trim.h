// SPDX-License-Identifier: LGPL-2.1-or-later
// Trimming: the faces of a part cut by tools, and the pieces on the wanted side.

#pragma once

#include <map>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/trim_tool.h"
#include "core/surface_intersection.h"

namespace blossom::occt {

/// A face of the part, by its number in the model.
struct PartFace {
  int number = 0;
  TopoDS_Face face;
  bool cut = true;  ///< false for neighbours that only follow the splits of common edges
};

enum class Keep {
  Above,    ///< where the oriented normals of all tools point
  Below,    ///< opposite to them
  Inside,   ///< inside of a solid tool
  Outside,  ///< outside of all of them
  All,
  Number,  ///< the piece with a number
};

struct TrimOptions {
  Keep keep = Keep::All;
  int piece = 0;  ///< of Keep::Number: 1-based, as pieces are numbered in the result
  OpenCuts open_cuts = OpenCuts::Imprint;  ///< of Keep::All; with others they are left out
  IntersectionOptions intersection;
};

/// Where a piece lies with respect to all tools.
enum class PieceSide { Unknown, Above, Below, Inside, Outside, On, Mixed };

/// "unknown", "above", ... as in the JSON report.
const char* to_string(PieceSide side);

struct TrimPiece {
  int number = 0;  ///< 1-based, over all pieces in the order of the part's faces
  int face = 0;    ///< number of the face it comes from
  PieceSide side = PieceSide::Unknown;
  bool kept = true;
  double area = 0;  ///< square model units
  TopoDS_Face shape;
};

struct TrimResult {
  /// That of the intersection; Tolerance if a face could not be cut.
  Status status = Status::Complete;
  std::vector<TrimPiece> pieces;  ///< of the faces to cut; a face that no tool meets is one piece
  std::map<int, double> areas;    ///< of the faces to cut, before
  /// Faces that change and what takes their place; for Model::replace_faces.
  std::map<int, std::vector<TopoDS_Face>> replacements;
  std::vector<std::string> notes;  ///< what was left out, and why
  Certificate certificate;
};

/// Cuts the faces of a part along their intersections with the tools.
///
/// Where all faces are cut and all tools are closed solids, part and tools are divided as
/// `trim_solids` does: areas add up, and rays prove on which side the pieces lie. Faces that are
/// cut alone, those cut by sheets, and what cannot be divided so, which is told, are cut one by
/// one: the sides follow from the cuts. The status is Tolerance
/// then if it is undecided whether a piece is inside.
///
/// Where a face coincides with one of a tool it is cut along the border of their common region; the
/// piece there lies on the tool, on none of its sides.
///
/// Every cut becomes one edge for both its sides; edges that cuts end in are split once for all
/// their faces, so that shells stay sewn.
///
/// part      all faces of the model, or at least those to cut and their neighbours
/// throws    InvalidInput if Inside or Outside is asked for and a tool is no closed solid, or a
///           piece number that is not there; BadModel if a face cannot be converted
TrimResult trim(const std::vector<PartFace>& part, const std::vector<TrimTool>& tools,
                const TrimOptions& options = {});

}  // namespace blossom::occt
