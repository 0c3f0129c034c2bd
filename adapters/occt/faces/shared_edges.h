// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges that two faces of a model share: a part of their intersection that needs no search.

#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/results/result.h"

namespace blossom::occt {

struct SharedEdge {
  TopoDS_Edge edge;
  IntersectionCurve curve;  ///< its parameter is the edge's own; deviations are those of samples
  double tolerance = 0;     ///< of the edge, model units
  double gap = 0;           ///< largest distance of edge and faces at the samples, model units
  double most_sine = 0;     ///< of the angle between the faces along it
};

/// The edges that both faces use, but for degenerated ones and seams, which a face has twice.
/// throws   BadModel if an edge has no curve in space or on a face
std::vector<SharedEdge> shared_edges(const TopoDS_Face& a, const TopoDS_Face& b);

}  // namespace blossom::occt
