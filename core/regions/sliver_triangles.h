// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles at borders that are too low in space for what these will be moved by.
//
// A triangle whose side is moved by m turns by about m over its height. Where two sides of it leave
// a border's vertex nearly in one line, it is much lower than it is wide, though there may be room
// behind it: the side opposite to that vertex is flipped then or, where nothing that it may be
// flipped to is better, the region gets a vertex of its own.

#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/forms/evaluation.h"
#include "core/math/vec.h"

namespace blossom {

/// A region's chart as its triangles see it.
struct TriangleChart {
  std::vector<Vec2> points;  ///< of the vertices; those that are added come at the end
  /// The surface's point and first derivatives by the chart's coordinates.
  std::function<PatchJet(const Vec2&)> jet;
  /// How high in space a triangle is to be on the left of the border's side between two vertices;
  /// 0 where that is none, or a point in space. Model units.
  std::function<double(int from, int to)> least_height;
  /// Whether a triangle that goes round counter-clockwise does so with its curved sides, too.
  std::function<bool(const std::array<int, 3>&)> is_valid;
};

/// Raises triangles at borders that are lower than they are to be, as far as the region allows.
///
/// The height of a triangle is the lower one of two: by the surface's first derivatives in the
/// middle of it, as where its corners are in one line on a surface that bends; and of the straight
/// triangle between its corners, as where these are in one line with a pole that is one of them.
///
///   (1) the triangles cover the same region once, and all sides without a triangle behind stay
///   (2) of all that change, the lowest is at least kRaised times as high as before
///   (3) points that are added lie inside of the region
///
/// triangles   counter-clockwise; no two walk from a vertex to the same other one
/// returns     whether there were any
/// cost        O(n log n) for n triangles, few of them low
bool raise_sliver_triangles(std::vector<std::array<int, 3>>& triangles, TriangleChart& chart);

/// What a change of triangles has to bring.
inline constexpr double kRaised = 1.5;

}  // namespace blossom
