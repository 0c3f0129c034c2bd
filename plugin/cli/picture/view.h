// SPDX-License-Identifier: LGPL-2.1-or-later
// A parallel view of a scene, chosen so that the scene fills the frame.

#pragma once

#include <array>
#include <vector>

#include "core/math/vec.h"

namespace blossom::cli {

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

/// The best of a fixed set of directions: the more of the frame the triangles cover and the less
/// the lines are foreshortened, the better.
///
/// corners        of all triangles, three after three
/// lines          the polylines that matter
/// width, height  of the frame, samples
View chosen_view(const std::vector<Vec3>& corners, const std::vector<std::vector<Vec3>>& lines,
                 int width, int height);

}  // namespace blossom::cli
