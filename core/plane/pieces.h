// SPDX-License-Identifier: LGPL-2.1-or-later
// The pieces that cuts leave of a face: one outer loop each, and its holes.

#pragma once

#include <span>
#include <vector>

#include "core/plane/arrangement.h"

namespace blossom {

struct ChartPiece {
  Cycle outer;               ///< counter-clockwise
  std::vector<Cycle> holes;  ///< clockwise; each touches others in vertices at most
  std::vector<int> inner;    ///< cuts inside that divide nothing
};

struct ChartPieces {
  std::vector<ChartPiece> pieces;  ///< in the order of their first arcs
  std::vector<int> dangling;       ///< cuts that divide nothing, see `cycles`
  bool consistent = true;  ///< false when a hole lies in no piece: the loops are not a face's
};

/// The pieces of a face.
///
/// A cycle that walks a border arc backwards lies outside of the face. Of the others, the
/// counter-clockwise ones bound pieces; a clockwise one is a hole of the smallest piece that
/// goes round it and has no arc connected to it. Cycles that come to a vertex twice are loops that
/// touch there: each becomes one of its own. A cut that divides nothing lies in the smallest
/// piece round its middle.
///
/// arcs      borders and cuts; they meet only at vertices, cuts lie inside the borders
/// tolerance   as of `cycles`
/// throws    InvalidInput as `cycles`
ChartPieces pieces(std::span<const ChartArc> arcs, double tolerance = 0);

}  // namespace blossom
