// SPDX-License-Identifier: LGPL-2.1-or-later
// A strip between two faces that continues both: their tangent planes, curvatures, or the
// derivatives of these.

#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/blending/strips/strip.h"

namespace blossom::occt {

/// Where a strip starts: a border of the face's parameters that edges cover, or an edge of the
/// face. Neither means the nearest of all.
struct StripStart {
  std::optional<SurfaceSide> side = {};
  TopoDS_Edge edge = {};
};

struct FaceStripOptions {
  StripStart start_a = {};
  StripStart start_b = {};
  StripOptions strip = {};
};

/// What a strip starts from.
struct FaceStripEnd {
  StripStart start;
  bool exact = true;     ///< by the control points of the face
  double fit_error = 0;  ///< how far fitted rows are from the edge, model units; sampled
};

struct FaceStrip {
  Strip strip;  ///< its surface and its figures are those of `surface`, beside the faces themselves
  std::array<FaceStripEnd, 2> ends;     ///< on a, on b
  Handle(Geom_BSplineSurface) surface;  ///< inner knots as smooth as the strip is
  TopoDS_Face face;
};

/// The borders of a face that an iso-parameter edge covers from end to end; not a seam and not
/// an edge without length. In the order umin, umax, vmin, vmax.
std::vector<SurfaceSide> open_sides(const TopoDS_Face& face);

/// The strip between two faces, in model space.
/// throws   BadModel if a face has no edge to start from, or not the one that was named; or
///          an edge cannot be followed;
///          InvalidInput as strip_between of core; Failure if Open CASCADE makes no valid face
FaceStrip strip_between(const TopoDS_Face& a, const TopoDS_Face& b,
                        const FaceStripOptions& options = {});

}  // namespace blossom::occt
