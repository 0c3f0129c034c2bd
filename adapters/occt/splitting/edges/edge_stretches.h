// SPDX-License-Identifier: LGPL-2.1-or-later
// Stretches of edges beside surfaces and other edges: which of them lie there, and which pass by.

#pragma once

#include <optional>
#include <vector>

#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

#include "adapters/occt/faces/surface_projector.h"
#include "core/math/interval.h"
#include "core/results/curve_surface_result.h"
#include "core/results/result.h"

namespace blossom::occt {

struct RangedCurve {
  Handle(Geom_Curve) curve;
  Interval range;
};

RangedCurve curve_of(const TopoDS_Edge& edge);

struct EdgeFoot {
  double parameter = 0;
  double distance = 0;
};

/// The nearest point of an edge's curve within its range, ends among them.
EdgeFoot foot_on(const RangedCurve& of, const gp_Pnt& point);

/// Whether a stretch is no longer than that of a touch may be, with a radius as long as the curve:
/// what stays near for longer touches in no place of its own.
bool is_short(const RangedCurve& of, const Interval& stretch, double tolerance);

/// Whether an edge only passes a surface in a stretch within reach of it: no longer than a touch
/// may be, and ended by leaving the surface rather than the face or by the end of the edge.
bool passes(const RangedCurve& of, const Interval& stretch, const SurfaceProjector& feet,
            double reach);

/// Whether an edge is within reach of a surface all along a stretch, by samples.
bool keeps_on(const RangedCurve& of, const Interval& stretch, const SurfaceProjector& feet,
              double reach);

/// The stretches of an edge that are one place, in which it touches a face and crosses it twice by
/// what the two are off: a touch, between two roots, or from a root to an end of the edge. They are
/// short, and the edge does not leave the surface in them.
/// points      that the edge has in common with the face, by their parameters
/// tolerance   by which they were found, model units
/// within      how far off the surface is still on it, model units
std::vector<Interval> one_places(const RangedCurve& of, const TopoDS_Face& face,
                                 const std::vector<CurveSurfacePoint>& points, double tolerance,
                                 double within);

/// The stretch of an edge that runs along all of a short one of another edge, by samples; nothing
/// if it comes to be farther than `within` from it.
std::optional<Interval> stretch_beside(const RangedCurve& along, const RangedCurve& of,
                                       const Interval& stretch, double within);

/// The stretch of an edge that goes through a node of an intersection: what ends there, in
/// different points of it, is one place; nothing if it goes past. No longer than a touch may be.
std::optional<Interval> stretch_in_node(const RangedCurve& of, const Place& node, double tolerance);

/// Whether a curve lies in a surface from end to end, by points at uneven distances, so that one
/// that only crosses it again and again does not seem to.
bool lies_throughout(const RangedCurve& of, const SurfaceProjector& feet, double reach);

/// A stretch that goes on by a length at both ends; model units.
Interval widened_by(const RangedCurve& of, const Interval& stretch, double length);

/// How far apart two edges may be by what they state; none counts for more than a part of its
/// length. Model units.
double stated_together(const TopoDS_Edge& a, const TopoDS_Edge& b);

/// Whether one of the edges stands for a contact: all along the curve its foot is beside it, no
/// farther off than surfaces that touch may stay together, and within tolerance of both surfaces,
/// so that these are one from the contact to the edge.
///
/// curve   tangential
/// edges   of one of the faces
bool stands_for_contact(const std::vector<TopoDS_Edge>& edges, const IntersectionCurve& curve,
                        const SurfaceProjector& on_a, const SurfaceProjector& on_b,
                        double tolerance);

}  // namespace blossom::occt
