// SPDX-License-Identifier: LGPL-2.1-or-later
// Degenerated edges: poles of a surface, one point in space and a line in the chart.

#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace blossom::occt {

/// The edges of a wire with degenerated ones that go from where the edge before comes to the pole
/// to where the one after leaves it.
///
/// A curve that passes a pole nearer than the tolerance ends in it, but its image may come to it
/// anywhere along the pole, and where it does so is known for good only when edges of several faces
/// have become one.
///
/// edges   in the order and with the orientations of the wire in the forward face
/// face    with the surface; its wires do not matter
std::vector<TopoDS_Edge> with_fitted_poles(const std::vector<TopoDS_Edge>& edges,
                                           const TopoDS_Face& face);

}  // namespace blossom::occt
