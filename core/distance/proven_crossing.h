// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether two patches cross near a point, proven at one place of their curve.

#pragma once

#include <functional>

#include "core/forms/patch.h"
#include "core/surfaces/pairs/border_roots.h"

namespace blossom {

/// Looks along the intersection of two patches for a box of their parameters in which they are
/// proven to cross: for some value of one parameter Krawczyk's operator maps the others' ranges
/// into themselves, so there is a common point, and a minor of the Jacobian is regular there, so
/// the normals are not parallel.
///
/// start     parameters, each in the patch's own [0, 1], of points that are near each other
/// counts    whether all of both rectangles of a box belongs to what is asked about
/// returns   false if nothing was found, which says nothing
bool proven_crossing(const RationalBezierPatch& a, const RationalBezierPatch& b,
                     const Point4& start, const std::function<bool(const Box4&)>& counts);

}  // namespace blossom
