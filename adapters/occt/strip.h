// SPDX-License-Identifier: LGPL-2.1-or-later
// A strip between two faces that continues both with their tangent planes.

#pragma once

#include <optional>
#include <vector>

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>

#include "core/blending/strips/strip.h"

namespace blossom::occt {

struct FaceStripOptions {
  /// The borders to join; none means the nearest of those that have edges.
  std::optional<SurfaceSide> side_a = {};
  std::optional<SurfaceSide> side_b = {};
  StripOptions strip = {};
};

struct FaceStrip {
  Strip strip;  ///< its surface and its figures are those of `surface`
  SurfaceSide side_a = SurfaceSide::UMin;
  SurfaceSide side_b = SurfaceSide::UMin;
  Handle(Geom_BSplineSurface) surface;  ///< inner knots as smooth as the strip is
  TopoDS_Face face;
};

/// The borders of a face that an iso-parameter edge covers from end to end; not a seam and not
/// an edge without length. In the order umin, umax, vmin, vmax.
std::vector<SurfaceSide> open_sides(const TopoDS_Face& face);

/// The strip between two faces, in model space.
/// throws   BadModel if a face has no iso-parameter edge, or none on the side that was named;
///          InvalidInput as strip_between of core; Failure if Open CASCADE makes no valid face
FaceStrip strip_between(const TopoDS_Face& a, const TopoDS_Face& b,
                        const FaceStripOptions& options = {});

}  // namespace blossom::occt
