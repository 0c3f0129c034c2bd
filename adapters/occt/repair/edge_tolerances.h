// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges that state other tolerances than their curves need.

#pragma once

#include <functional>
#include <string>
#include <utility>

#include <NCollection_DataMap.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/shared_parts.h"
#include "adapters/occt/trim_tool.h"
#include "core/base/work_limit.h"

namespace blossom::occt {

/// The tolerance that the curves of an edge ask for on the faces that it bounds, model units; at
/// least Open CASCADE's confusion. The one it has where it lacks a curve, and no less than that at
/// a degenerated edge, which asks for the distances of its images from its vertex.
double needed_tolerance(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces);

/// How far the curves of an edge on these faces end from a vertex of it, as oriented in the edge.
double distance_at(const TopoDS_Vertex& vertex, const TopoDS_Edge& edge,
                   const TopTools_ListOfShape& faces);

/// The tolerance that an edge or vertex states and the one that it needs, model units.
struct NeededTolerance {
  double given = 0;
  double needed = 0;
  double gap = 0;  ///< without a margin: what it cannot do without

  bool is_too_small() const;
  bool is_far_too_large() const;
};

/// What edges and vertices of a shape need, each measured when it is first asked for. What is asked
/// for later is not what it was if curves change meanwhile.
class NeededTolerances {
 public:
  /// parts   of the shape; kept by reference
  /// stop    asked before an edge is measured; ends the work by an exception
  NeededTolerances(const SharedParts& parts, std::function<void()> stop)
      : parts_(parts), stop_(std::move(stop)) {}

  const NeededTolerance& of(const TopoDS_Edge& edge);

  /// No less than that of its edges, whose ends it covers.
  const NeededTolerance& of(const TopoDS_Vertex& vertex);

  void set_stop(std::function<void()> stop) { stop_ = std::move(stop); }

 private:
  using Measured = NCollection_DataMap<TopoDS_Shape, NeededTolerance, TopTools_ShapeMapHasher>;

  NeededTolerance measured(const TopoDS_Vertex& vertex);

  const SharedParts& parts_;
  std::function<void()> stop_;
  Measured known_;
};

/// A solid whose tolerances are true, and what was not so; empty if everything was.
struct TrueSolid {
  TrimTool solid;
  std::string told;
};

/// Raises the tolerances of edges and vertices that are less than the distances of their curves,
/// and lowers those that are more than ten times these: intersections that end on an edge are
/// looked for as far as its tolerance says.
///
/// The given shapes keep theirs: where something is not true, all faces and solids are copies that
/// share the geometry, in the same order.
///
/// solid    a closed one
/// limit    asked before each edge
/// throws   Failure when the limit is reached, or Open CASCADE fails
TrueSolid with_true_tolerances(const TrimTool& solid, const WorkLimit& limit);

}  // namespace blossom::occt
