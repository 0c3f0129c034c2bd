// SPDX-License-Identifier: LGPL-2.1-or-later
// A body whose filleted edges a blend sheet takes the place of.

#pragma once

#include <map>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"

namespace blossom::occt {

/// A face of the result and where it comes from.
struct TrimmedFace {
  TopoDS_Face face;
  int from = 0;  ///< number of the body's face; 0: a face of the sheet
  int edge = 0;  ///< of the sheet: number of the edge in whose place it is; 0: of a corner
};

struct TrimmedBody {
  std::vector<TrimmedFace> faces;
  std::map<int, std::vector<TopoDS_Edge>> edges;  ///< what is left of edges that do not stay whole
};

/// All faces of the body without what the sheet cuts off, and those of the sheet.
///
/// Wires are put together anew from what is left of their edges and from the edges that the sheet
/// adds: end to start at common vertices. A face may fall apart into several. Where a face shrinks
/// to a run of two edges along each other it goes, and the edges become one.
/// throws   FilletRefused if wires stay open, or more of an edge would go than there is
TrimmedBody trimmed_by_sheet(const BodyEdges& body, BlendSheet& sheet, double tolerance);

}  // namespace blossom::occt
