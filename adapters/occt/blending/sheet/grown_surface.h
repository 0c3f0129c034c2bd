// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces whose new borders lie past the natural borders of their spline surfaces.

#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace blossom::occt {

/// The face without wires on a surface that goes on, as its outer spans do and with the same
/// parameters, as far as the chart curves of edges go; these get their charts on it, too. The same
/// face where they do not leave its surface, and where that is no spline or closes there.
TopoDS_Face grown_to_edges(const TopoDS_Face& face, const std::vector<TopoDS_Edge>& edges);

}  // namespace blossom::occt
