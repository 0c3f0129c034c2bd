// SPDX-License-Identifier: LGPL-2.1-or-later
// The facets of one face between the polylines of its edges.

#pragma once

#include <array>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/tessellation/chart_surface.h"
#include "core/tessellation/edge_polyline.h"
#include "core/tessellation/face_borders.h"
#include "core/tessellation/facet_corners.h"
#include "core/tessellation/shape_model.h"

namespace blossom {

/// Two points of edges, the lower one first.
using CommonSide = std::pair<CommonPoint, CommonPoint>;

/// A side of a facet between points of edges.
struct FacetSide {
  CommonSide ends;
  bool across = false;  ///< within the face, not along an edge
};

struct FaceFacets {
  std::vector<FaceCorner> corners;
  /// Numbers of corners, counter-clockwise round S_u x S_v.
  std::vector<std::array<int, 3>> triangles;
  double distance = 0;           ///< proven between facets and surface, both ways; model units
  double moved = 0;              ///< of that: how far corners on edges are off the surface, at most
  std::vector<FacetSide> sides;  ///< between points of edges, each by itself for each facet at it
  int folded = 0;  ///< facets whose normal is turned from the surface's by more than a right angle
  std::string obstacle = {};  ///< why there are no facets; empty if all is well
};

struct FaceAttempt {
  /// What has to be divided first: chords that cross in the parameters, or are too far from the
  /// surface. There are no facets then.
  std::vector<EdgeSegment> splits;
  FaceFacets facets;
};

/// Each round halves what crosses; after so many the crossing is no matter of chords.
inline constexpr int kLastRound = 14;

/// A constrained Delaunay triangulation of the polygon, with points in rows inside, and more where
/// the distance is not proven to be within the deviation.
///
/// vertices    of the model
/// polylines   of all edges
/// parted      sides that get a point in their middle where they are across the face, as another
///             face has them, too
/// round       of attempts, from 0 on; in the last one nothing is divided any more, and what
///             crosses is an obstacle
/// ask         asked now and then whether to go on; what is returned if it says no means nothing
FaceAttempt facets_of(const ModelFace& face, const ShapeModel& model,
                      const std::vector<EdgePolyline>& polylines, const ChartSurface& surface,
                      const FacetOptions& options, const std::set<CommonSide>& parted, int round,
                      const std::function<bool()>& ask = {});

}  // namespace blossom
