// SPDX-License-Identifier: LGPL-2.1-or-later
// The borders of a face as a polygon in its parameters.

#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "core/math/vec.h"
#include "core/tessellation/chart_surface.h"
#include "core/tessellation/edge_polyline.h"
#include "core/tessellation/shape_model.h"

namespace blossom {

/// A point of an edge's polyline: vertex or sample.
struct PolylinePoint {
  int edge = -1;
  std::size_t number = 0;
};

/// A segment of an edge's polyline; no edge, -1, where it is a point in space.
struct EdgeSegment {
  int edge = -1;
  std::size_t number = 0;

  friend bool operator==(const EdgeSegment&, const EdgeSegment&) = default;
};

/// A side of the polygon, with the region on its left.
struct PolygonSide {
  int from = 0, to = 0;
  EdgeSegment segment;
  bool straight = false;  ///< in the parameters: more points would not move it
};

struct FacePolygon {
  std::vector<Vec2> points;            ///< no two are equal
  std::vector<PolylinePoint> origins;  ///< of each point
  std::vector<PolygonSide> sides;
  Vec2 low, high;  ///< box

  /// polylines   of all edges; those of edges that are points have none
  FacePolygon(const ModelFace& face, const std::vector<EdgePolyline>& polylines);

  /// Segments that are farther from the surface than the deviation, though they are near to their
  /// edge: where facets are to be near to the surface, they have to be divided.
  std::vector<EdgeSegment> too_far(const ChartSurface& surface, double deviation) const;

 private:
  void take(const ModelFace& face, std::size_t border, const std::vector<EdgePolyline>& polylines);
  int place_of(const Vec2& uv, const PolylinePoint& origin);

  std::map<std::pair<double, double>, int> places_;
};

}  // namespace blossom
