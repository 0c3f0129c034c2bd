// SPDX-License-Identifier: LGPL-2.1-or-later
// What a search of two faces leaves to the edges that they share, and what it finds along these
// all the same.

#pragma once

#include <vector>

#include "core/results/options.h"
#include "core/results/result.h"
#include "core/topology/clipping/clipped_result.h"
#include "core/topology/shared.h"

namespace blossom {

/// A shared edge as a curve that the search of the two surfaces need not find. Where the faces go
/// on smoothly, or their borders agree only roughly, nothing beside the edge can be told apart: the
/// strip round it that counts as the edge is as wide as the larger of a part of the faces' size and
/// a few of the edge's tolerances.
///
/// size   of the smaller face, model units
KnownCurve known_curve(const SharedEdge& edge, double size);

/// Whether a point lies so near to a shared edge that it is of the edge: within four times the
/// larger one of its tolerance and the given one.
///
/// tolerance   of the intersection, model units
bool keeps_to_edges(const Vec3& point, const std::vector<SharedEdge>& edges, double tolerance);

/// Whether all samples of a curve do.
bool keeps_to_edges(const IntersectionCurve& curve, const std::vector<SharedEdge>& edges,
                    double tolerance);

/// Takes out curves, points and touches that keep to shared edges: what was found along an edge is
/// the edge.
///
/// tolerance   of the intersection, model units
void drop_along_edges(SurfaceIntersection& found, std::vector<Touch>& touches,
                      const std::vector<SharedEdge>& edges, double tolerance);

/// Takes out places that keep to shared edges, and those in which the search could not tell what is
/// beside one; but what is unresolved stays. The status stays as it is, and reasons say why.
///
/// edges       at least one
/// tolerance   of the intersection, model units
void drop_places_along_edges(SurfaceIntersection& found, const std::vector<SharedEdge>& edges,
                             double tolerance);

}  // namespace blossom
