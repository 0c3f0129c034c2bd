// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of a patch between border arcs and straight sides as curved triangles.
//
// The straight sides between the ends of arcs and cells are triangulated first. Each triangle is
// then a map of the degree of its arcs: straight but for the arcs themselves. If no map turns over,
// the triangles together cover the region once, without gaps: the map from the straight
// triangulation is a local homeomorphism, and its border goes once round the region. Where one
// turns over, its arcs are halved, which brings them nearer to their chords.

#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/forms/triangle.h"
#include "core/regions/border_arcs.h"
#include "core/regions/delaunay/triangulation.h"
#include "core/regions/triangle_lowering.h"

namespace blossom {

struct CurvedTriangle {
  std::array<int, 3> vertices;  ///< a, b, c, counter-clockwise
  /// Of the sides a to b, b to c and c to a; -1 for straight ones inside of the region.
  std::array<int, 3> arcs;
  BezierTriangle map;  ///< homogeneous, in the parameters of the patch
  /// The surface over the map, where its degree was lowered: where it had to be, or where the map
  /// is fitted to a trim anyway.
  std::optional<ReducedOf<RationalBezierTriangle>> lowered = {};
};

/// Bound on a negative coefficient of a map's turning_form, in the patch's parameters, that may
/// come of rounding: products of two sides, whose ends are off by a few 2^-53. At the tip between
/// arcs that touch it is 0.
inline constexpr double kTurningError = 4e-15;

struct CurvedTriangles {
  std::vector<CurvedTriangle> triangles;
  std::string obstacle;  ///< why there are none; empty if all is well
};

/// Triangulates what `arcs` and `sides` enclose in one patch, halving arcs as it needs: also until
/// triangles that are lowered are within the tolerance.
///
/// arcs     numbers of the patch's arcs; those that halving makes are added
/// sides    straight, between vertices; the region is on their left
CurvedTriangles curved_triangles(BorderArcs& borders, std::vector<int>& arcs,
                                 const std::vector<BorderSide>& sides, int patch_u, int patch_v,
                                 TriangleLowering& lowering);

}  // namespace blossom
