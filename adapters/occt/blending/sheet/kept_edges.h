// SPDX-License-Identifier: LGPL-2.1-or-later
// What stays of the edges of a body beside a blend sheet.
//
// Each place where the border of the sheet meets an edge says on which side of it the edge stays.
// What goes is what hangs on the filleted edges: from them and from the cuts it spreads over pieces
// of edges and vertices up to the border of the sheet.

#pragma once

#include <map>
#include <vector>

#include <TopoDS_Vertex.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/splitting/edges/edge_splits.h"

namespace blossom::occt {

/// A split of an edge where the border of the sheet meets it.
struct EdgeCut {
  int edge = 0;
  int split = EdgeSplits::kFirst;
  bool keep_after = true;  ///< the edge stays beyond the split's parameter, else before it
};

/// The border of a sheet as edges see it.
struct SheetBorder {
  /// Edges that go, but for what cuts keep of them: filleted ones, and those that others take the
  /// place of.
  std::vector<int> filleted;
  std::vector<EdgeCut> cuts;
  std::vector<TopoDS_Vertex> vertices;  ///< of the body, at which the border ends
};

/// The pieces that stay of each edge that does not stay whole, or was split; others are not listed.
///
/// throws   FilletRefused if a piece would have to stay and to go: fillets take more of an edge
///          than there is
std::map<int, std::vector<EdgePiece>> kept_pieces(const BodyEdges& body, EdgeSplits& splits,
                                                  const SheetBorder& border);

}  // namespace blossom::occt
