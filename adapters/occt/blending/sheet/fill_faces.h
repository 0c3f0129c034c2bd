// SPDX-License-Identifier: LGPL-2.1-or-later
// The patches of a fill as faces of a blend sheet, with common edges and vertices.

#pragma once

#include <functional>
#include <vector>

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "core/blending/fills/fill.h"

namespace blossom::occt {

/// Half a side of a fill, which one of its patches borders on.
struct FillBorder {
  int side = 0;
  int half = 0;              ///< 0 the first on the way round, against the clock
  TopoDS_Vertex from, to;    ///< on that way
  Handle(Geom_Curve) curve;  ///< the border of the patch, over [0, 1]
  bool along = true;         ///< whether it runs the way
  TopoDS_Face patch;         ///< without wires
  /// The border in the patch's chart, by the curve's parameter.
  Handle(Geom2d_Curve) chart;
};

/// A patch as a face without wires, turned to where the fill's way round is against the clock, and
/// its edges as the face uses them.
struct FillFace {
  TopoDS_Face face;
  std::vector<TopoDS_Edge> edges;
};

/// All patches.
///
/// corners   the vertices in which the sides begin
/// middle    makes, or finds, the vertex in the middle of a side; all others are new
/// border    makes the edge of a half, with its chart on the patch
std::vector<FillFace> fill_faces(const Fill& fill, const std::vector<TopoDS_Vertex>& corners,
                                 const std::function<TopoDS_Vertex(int side, const Vec3&)>& middle,
                                 const std::function<PathEdge(const FillBorder&)>& border);

}  // namespace blossom::occt
