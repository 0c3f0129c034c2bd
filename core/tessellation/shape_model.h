// SPDX-License-Identifier: LGPL-2.1-or-later
// What is meshed: trimmed faces that share edges, and edges that share vertices.

#pragma once

#include <variant>
#include <vector>

#include "core/forms/curve_spans.h"
#include "core/forms/surface.h"
#include "core/math/vec.h"
#include "core/regions/trimmed_chart.h"
#include "core/tessellation/charts/elementary_chart.h"

namespace blossom {

/// An edge that all its faces follow.
struct ModelEdge {
  CurveSpans curve;  ///< in space; none if the edge is a point
  int from = 0;      ///< vertices at the ends of the curve's domain
  int to = 0;
  bool is_point = false;  ///< as at the pole of a sphere
};

struct ModelFace {
  std::variant<ElementaryChart, BezierSurface> surface;
  TrimmedChart chart;  ///< in the surface's own parameters; the region is on the left of borders
  std::vector<int> edges;  ///< of each border, whose parameters run as the edge's do
  double part = 1;  ///< of the deviation: what its facets and its edges are to keep, at most 1
};

struct ShapeModel {
  std::vector<Vec3> vertices;
  std::vector<ModelEdge> edges;
  std::vector<ModelFace> faces;
};

}  // namespace blossom
