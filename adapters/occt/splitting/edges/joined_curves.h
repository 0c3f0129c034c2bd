// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves of several pairs of faces as edges: each stretch once, joined in common vertices.

#pragma once

#include <array>
#include <vector>

#include <TopoDS_Compound.hxx>

#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// A curve that was found. All lengths in model units.
struct FoundCurve {
  RangedCurve of;
  bool closed = false;
  double tolerance = 0;           ///< how far off it others may be that are the same
  std::array<double, 2> reach{};  ///< likewise of its ends, which may lie in a contact
  double stated = 0;              ///< by which its faces' edges may be off, and so its ends
};

/// A point in which faces only touch.
struct FoundPoint {
  Vec3 point;
  double reach = 0;  ///< how far off it the contact may be, model units
};

/// Curves become edges between nodes: where they end, on others or by themselves. Ends within reach
/// of each other are one node; so are two that would stay alone, within what their faces state. Of
/// stretches that run along each other between the same nodes, as where neighbouring faces meet
/// another one in their common edge, one stays: a conic rather than a spline, then the nearer one.
/// What goes on from edge to edge, where no third one ends, is one wire. Points are vertices of
/// their own where no edge passes.
TopoDS_Compound joined_curves(const std::vector<FoundCurve>& curves,
                              const std::vector<FoundPoint>& points);

}  // namespace blossom::occt
