// SPDX-License-Identifier: LGPL-2.1-or-later
// What a search of two faces leaves to the edges that they share, and what it finds along these
// all the same.

#pragma once

#include <vector>

#include "adapters/occt/faces/face_data.h"
#include "adapters/occt/faces/shared_edges.h"
#include "core/results/options.h"
#include "core/results/result.h"

namespace blossom::occt {

/// A shared edge as a curve that the search of the two surfaces need not find. Where the faces go
/// on smoothly, or their borders agree only roughly, nothing beside the edge can be told apart: the
/// strip round it that counts as the edge is as wide as the larger of a part of the faces' size and
/// a few of the edge's tolerances.
///
/// size   of the smaller face, model units
KnownCurve known_curve(const SharedEdge& edge, double size);

/// Takes out curves, points and touches that keep to shared edges: what was found along an edge is
/// the edge. Curves are judged by their samples.
///
/// tolerance   of the intersection, model units
void drop_along_edges(SurfaceIntersection& found, std::vector<Touch>& touches,
                      const std::vector<SharedEdge>& edges, double tolerance);

}  // namespace blossom::occt
