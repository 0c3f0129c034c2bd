// SPDX-License-Identifier: LGPL-2.1-or-later
// A face beside one of its edges, for the figures of core/blending/continuity/continuity.h.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/blending/continuity/continuity.h"
#include "core/forms/surface.h"

namespace blossom::occt {

/// Spans shorter than this, as a part of the edge or of the surface, are left out: knots that were
/// meant to be one, between which derivatives are noise.
inline constexpr double kSliver = 1e-8;

struct EdgeBorder {
  EdgeSides sides;             ///< by the fraction of the edge's range
  std::vector<double> breaks;  ///< between 0 and 1, increasing: the face is smooth between
  std::optional<BorderSpans> spans;
  std::string no_spans;  ///< why there are none
};

/// The face beside an edge, the edge oriented as in the face when that is oriented forward.
///
/// There are spans where the surface is a plane and the edge's curve in it a line, conic or spline,
/// or where the surface is polynomial or rational and the curve an iso-parameter line, its
/// parameter proportional to the edge's. Then `sides` come from the spans, one-sided at knots.
/// throws   BadModel if the edge has no curve in the face's parameters, or a number of the geometry
///          is not finite
EdgeBorder edge_border(const TopoDS_Edge& edge, const TopoDS_Face& face);

/// The surface beside an edge that is an iso-parameter line, from the edge to the next knot.
struct IsoCollar {
  BezierSurface surface;
  SurfaceSide side = SurfaceSide::UMin;  ///< that the edge is
  bool backward = false;                 ///< the edge runs against the surface's parameter
  double off = 0;  ///< how far the edge leaves the line, as a part of the depth
};

/// Nothing if the edge is no such line, or the surface neither polynomial nor rational.
/// throws   BadModel as edge_border
std::optional<IsoCollar> iso_collar(const TopoDS_Edge& edge, const TopoDS_Face& face);

}  // namespace blossom::occt
