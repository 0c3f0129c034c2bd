// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts of edges with faces and other edges that are no matter of the tolerance.
//
// A contact is a stretch in which an edge stays within tolerance of the other shape: one place, or
// a run. It is decided if the two have a point in common there by `one_within`, all along if it is
// a run; what is farther off is a contact whose truth is not known.

#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/faces/surface_projector.h"
#include "core/math/interval.h"
#include "core/results/curve_result.h"
#include "core/results/curve_surface_result.h"

namespace blossom::occt {

/// Decides what was found of one pair of shapes.
class ExactMeeting {
 public:
  /// edge     has a curve in space
  /// within   `one_within` of the two, model units
  /// reach    by which the contacts were found, model units
  ExactMeeting(const TopoDS_Edge& edge, double within, double reach)
      : edge_(edge), within_(within), reach_(reach) {}

  /// Whether all contacts with a face are decided. Points in them are on the face for sure, or on
  /// its border.
  bool decides(const CurveSurfaceIntersection& found, const TopoDS_Face& face,
               const SurfaceProjector& feet) const;

  /// Likewise with another edge.
  bool decides(const CurveIntersection& found, const TopoDS_Edge& other) const;

  /// Whether a stretch of the edge lies in a face's surface. Samples tell it of lines and circles
  /// in planes, cylinders, cones, spheres and tori; nothing tells it of others.
  bool lies_in(const TopoDS_Face& face, const SurfaceProjector& feet,
               const Interval& stretch) const;

 private:
  bool is_exact(const CurveSurfacePoint& point, const TopoDS_Face& face) const;
  bool lies_along(const TopoDS_Edge& other, const Interval& stretch) const;

  const TopoDS_Edge& edge_;
  double within_, reach_;
};

}  // namespace blossom::occt
