// SPDX-License-Identifier: LGPL-2.1-or-later
// A mesh as triangular Bezier patches through its points, with given normals there.
//
// Each side becomes a cubic C through its ends, tangent to the planes of their normals, and each
// triangle three patches of degree 4 that meet in a middle point S. Over a side the derivative
// across it is
//
//   D(u) = k(u) g(u) + h(u) C'(u),   g(u) = (1 - u) g_0 + u g_1,   g_i = n_i x C'(i) normalised,
//
// with k and h linear. Both triangles of a side have the same C and g, so they have one tangent
// plane all along it: G1. Inside, the three patches join with C1. Planes come out exactly. Source:
// Chiyokura, Kimura 1983 (the field g); Shirman, Sequin 1987 (three quartics).

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/forms/triangle.h"
#include "core/math/vec.h"

namespace blossom {

using CornerNormals = std::array<Vec3, 3>;

/// Unit normals of corners: of all triangles round a point that are joined by sides at which they
/// turn by less than `crease`, weighted by their angles there. 0 where these cancel.
///
/// crease   radians
/// ask      asked now and then; may throw to end the work
/// throws   InvalidInput if an index is out of range
std::vector<CornerNormals> corner_normals(std::span<const Vec3> points,
                                          std::span<const std::array<int, 3>> triangles,
                                          double crease, const std::function<void()>& ask = {});

struct SmoothMesh {
  /// Three for each triangle, in its order: over its sides from corner 0, 1 and 2, each with the
  /// corners of the side and S.
  std::vector<BezierTriangle> patches;
  std::size_t smooth_sides = 0;  ///< between two triangles with equal normals at both ends
  std::size_t sharp_sides = 0;   ///< between two others: creases, where patches meet at an angle
  /// Over the smooth ones the largest angle between the normals of both patches, of 7 places each;
  /// radians. It is of rounding, except where a side is so much turned that g vanishes.
  double largest_angle = 0;
};

/// normals   of corners; 0 takes that of the triangle
/// throws    InvalidInput if an index is out of range, or the numbers of triangles and normals
///           differ
SmoothMesh smooth_mesh(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles,
                       std::span<const CornerNormals> normals,
                       const std::function<void()>& ask = {});

}  // namespace blossom
