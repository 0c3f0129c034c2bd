// SPDX-License-Identifier: LGPL-2.1-or-later
// A parallel view of a scene from a direction, in which the scene fills the frame.

#pragma once

#include <string>
#include <vector>

#include "core/math/vec.h"

namespace blossom::pictures {

struct View {
  Vec3 right;        ///< unit, of the picture
  Vec3 up;           ///< unit, of the picture
  Vec3 forward;      ///< unit, away from the eye
  double scale = 1;  ///< samples per model unit
  double x = 0;      ///< samples of the model's origin from the left border
  double y = 0;      ///< and from the upper border

  /// Samples from the left, samples from the top, depth in samples (larger is farther).
  Vec3 operator()(const Vec3& point) const {
    return {x + scale * dot(point, right), y - scale * dot(point, up), scale * dot(point, forward)};
  }
};

/// The part of an image that the scene may fill, samples.
struct Frame {
  double left = 0, top = 0;
  double width = 1, height = 1;
};

/// The words that name directions: iso, front, back, left, right, top, bottom.
const std::vector<std::string>& view_words();

/// The direction from the scene to the eye, by its word or as "x,y,z".
/// throws   InvalidInput if it is neither, or the zero vector
Vec3 view_direction(const std::string& text);

/// Where a scene is seen from when nobody says: iso, whatever there is; only if its triangles are
/// seen almost edge-on from there, the one of a few fixed directions that sees most of them.
///
/// corners   of all triangles, three after three
Vec3 default_direction(const std::vector<Vec3>& corners);

/// The scene from a direction, z upwards (or y, if the direction is z's).
/// to_eye    any length but zero
View view_from(const Vec3& to_eye, const std::vector<Vec3>& points, const Frame& frame);

}  // namespace blossom::pictures
