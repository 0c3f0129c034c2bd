// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangular patches as tensor-product patches, for formats that know no others, and back.
//
// A triangle is one tensor-product patch with a side collapsed to a point, three regular ones that
// meet in its middle, or half of a regular one that goes on beyond it; all exactly. The other way,
// a patch is two triangles of degree n + m: `core/subdivision/triangle_subdivision.h`.

#pragma once

#include <array>

#include "core/forms/patch.h"
#include "core/forms/triangle.h"
#include "core/math/roundoff.h"

namespace blossom {

/// The triangle as one patch of bidegree (N, N): T(u (1 - v), u v) in barycentric (x, y).
///
///   (1) the row u = 0 is the vertex c, N + 1 times, bit for bit
///   (2) row i has degree i in v: layer q_{i 0}, .., q_{0 i} with its degree raised to N
///
/// u = 1 is the side from a (v = 0) to b (v = 1).
///
/// throws       InvalidInput if the degree is not 0..kMaxDegree, or the number of points does not
///              fit it
/// accuracy     elevation_error(N), relative to the largest coordinate
///
/// Source: the binomial theorem, layer by layer; Farin 2002 for triangles.
template <class Point>
BezierPatchOf<Point> collapsed_patch(const BezierTriangleOf<Point>& triangle);

/// A triangle and how far the patch is from it.
template <class Point>
struct TriangleOfPatch {
  BezierTriangleOf<Point> triangle;
  double error = 0;  ///< bound on the distance to collapsed_patch(triangle), model units
};

/// The triangle whose layers are the patch's rows, brought to the degrees of layers by `elevated`
/// and `reduced`: undoes collapsed_patch. The degree is the patch's in u.
///
/// patch        side u = 0 should be a point, and row i have degree i in v; the error says by how
///              much they do not. Rows of lower degree in v are elevated
/// throws       InvalidInput if a degree is not 0..kMaxDegree
template <class Point>
TriangleOfPatch<Point> triangle_of(const BezierPatchOf<Point>& patch);

/// The triangle as three patches of bidegree (N, N), at the vertices a, b, c in this order.
///
/// Each has its vertex at (0, 0), the middle of the next side (a to b to c) at (1, 0), that of the
/// previous side at (0, 1), and the triangle's middle at (1, 1); bilinear in between. u x v
/// turns as (b - a) x (c - a).
///
/// throws       as collapsed_patch
/// accuracy     three_quads_error(N), relative to the largest coordinate
/// cost         O(N^6)
///
/// Source: DeRose, Goldman, Hagen, Mann 1993.
template <class Point>
std::array<BezierPatchOf<Point>, 3> three_quads(const BezierTriangleOf<Point>& triangle);

/// The triangle's polynomial as one patch of bidegree (N, N): T(u, v) in barycentric (x, y). The
/// triangle is the half with u + v <= 1, and the patch as regular there as the triangle is.
///
///   (1) v = 0 is the side from c to a, u = 0 that from c to b: its points, bit for bit
///
///   p_ij = sum_m binom(i, m) binom(N - i, j - m) / binom(N, j) t((1, 1)^m, a^(i-m), b^(j-m), c..)
///
/// throws       as collapsed_patch
/// accuracy     half_patch_error(N) in that half, relative to the largest coordinate; the net
///              beyond it may be 3^N times as large
///
/// Source: the blossom of degree (N, N) is the mean of t over all pairings of the two parameters.
template <class Point>
BezierPatchOf<Point> half_patch(const BezierTriangleOf<Point>& triangle);

/// Bound on the error of half_patch where u + v <= 1. A point with m parameters (1, 1) is off by 5
/// m roundings of at most 3^m, and 6 of its factor and sum; m is binomial with mean N u v <= N / 4,
/// so that 3^m comes to (1 + 2 u v)^N.
double half_patch_error(int degree);

/// Bound on the error of three_quads. A blossom has N levels of 5 roundings, whose argument, a
/// third, is off by one rounding more; up to N / 2 + 1 terms, their products and the division 4.
constexpr double three_quads_error(int degree) { return (6.5 * degree + 5) * kUnitRoundoff; }

}  // namespace blossom
