// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/image/overlay.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/math/segment.h"
#include "plugin/pictures/image/raster/lettering.h"

namespace blossom::pictures {
namespace {

constexpr double kPen = 0.16;  // width of a letter's strokes, of its height

// How much of a pixel is within `reach` of something that is `away`.
double cover(double reach, double away) { return std::clamp(reach - away + 0.5, 0.0, 1.0); }

struct PixelRange {
  int from = 0, to = 0;
};

PixelRange pixels(double low, double high, int count) {
  return {static_cast<int>(std::clamp(std::floor(low), 0.0, double(count))),
          static_cast<int>(std::clamp(std::ceil(high), 0.0, double(count)))};
}

std::uint8_t mixed(std::uint8_t below, double above, double share) {
  return static_cast<std::uint8_t>(
      std::lround((1 - share) * below + share * 255 * std::clamp(above, 0.0, 1.0)));
}

}  // namespace

void Overlay::blend(int x, int y, const Vec3& colour, double share) {
  Colour& pixel =
      image_.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                    static_cast<std::size_t>(x)];
  pixel = {mixed(pixel.red, colour[0], share), mixed(pixel.green, colour[1], share),
           mixed(pixel.blue, colour[2], share)};
}

void Overlay::stroke(const std::vector<std::vector<Vec2>>& lines, double width, const Vec3& colour,
                     double opacity) {
  const double reach = width / 2;
  Vec2 low = {kInfinity, kInfinity}, high = {-kInfinity, -kInfinity};
  for (const std::vector<Vec2>& line : lines)
    for (const Vec2& p : line)
      for (int k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], p[k] - reach - 1);
        high[k] = std::max(high[k], p[k] + reach + 1);
      }
  if (lines.empty()) return;
  const PixelRange columns = pixels(low[0], high[0], image_.width);
  const PixelRange rows = pixels(low[1], high[1], image_.height);
  for (int y = rows.from; y < rows.to; ++y)
    for (int x = columns.from; x < columns.to; ++x) {
      double away = kInfinity;
      const Vec2 here = {x + 0.5, y + 0.5};
      for (const std::vector<Vec2>& line : lines) {
        if (line.size() == 1) away = std::min(away, norm(here - line.front()));
        for (std::size_t i = 1; i < line.size(); ++i)
          away = std::min(away, segment_gap(here, line[i - 1], line[i]));
      }
      if (const double share = cover(reach, away); share > 0) blend(x, y, colour, opacity * share);
    }
}

void Overlay::fill(const Vec2& low, const Vec2& high, const Vec3& colour, double opacity) {
  const PixelRange columns = pixels(std::round(low[0]), std::round(high[0]), image_.width);
  const PixelRange rows = pixels(std::round(low[1]), std::round(high[1]), image_.height);
  for (int y = rows.from; y < rows.to; ++y)
    for (int x = columns.from; x < columns.to; ++x) blend(x, y, colour, opacity);
}

void Overlay::disc(const Vec2& centre, double radius, const Vec3& colour) {
  stroke({{centre}}, 2 * radius, colour);
}

void Overlay::ring(const Vec2& centre, double radius, double width, const Vec3& colour) {
  const double reach = radius + width / 2 + 1;
  const PixelRange columns = pixels(centre[0] - reach, centre[0] + reach, image_.width);
  const PixelRange rows = pixels(centre[1] - reach, centre[1] + reach, image_.height);
  for (int y = rows.from; y < rows.to; ++y)
    for (int x = columns.from; x < columns.to; ++x) {
      const double away = std::abs(norm(Vec2{x + 0.5, y + 0.5} - centre) - radius);
      if (const double share = cover(width / 2, away); share > 0) blend(x, y, colour, share);
    }
}

double Overlay::write(const std::string& text, const Vec2& base, double height,
                      const Vec3& colour) {
  const Lettering letters = lettering_of(text, height);
  // Stroke after stroke: a pixel is compared to few segments. They are dark on light, so that what
  // two strokes share looks as one.
  for (std::vector<Vec2> line : letters.strokes) {
    for (Vec2& p : line) p = p + base;
    stroke({line}, std::max(1.0, kPen * height), colour);
  }
  return letters.width;
}

}  // namespace blossom::pictures
