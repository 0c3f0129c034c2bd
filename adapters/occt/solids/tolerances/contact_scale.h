// SPDX-License-Identifier: LGPL-2.1-or-later
// How near the edges and vertices of two solids come to each other, and what follows for the
// distance at which things are one.

#pragma once

#include <vector>

#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/trim_tool.h"

namespace blossom::occt {

/// Distances, model units and increasing, of vertices and edges of each solid from vertices, edges
/// and faces of the other one, where they are nearest to each other: 0 or more, and those within
/// `reach` alone. Faces count with all of their surface near them.
std::vector<double> contact_gaps(const TrimTool& a, const TrimTool& b, double reach,
                                 const SharedLimit& limit);

/// The distance at which things are one, where the gaps leave it open.
///
/// Dividing faces may take what is as near as `kLooseReach` tolerances to an edge or a surface
/// for being on it, while the intersection of faces tells apart what is farther than one: a gap
/// between the two is both. Between neighbouring gaps the tolerance makes no difference to what is
/// one, and the farther it is from both, the less depends on rounding.
///
/// gaps      increasing; at least all up to the square of `kLooseReach` in tolerances
/// returns   the geometric mean of the ends of the widest range, by their ratio, without gaps
///           above the tolerance that begins within `kLooseReach` of it; no more than that, or
///           than what covers a gap as wide as that
double contact_scale(const std::vector<double>& gaps, double tolerance);

}  // namespace blossom::occt
