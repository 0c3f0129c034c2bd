// SPDX-License-Identifier: LGPL-2.1-or-later
// A small software renderer: translucent triangles sorted by depth at every sample, and lines
// that shine through them.
//
// Corners are rounded to 1/256 sample and inside tests are done in integers, so that triangles
// which share a side cover every sample once.

#pragma once

#include <array>
#include <vector>

#include "core/math/vec.h"
#include "plugin/pictures/image/raster/png.h"

namespace blossom::pictures {

/// Colours of the canvas are red, green, blue in [0, 1], sRGB. Places are samples from the left,
/// from the top, and depth; see View.
struct CanvasTriangle {
  std::array<Vec3, 3> corners;
  std::array<Vec3, 3> colours;  ///< shaded, at the corners
  double opacity = 1;
};

struct CanvasLine {
  std::vector<Vec3> points;
  Vec3 colour;
  double width = 2;     ///< samples
  double hidden = 0.5;  ///< how much of it is seen behind opaque faces, 0..1
  double lift = 0;      ///< how far it counts as nearer to the eye, samples
};

struct Canvas {
  int width = 0;  ///< of the image, pixels
  int height = 0;
  std::vector<CanvasTriangle> triangles;
  std::vector<CanvasLine> lines;  ///< later ones are drawn over earlier ones
};

/// Samples per pixel, along each side.
inline constexpr int kSamples = 2;

/// Draws the canvas on a light background.
Image drawn(const Canvas& canvas);

}  // namespace blossom::pictures
