// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves of edges that meet where the edges do.

#pragma once

#include <cstddef>
#include <vector>

#include <BRep_Curve3D.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// For as long as it lives, the curves of a shape's edges in space end in one point where the edges
/// have a common vertex.
///
/// Edges of loose tolerances have curves that end apart in their vertex. What a reader of files
/// makes of that is its own affair: Open CASCADE takes curves in parameters from those in space and
/// then moves all of each one to close the corner, which changes volumes by the gap times the
/// length. Here the last piece of a curve, about eight gaps long, is bent to the end of another
/// one.
///
/// Gaps below 1e-7 are left as they are, and those above twice the tolerance of their vertex, and
/// curves that are no Bezier or B-spline curves: the others are bent to their ends.
class ClosedCorners {
 public:
  /// The shape is changed, and is as it was when this ends: nobody else may work with it.
  explicit ClosedCorners(const TopoDS_Shape& shape);
  ~ClosedCorners();
  ClosedCorners(const ClosedCorners&) = delete;
  ClosedCorners& operator=(const ClosedCorners&) = delete;

  /// How many ends of curves are bent.
  std::size_t count() const { return given_.size(); }

  /// The largest way of an end, model units.
  double worst() const { return worst_; }

 private:
  struct Given {
    Handle(BRep_Curve3D) of;
    Handle(Geom_Curve) curve;
  };

  void bend(const Handle(BRep_Curve3D) & of, const Handle(Geom_Curve) & curve, double gap);

  double worst_ = 0;
  std::vector<Given> given_;  // in the order in which they were replaced
};

}  // namespace blossom::occt
