// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes, cylinders, cones, spheres and tori in surfaces that are written as splines.

#pragma once

#include <optional>

#include "core/forms/elementary.h"
#include "core/forms/surface.h"

namespace blossom {

struct RecognisedSurface {
  Elementary elementary;
  double gap = 0;  ///< bound on the distance of the surface's points from it; model units
};

/// The elementary surface on which all of a surface lies, within a proven bound.
///
/// It is told by the normals n in points p of the surface:
///
///   plane      n is constant
///   cylinder   n is perpendicular to the axis, and p - r n lies on it
///   cone       n makes one angle with the axis, and all tangent planes pass through the apex
///   sphere     p - r n is the centre
///   torus      n meets the axis, and p - r n lies on a circle round it; r is the minor radius
///
/// An axis that all normals meet is the kernel of a linear system, since the line (p, n) meets the
/// line (q, a) where a (p x n) + (q x a) n = 0. The coefficients of the surface's equation, with
/// the patches put in, then bound the distance: no more than |F| / r for F = x^2 + y^2 - r^2, and
/// likewise for the others.
///
/// within    largest gap, model units
/// returns   nothing if there is none, and in doubt: of a cone near its apex, of tori that meet
///           their axis, and of surfaces so small that their normals hardly differ
/// cost      25 points of a surface that is none of these; products of its patches of one that is
///
/// Source: Pottmann and Randrup 1998, for the axis.
std::optional<RecognisedSurface> recognised(const BezierSurface& surface, double within);

}  // namespace blossom
