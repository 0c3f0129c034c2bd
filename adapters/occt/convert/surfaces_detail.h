// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps from a surface of Open CASCADE to Bezier patches. For this folder only.

#pragma once

#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Surface.hxx>

#include "adapters/occt/convert/surfaces.h"

namespace blossom::occt {

/// Natural bounds of a surface; without end in periodic directions.
ParameterBox natural_bounds(const Geom_Surface& surface);

/// throws   BadModel if a control point or knot is not finite or a weight is not positive
void check_numbers(const Geom_Surface& surface);

/// The conversions by type. The box is checked; the numbers are.
BezierSurface spline_patches(const Geom_BezierSurface& surface, const ParameterBox& box);
BezierSurface spline_patches(const Geom_BSplineSurface& surface, const ParameterBox& box);
/// Planes, quadrics, tori, extrusions, revolutions and offsets of such; no patches for another
/// type.
BezierSurface swept_patches(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                            double tolerance, ArcCuts cuts = ArcCuts::Even);
/// The offset of an extrusion or a revolution is one, too: only its profile is interpolated. No
/// patches for the offset of another type.
BezierSurface swept_offset(const Handle(Geom_OffsetSurface) & offset, const ParameterBox& box,
                           double tolerance, ArcCuts cuts);
BezierSurface fitted_patches(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                             double tolerance);

}  // namespace blossom::occt
