// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/image/raster/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace blossom::pictures {
namespace {

constexpr int kRowsPerBand = 64;  // sample rows drawn at a time: keeps the layers in cache
constexpr int kLayers = 6;        // surfaces seen behind each other at one sample
constexpr std::int64_t kFine = 256;

constexpr Vec3 kBackgroundTop = {0.945, 0.957, 0.973};
constexpr Vec3 kBackgroundBottom = {0.992, 0.992, 0.992};

struct Layer {
  float depth = 0;
  std::array<float, 3> colour{};
  float opacity = 0;
};

struct Sample {
  std::array<Layer, kLayers> layers;  // the nearest first
  int count = 0;
  float line_depth = 0;
  float line_cover = 0;  // 0 where there is no line
  float line_hidden = 0;
  std::array<float, 3> line_colour{};
};

struct Band {
  int width = 0;
  int first_row = 0;
  int last_row = 0;
  std::vector<Sample> samples;

  Sample& at(int x, int y) {
    return samples[static_cast<std::size_t>(y - first_row) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
  }
};

void add_layer(Sample& sample, const Layer& layer) {
  int place = sample.count;
  while (place > 0 && sample.layers[static_cast<std::size_t>(place - 1)].depth > layer.depth)
    --place;
  if (place == kLayers) return;
  if (sample.count < kLayers) ++sample.count;
  for (int i = sample.count - 1; i > place; --i)
    sample.layers[static_cast<std::size_t>(i)] = sample.layers[static_cast<std::size_t>(i - 1)];
  sample.layers[static_cast<std::size_t>(place)] = layer;
}

struct FinePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

FinePoint fine(const Vec3& p) {
  return {std::llround(p[0] * double(kFine)), std::llround(p[1] * double(kFine))};
}

// Twice the signed area of a triangle.
std::int64_t area(const FinePoint& a, const FinePoint& b, const FinePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Of two triangles on both sides of a line, exactly one owns the samples on it.
bool owns_its_line(const FinePoint& from, const FinePoint& to) {
  return to.y > from.y || (to.y == from.y && to.x < from.x);
}

int clamped(double value, int low, int high) {
  return static_cast<int>(std::clamp(value, double(low), double(high)));
}

void draw(const CanvasTriangle& triangle, Band& band) {
  std::array<int, 3> order = {0, 1, 2};
  std::array<FinePoint, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = fine(triangle.corners[i]);
  std::int64_t whole = area(p[0], p[1], p[2]);
  if (whole == 0) return;
  if (whole < 0) {
    std::swap(p[1], p[2]);
    std::swap(order[1], order[2]);
    whole = -whole;
  }
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  const int x_end = clamped(double(right) / kFine + 1, 0, band.width);
  const int y_end = clamped(double(bottom) / kFine + 1, band.first_row, band.last_row);
  for (int y = clamped(double(top) / kFine - 1, band.first_row, band.last_row); y < y_end; ++y)
    for (int x = clamped(double(left) / kFine - 1, 0, band.width); x < x_end; ++x) {
      const FinePoint here{x * kFine + kFine / 2, y * kFine + kFine / 2};
      Layer layer;
      bool inside = true;
      for (std::size_t i = 0; i < 3 && inside; ++i) {
        const FinePoint &from = p[(i + 1) % 3], &to = p[(i + 2) % 3];
        const std::int64_t part = area(from, to, here);
        inside = part > 0 || (part == 0 && owns_its_line(from, to));
        const float share = static_cast<float>(double(part) / double(whole));
        const std::size_t corner = static_cast<std::size_t>(order[i]);
        layer.depth += share * static_cast<float>(triangle.corners[corner][2]);
        for (int k = 0; k < 3; ++k)
          layer.colour[static_cast<std::size_t>(k)] +=
              share * static_cast<float>(triangle.colours[corner][k]);
      }
      if (!inside) continue;
      layer.opacity = static_cast<float>(triangle.opacity);
      add_layer(band.at(x, y), layer);
    }
}

void draw_segment(const CanvasLine& line, const Vec3& from, const Vec3& to, Band& band) {
  const double reach = line.width / 2 + 1;
  const int x_end = clamped(std::max(from[0], to[0]) + reach, 0, band.width);
  const int y_end = clamped(std::max(from[1], to[1]) + reach, band.first_row, band.last_row);
  const double dx = to[0] - from[0], dy = to[1] - from[1], square = dx * dx + dy * dy;
  const int x_begin = clamped(std::min(from[0], to[0]) - reach, 0, band.width);
  for (int y = clamped(std::min(from[1], to[1]) - reach, band.first_row, band.last_row); y < y_end;
       ++y)
    for (int x = x_begin; x < x_end; ++x) {
      const double px = x + 0.5 - from[0], py = y + 0.5 - from[1];
      const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0.0;
      const double away = std::hypot(px - t * dx, py - t * dy);
      const float cover = static_cast<float>(std::clamp(line.width / 2 - away + 0.5, 0.0, 1.0));
      Sample& sample = band.at(x, y);
      if (cover <= 0 || cover < sample.line_cover) continue;
      sample.line_cover = cover;
      sample.line_depth = static_cast<float>((1 - t) * from[2] + t * to[2] - line.lift);
      sample.line_hidden = static_cast<float>(line.hidden);
      for (int k = 0; k < 3; ++k)
        sample.line_colour[static_cast<std::size_t>(k)] = static_cast<float>(line.colour[k]);
    }
}

Vec3 background(int row, int rows) {
  const double t = double(row) / rows;
  return (1 - t) * kBackgroundTop + t * kBackgroundBottom;
}

// Layers over the background, and the line as far as they let it through.
Vec3 colour_of(const Sample& sample, const Vec3& behind) {
  Vec3 colour;
  double light = 1, light_at_line = 1;
  for (int i = 0; i < sample.count; ++i) {
    const Layer& layer = sample.layers[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k)
      colour[k] += light * layer.opacity * layer.colour[static_cast<std::size_t>(k)];
    light *= 1 - layer.opacity;
    if (layer.depth < sample.line_depth) light_at_line = light;
  }
  colour += light * behind;
  if (sample.line_cover <= 0) return colour;
  const double share =
      sample.line_cover * (sample.line_hidden + (1 - sample.line_hidden) * light_at_line);
  for (int k = 0; k < 3; ++k)
    colour[k] += share * (sample.line_colour[static_cast<std::size_t>(k)] - colour[k]);
  return colour;
}

std::uint8_t byte(double value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

void resolve(Band& band, int rows, Image& image) {
  for (int y = band.first_row / kSamples; y < band.last_row / kSamples; ++y)
    for (int x = 0; x < image.width; ++x) {
      Vec3 sum;
      for (int j = 0; j < kSamples; ++j)
        for (int i = 0; i < kSamples; ++i)
          sum += colour_of(band.at(x * kSamples + i, y * kSamples + j),
                           background(y * kSamples, rows));
      sum *= 1.0 / (kSamples * kSamples);
      image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                   static_cast<std::size_t>(x)] = {byte(sum[0]), byte(sum[1]), byte(sum[2])};
    }
}

}  // namespace

Image drawn(const Canvas& canvas) {
  Image image{canvas.width, canvas.height, {}};
  image.pixels.resize(static_cast<std::size_t>(canvas.width) *
                      static_cast<std::size_t>(canvas.height));
  const int rows = canvas.height * kSamples;
  for (int first = 0; first < rows; first += kRowsPerBand) {
    Band band{canvas.width * kSamples, first, std::min(first + kRowsPerBand, rows), {}};
    band.samples.resize(static_cast<std::size_t>(band.width) *
                        static_cast<std::size_t>(band.last_row - band.first_row));
    for (const CanvasTriangle& triangle : canvas.triangles) draw(triangle, band);
    for (const CanvasLine& line : canvas.lines)
      for (std::size_t i = 1; i < line.points.size(); ++i)
        draw_segment(line, line.points[i - 1], line.points[i], band);
    resolve(band, rows, image);
  }
  return image;
}

}  // namespace blossom::pictures
