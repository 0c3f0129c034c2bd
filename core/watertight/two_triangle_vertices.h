// SPDX-License-Identifier: LGPL-2.1-or-later
// Vertices that only two triangles have, and sides on both sides of an edge between its vertices.

#pragma once

#include "core/watertight/watertight_pieces.h"

namespace blossom {

/// Divides triangles until no vertex on an edge is the tip of just two, one on each side of the
/// edge. Such two have two sides in common: samples of these beside the tip would be corners of one
/// facet of each, and both facets the same. One of the two and the triangle behind it are halved;
/// where both have a rectangle or an edge behind them, the tip stays.
///
/// pieces   before their sides are moved; triangles above kMaxDegree are left as they are
void divide_two_triangle_vertices(WatertightPieces& pieces);

/// Divides chords: sides inside of a face whose ends are both on edges that it has in common with
/// one and the same other face. Where both faces have chords over one stretch of their edges,
/// samples of both may have the same corners, or lie in one plane and cross. Those of the face that
/// leaves its chords more get a vertex in the middle, and both triangles beside them are halved;
/// chords beside a rectangle or a triangle at a pole, or with one triangle on both sides, stay.
///
/// pieces   as divide_two_triangle_vertices
/// cost     O(n log n) for n sides
void divide_facing_chords(WatertightPieces& pieces);

}  // namespace blossom
