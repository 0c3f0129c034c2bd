// SPDX-License-Identifier: LGPL-2.1-or-later
// Places of contacts that are known by points of them.

#pragma once

#include <vector>

#include "core/results/result.h"

namespace blossom {

/// The reason of a result that has contacts among its places.
inline constexpr const char* kTouchInPlaces =
    "the surfaces touch, or nearly, in the listed contacts";

/// A place that holds points of both surfaces, with their parameters.
/// gap      the largest distance of the surfaces in it, model units
/// margin   by which it is wider than the points, model units
Place place_of(const std::vector<SurfacePoint>& points, PlaceKind kind, double gap, double margin);

/// How far from a point of an intersection that may be which it stands for: as far as the place of
/// a contact goes that holds it; model units.
double contact_reach(const SurfaceIntersection& found, const Vec3& point);

}  // namespace blossom
