// SPDX-License-Identifier: LGPL-2.1-or-later
// What lies over a drawn image: lines, discs, rectangles and letters.

#pragma once

#include <string>
#include <vector>

#include "core/math/vec.h"
#include "plugin/pictures/image/raster/png.h"

namespace blossom::pictures {

/// Draws on an image; places and widths are pixels from the left and from the top, colours sRGB in
/// [0, 1]. What lies outside of the image is left out.
class Overlay {
 public:
  explicit Overlay(Image& image) : image_(image) {}

  /// Polylines as one stroke of a pen with a round tip: where they meet nothing is drawn twice.
  void stroke(const std::vector<std::vector<Vec2>>& lines, double width, const Vec3& colour,
              double opacity = 1);
  void fill(const Vec2& low, const Vec2& high, const Vec3& colour, double opacity = 1);
  void disc(const Vec2& centre, double radius, const Vec3& colour);
  void ring(const Vec2& centre, double radius, double width, const Vec3& colour);

  /// base     where the text begins on its base line
  /// height   of a capital letter
  /// returns  the width of the text
  double write(const std::string& text, const Vec2& base, double height, const Vec3& colour);

 private:
  void blend(int x, int y, const Vec3& colour, double share);

  Image& image_;
};

}  // namespace blossom::pictures
