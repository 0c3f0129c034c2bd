// SPDX-License-Identifier: LGPL-2.1-or-later
// How smoothly the faces of a shape meet along their edges.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>

#include "core/blending/continuity/continuity.h"

namespace blossom::occt {

/// What an edge is to the faces of one shell, or to those outside of shells.
enum class EdgeRole {
  Shared,       ///< of two faces
  Seam,         ///< twice of one face
  Open,         ///< once of one face
  NonManifold,  ///< used more than twice, or twice the same way by one face
  Degenerate,   ///< a point: no curve in space
  Inner,        ///< inside of a face, which does not end there
};

/// "shared", "seam", "open", "non-manifold", "degenerate" or "inner".
const char* to_string(EdgeRole kind);

/// One edge; where several shells have it, one for each.
struct EdgeContinuity {
  int number = 0;  ///< 1-based, in the order of TopExp::MapShapes
  TopoDS_Edge edge;
  std::vector<int> faces;  ///< numbers of the faces that use it in the shell, once for each use
  EdgeRole kind = EdgeRole::Open;

  /// Of shared edges and seams, unless `problem` says why not. Parameters are the edge's own.
  std::optional<MeasuredContinuity> found;
  std::optional<ContinuityBounds> bounds;  ///< where they exist; never below `found`
  std::string no_bounds;                   ///< why there are none
  std::string problem;

  Smoothness smoothness = Smoothness::None;  ///< of what was found
  bool proven = false;  ///< the bounds say no less; that it is no smoother is proven by a point
};

/// A radius of a hundred times the size of a face counts as flat when curvatures are compared:
/// `flat` of measured_continuity is 1 / (kFlatSizes L), L the diagonal of the larger face's box.
inline constexpr double kFlatSizes = 100;

struct ContinuityOptions {
  ContinuityTolerances tolerances = {};
  std::vector<int> faces = {};  ///< numbers; then edges that these faces alone use. Empty: all
  std::function<void()> tick = [] {};  ///< called often; may throw to stop
};

/// Every edge of a shape that a face uses, by number.
/// throws   Failure if Open CASCADE fails on the shape as a whole; what goes wrong with one edge is
///          its `problem`
std::vector<EdgeContinuity> edge_continuity(const TopoDS_Shape& shape,
                                            const ContinuityOptions& options = {});

}  // namespace blossom::occt
