// SPDX-License-Identifier: LGPL-2.1-or-later
// The area of trimmed faces and the volume under them, accurate enough to see that pieces add up.

#pragma once

#include <span>

#include <TopoDS_Face.hxx>

#include "core/math/vec.h"

namespace blossom::occt {

/// The area of a face, square model units.
///
///   A = integral over the face's chart of |S_u x S_v| = integral along its wires of F dv,
///   F(u, v) = integral from the chart's left end to u of |S_u x S_v|(s, v) ds   (Green)
///
/// Both integrals are adaptive and start from cells between the knots.
///
/// cells     cells that each span starts with; more of them check the result
/// accuracy  1e-10 relative where the surface is smooth between its knots; gaps of wires in the
///           chart within the edges' tolerances count for what they are
/// throws    BadModel if the face has no wire or an edge has no pcurve
///
/// Source: Green's theorem; `core/math/functions/quadrature.h`.
double area(const TopoDS_Face& face, int cells = 1);

/// The volume of the cone from a point over a face, cubic model units; negative where the oriented
/// normal points to the apex. The cones of a closed shell add up to the volume that it encloses.
///
///   V = integral over the chart of (S - apex) . (S_u x S_v) / 3
///
/// enough     an error that does not matter, of each of the integrals that are added up, cubic
/// model
///            units; 0: none
/// accuracy   as the area, relative to the integral of the integrand's absolute value, and 1e-12 of
///            the area times the coordinates
/// throws     as area
double cone_volume(const TopoDS_Face& face, const Vec3& apex, double enough = 0);

/// The volume of the cone over the strips between a face and its edges' curves
/// (faces/border_strips.h), with the sign of the face's own cone. With them the sum over a closed
/// shell does not depend on the apex where its edges have a tolerance; without them pieces of a
/// face add up to it. throws     as area
double cone_volume_beside(const TopoDS_Face& face, const Vec3& apex);

/// Moments of the cone from a point over a face, with the sign of its volume. Those of the cones of
/// a closed shell add up to those of what it encloses, with the strips of `cone_volume_beside`.
///
///   first    integral of r over the cone      = integral over the chart of 3/4 s  (s . N) / 3
///   second   integral of r r^T over the cone  = integral over the chart of 3/5 s s^T (s . N) / 3
///
/// where r and s = S - apex are taken from the apex, and N = S_u x S_v.
struct ConeMoments {
  double volume = 0;      ///< cubic model units
  Vec3 first;             ///< model units^4
  Vec<double, 6> second;  ///< model units^5: xx, yy, zz, xy, xz, yz
};

/// accuracy   1e-10 of the integrals of the integrands' absolute values, as the area
/// throws     as area
ConeMoments cone_moments(const TopoDS_Face& face, const Vec3& apex);

/// The integral over a face of S - origin, model units^3: its area times what its centre is from
/// there.
/// accuracy, throws   as cone_moments
Vec3 area_moment(const TopoDS_Face& face, const Vec3& origin);

/// About the area within a closed polygon in the parameters of a face's surface, for summaries.
///
///   A = sum over the fan of triangles from the first corner of the integral of |S_u x S_v|, with
///       the triangles' signs
///
/// polygon   repeats its first corner; several loops one after the other as `joined_loops` makes
/// accuracy  that of the polygon, and of taking the middle line of each triangle for all of it
double polygon_area(const TopoDS_Face& face, std::span<const Vec2> polygon);

}  // namespace blossom::occt
