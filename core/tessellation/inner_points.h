// SPDX-License-Identifier: LGPL-2.1-or-later
// Points inside of a face, in rows.

#pragma once

#include <vector>

#include "core/math/vec.h"
#include "core/tessellation/chart_surface.h"

namespace blossom {

/// Rows over a rectangle of parameters: as far apart as the densest place along them wants, with
/// points along each row as its own places want, those of every other row in the gaps of its
/// neighbours. Where a half, a quarter, ... of the rows is enough, the others have no points. Rows
/// run along u or v, whichever takes fewer points, to and fro. None lies on the rectangle's border.
std::vector<Vec2> points_in_rows(const FacetDensity& density, const Vec2& low, const Vec2& high);

/// The density at a place.
Vec2 facets_at(const FacetDensity& density, const Vec2& uv);

}  // namespace blossom
