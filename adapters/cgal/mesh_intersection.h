// SPDX-License-Identifier: LGPL-2.1-or-later
// Where triangles meet others, and planes: closed polylines of closed meshes, by exact decisions.
//
// All decisions are signs of determinants, taken exactly by CGAL's kernel. Where one is 0 (a corner
// on a triangle, sides that meet, triangles in one plane), the second mesh counts as moved by
// (e, e^2, e^3) with an e below all lengths: a real motion, so that the decisions agree with each
// other and polylines of closed meshes close. After Edelsbrunner and Muecke, Simulation of
// Simplicity, ACM Transactions on Graphics 9 (1990). What depends on the motion is found by moving
// the other way, too.

#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/math/vec.h"

namespace blossom::cgal {

struct MeshCurve {
  std::vector<Vec3> points{};  ///< the first again at the end of a closed one
  bool closed = false;
  double length = 0;  ///< model units
};

struct MeshMeeting {
  std::vector<MeshCurve> curves;
  std::vector<Vec3> points;  ///< where they meet in a point alone
  double rounding = 0;       ///< of the points of curves from where they are exactly, model units
  /// Whether curves are others, or none, when the second is moved by less than any length, or
  /// triangles lie in each other: the meshes touch in more than points.
  bool touching = false;
  std::size_t in_plane = 0;  ///< triangles in the plane, or pairs of them in one plane that overlap
  std::size_t flat = 0;      ///< triangles of no area, which meet nothing here
};

/// Triangles of a mesh. Corners at equal coordinates are one.
struct MeshView {
  std::span<const Vec3> points;  ///< model units
  std::span<const std::array<int, 3>> triangles;
};

/// ask      asked now and then; may throw to end the work
/// throws   InvalidInput if an index is out of range or a coordinate is not finite
/// cost     O(n log n) for n triangles, and what their boxes' meetings take
MeshMeeting intersect_meshes(const MeshView& a, const MeshView& b,
                             const std::function<void()>& ask = {});

/// Likewise with the plane of the points x with normal . (x - point) = 0, as the second.
MeshMeeting section_of_mesh(const MeshView& mesh, const Vec3& point, const Vec3& normal,
                            const std::function<void()>& ask = {});

}  // namespace blossom::cgal
