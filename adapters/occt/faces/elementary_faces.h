// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces on planes, cylinders, cones, spheres and tori, and what two of them have in common by
// closed forms.

#pragma once

#include <optional>

#include <Geom_Surface.hxx>

#include "core/bounds/box_tree.h"
#include "core/forms/elementary.h"
#include "core/results/result.h"

namespace blossom::occt {

/// The elementary surface that a surface is all or part of: Open CASCADE's own, trimmed or not,
/// and surfaces of revolution and of extrusion that it knows as such. Nothing for others.
std::optional<Elementary> elementary_of(const Handle(Geom_Surface) & surface);

/// Radians: planes that cross at less keep within tolerance of each other beside their line for
/// longer than 1e4 tolerances, as what touches does.
inline constexpr double kSlowAngle = 1e-4;

/// The line in which two planes cross, as far as a box holds it and a little more on either end.
///
/// a, b       Geom_Plane, or trimmed ones
/// box        holds what the faces may have in common
/// beyond     the length on either end, model units: it should not be short beside the faces
/// tolerance  within which planes that keep to each other all over the box are one; model units
/// returns    nothing if the planes are one or parallel, if they cross at a small angle beside the
///            box, or the surfaces are not both planes; a result without a curve if the line misses
///            the box
std::optional<SurfaceIntersection> crossing_of_planes(const Handle(Geom_Surface) & a,
                                                      const Handle(Geom_Surface) & b,
                                                      const Box& box, double beyond,
                                                      double tolerance);

}  // namespace blossom::occt
