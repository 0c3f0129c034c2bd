// SPDX-License-Identifier: LGPL-2.1-or-later
// What is left of a sheet.

#include <cmath>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/solids/sheets.h"

namespace blossom::occt {
namespace {

bool lies_on_other(SolidSide side) {
  return side == SolidSide::Same || side == SolidSide::Opposite;
}

SheetSide sheet_side(SolidSide side) {
  if (lies_on_other(side)) return SheetSide::On;
  return side == SolidSide::Inside ? SheetSide::Inside : SheetSide::Outside;
}

// A sheet has no inside: what its pieces' cuts say of their sides holds beside these alone.
bool is_left(SolidSide side, const TrimTool& tool, SolidOperation operation) {
  const bool within = (tool.is_solid() && side == SolidSide::Inside) || lies_on_other(side);
  if (operation == SolidOperation::Cut) return !within;
  return operation != SolidOperation::Common || within;
}

double area_of(const SolidPiece& piece, const TrimTool& of, const char* owner) try {
  return area(piece.face);
} catch (const BadModel& error) {
  throw Failure("a piece of " + face_name(of, static_cast<std::size_t>(piece.from), owner) + ": " +
                error.what());
}

bool areas_add_up(const std::vector<SolidPiece>& pieces, const TrimTool& of, const char* owner) {
  double whole = 0, sum = 0;
  for (const TopoDS_Face& face : of.faces) whole += area(face);
  for (const SolidPiece& piece : pieces) sum += area_of(piece, of, owner);
  return std::abs(sum - whole) <= kVolumeError * whole;
}

}  // namespace

void take_sheet_pieces(const SolidPieces& pieces, const TrimTool& part, const TrimTool& tool,
                       SolidOperation operation, SolidTrimResult& result) {
  for (const SolidPiece& piece : pieces.a)
    if (is_left(piece.side, tool, operation))
      result.faces.push_back({piece.face, -1, piece.from, sheet_side(piece.side)});
  const bool fuse = operation == SolidOperation::Fuse;
  if (fuse)
    for (const SolidPiece& piece : pieces.b)
      if (!lies_on_other(piece.side)) result.faces.push_back({piece.face, 0, piece.from});
  if (!areas_add_up(pieces.a, part, "the part") ||
      (fuse && !areas_add_up(pieces.b, tool, "the tool")))
    result.obstacles.emplace_back("the areas do not add up");
}

}  // namespace blossom::occt
