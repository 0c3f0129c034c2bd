// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges of a shape and how faces meet in them.

#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>

#include "core/math/vec.h"

namespace blossom::occt {

/// How the faces at an edge meet, seen from inside of the material.
enum class EdgeKind {
  Convex,
  Concave,
  Smooth,     ///< their normals agree all along
  Mixed,      ///< convex here and concave there, or smooth in parts
  Seam,       ///< one face has it twice
  Open,       ///< of one face only
  Crowded,    ///< of more than two faces, or of two that use it in one direction
  Degenerate  ///< a point
};

/// "convex", "concave", ... as in the JSON report.
const char* to_string(EdgeKind kind);

/// Angles between normals below this are none. Radians.
inline constexpr double kSmoothEdge = 1e-3;

struct EdgeFacts {
  int number = 0;  ///< 1-based, in the order of TopExp::MapShapes
  TopoDS_Edge edge;
  std::vector<int> faces;  ///< numbers of the faces that use it, once for each use
  EdgeKind kind = EdgeKind::Open;
  double angle = 0;         ///< the largest between the outward normals along it, radians
  double length = 0;        ///< model units
  double from = 0, to = 0;  ///< its parameters
  Vec3 middle;              ///< at the middle parameter; of a point where it is
};

/// What is known of all edges of a shape, by number - 1.
std::vector<EdgeFacts> edge_facts(const TopoDS_Shape& shape);

}  // namespace blossom::occt
