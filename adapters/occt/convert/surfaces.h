// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces and faces of Open CASCADE to core forms and back.

#pragma once

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "core/base/tolerances.h"
#include "core/forms/patch.h"
#include "core/forms/spans/arc_spans.h"
#include "core/forms/surface.h"
#include "core/math/interval.h"

namespace blossom::occt {

/// Ranges of a surface's own parameters.
struct ParameterBox {
  Interval u;
  Interval v;
};

/// The Bezier points of a Bezier surface: bit for bit when it is polynomial, else (wx, wy, wz, w).
///
/// There and back gives the same bits when the surface is polynomial or its weights are powers of
/// two. Other weights come back bit for bit, coordinates as far as some double divided by w gives
/// them (9 of 10 do), else one unit in the last place off; once more changes nothing.
/// throws   BadModel if a number is not finite or a weight is not positive
RationalBezierPatch from_occt(const Geom_BezierSurface& surface);

/// A Bezier surface with the same points; polynomial, and bit for bit, when all weights are 1.
/// throws   Failure if Open CASCADE refuses the points: degree 0 or above kMaxDegree
Handle(Geom_BezierSurface) to_occt(const RationalBezierPatch& patch);

/// Any surface over a finite box of its own parameters as a grid of Bezier patches: B-splines
/// (periodic, unclamped, rational) split at their knots, planes, quadrics, tori, surfaces of
/// extrusion and revolution exactly, the rest (offset surfaces, say) within `tolerance`
/// (model units). The parameters are the surface's own.
///
///   (1) point_at(result, uv) == surface->Value(u, v) to rounding, or to `error`
///   (2) neighbouring patches share their border's points bit for bit
///   (3) a Bezier surface over its whole domain gives its very points
///
/// `error` of the result is 0 for exact types, else twice the largest distance sampled. Where a
/// surface is so wild that 96 spans in a direction are not enough, it is above `tolerance`.
/// Nothing lies outside of natural bounds: a box that leaves them by more than rounding is refused.
/// throws   BadModel if the box is not finite, empty or outside, a number is not finite or a
///          weight not positive
BezierSurface bezier_surface(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                             double tolerance = Tolerances{}.point, ArcCuts cuts = ArcCuts::Even);

/// The surface under a face over the box of the face's trims, in model space (the face's
/// location applied).
BezierSurface bezier_surface(const TopoDS_Face& face, double tolerance = Tolerances{}.point);

/// The parameter box of a face's trims, clipped to the surface's natural bounds. Borders within
/// 1e-9 of the range from a natural bound, a seam or a whole turn lie exactly there, and within
/// 1e-10 exactly on a knot.
/// throws   BadModel if the face has no surface or the box is empty or not finite
ParameterBox parameter_box(const TopoDS_Face& face);

/// The same where the box of the wires' parametric curves, in the surface's parameters, is known.
ParameterBox parameter_box(const TopoDS_Face& face, const ParameterBox& of_wires);

/// The surface under all rectangular trims; they do not change its parameters.
Handle(Geom_Surface) basis_of(Handle(Geom_Surface) surface);

/// The surface as one B-spline surface (knots of the grid, full inner multiplicity).
/// Laws of angles are lost: the parameters between knots are then those of the rational form.
Handle(Geom_BSplineSurface) to_occt(const BezierSurface& surface);

}  // namespace blossom::occt
