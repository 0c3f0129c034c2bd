// SPDX-License-Identifier: LGPL-2.1-or-later
// The user's wishes: what counts as equal.

#pragma once

#include <algorithm>

namespace blossom {

/// What counts as equal. Pass one of these, never a bare double. The default is
/// that of Open CASCADE's `Precision`, so a model means the same on both sides.
struct Tolerances {
  /// Two points closer than this are one point. Model units.
  double point = 1e-7;
};

/// What differs by no more than this is one: surfaces, over the faces in question, edges along
/// their common run, and a vertex and what it lies on.
///
///   one_within = min(point / 1000 + 1e-11 L, point / 8)
///
/// L is the largest coordinate of the faces, model units. Open CASCADE writes 12 decimals of
/// directions and coordinates to STEP, so a plane that two files share is off by about 2e-12 L, and
/// a placement adds a few roundings; both fit in five times. What is farther apart, but still
/// within tolerance, is a contact whose truth is not known.
constexpr double one_within(const Tolerances& tolerances, double largest_coordinate) {
  return std::min(tolerances.point / 1000 + 1e-11 * largest_coordinate, tolerances.point / 8);
}

}  // namespace blossom
