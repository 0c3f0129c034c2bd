// SPDX-License-Identifier: LGPL-2.1-or-later
// How the tolerance is shared out among the steps of `watertight`.

#pragma once

namespace blossom {

// Parts of the tolerance. A point of a piece may be off by all of the first four: as a point of a
// polynomial surface, on a side that follows an arc and has a lower degree, in a triangle of a
// lower degree. All are choices; together they are 0.6, and the moves of sides to their common
// curves are measured and have the rest.

/// For polynomials in place of surfaces that are none.
inline constexpr double kSurfacePart = 0.1;

/// For arcs in charts: most of it, since their degree is that of all pieces.
inline constexpr double kArcPart = 0.3;

/// For lower degrees of sides.
inline constexpr double kSideLoweringPart = 0.1;

/// For lower degrees of triangles.
inline constexpr double kTrianglePart = 0.1;

/// Narrower parts of triangles may fold: a thousandth of the tolerance is seen by nobody, and a
/// proof down to rounding would divide every triangle that ends in a tip.
inline constexpr double kFoldPart = 1e-3;

/// Of how far an edge is from its surfaces: what its arcs in their charts may be off. A choice:
/// they follow it ten times as well as it is known.
inline constexpr double kApartPart = 0.1;

/// Moves up to so many times an edge's own distance from its surfaces cannot be helped. A choice:
/// an edge that is off two surfaces by d is at most 2 d of the way from either to a common curve,
/// and samples may miss half of a distance.
inline constexpr double kEdgePart = 4;

}  // namespace blossom
