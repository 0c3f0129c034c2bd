// SPDX-License-Identifier: LGPL-2.1-or-later
// How far flat facets are from planes, cylinders, cones, spheres and tori: the distance from these
// surfaces is known in closed form.

#pragma once

#include <array>

#include "core/forms/elementary.h"
#include "core/math/vec.h"
#include "core/tessellation/charts/curvature_sample.h"
#include "core/tessellation/charts/jet_enclosure.h"

namespace blossom {

/// The point, and the unit normal along S_u x S_v (where that is not 0).
PointNormal frame_at(const ElementaryChart& chart, const Vec2& uv);

/// Normal curvatures and lengths at a point.
CurvatureSample curvature_at(const ElementaryChart& chart, const Vec2& uv);

/// A bound on the distance of each point of a facet from the surface, and, where facets cover a
/// region once, of each point of the region from them.
///
///   cylinder   R (1 - cos(w / 2)), w the width of the facet in u
///   cone       the largest (R + v sin a) (1 - cos(u - u_m)) cos a of a corner, u_m their middle
///   sphere     R minus the distance of the facet from the centre
///   torus      with d = (R + r c) (1 - cos(w / 2)), h the width in v, c and s the largest cos v
///   and
///              -cos v, the larger one of r (1 - cos(h / 2)) + d c and d s + d^2 / (2 r cos(h /
///              2)); or by second derivatives (jet_enclosure.h), if that is less
///
/// corners    on the surface; two may be equal
double facet_distance(const ElementaryChart& chart, const std::array<Vec2, 3>& corners);

}  // namespace blossom
