// SPDX-License-Identifier: LGPL-2.1-or-later
// The software renderer: what is drawn where, and that its PNG files can be read.

#include "plugin/pictures/scene/picture.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "plugin/pictures/image/drawing.h"
#include "plugin/pictures/image/raster/canvas.h"
#include "plugin/pictures/image/raster/png.h"
#include "tests/plugin/cli/program.h"

namespace blossom::cli {
namespace {

using namespace pictures;

constexpr Vec3 kRed = {1, 0, 0};
constexpr Vec3 kBlue = {0, 0, 1};

const Colour& pixel(const Image& image, int x, int y) {
  return image.pixels[static_cast<std::size_t>(y * image.width + x)];
}

CanvasTriangle triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& colour,
                        double opacity) {
  return {{a, b, c}, {colour, colour, colour}, opacity};
}

// A square of 20 samples at a depth, cut along a diagonal.
void add_square(Canvas& canvas, double depth, const Vec3& colour, double opacity) {
  const Vec3 a{10, 10, depth}, b{30, 10, depth}, c{30, 30, depth}, d{10, 30, depth};
  canvas.triangles.push_back(triangle(a, b, c, colour, opacity));
  canvas.triangles.push_back(triangle(a, c, d, colour, opacity));
}

Canvas small_canvas() { return {20, 20, {}, {}}; }

TEST(Canvas, NearerFaceHidesTheOneBehindWhateverTheirOrder) {
  for (const bool near_first : {true, false}) {
    Canvas canvas = small_canvas();
    add_square(canvas, near_first ? 1 : 2, near_first ? kRed : kBlue, 1);
    add_square(canvas, near_first ? 2 : 1, near_first ? kBlue : kRed, 1);
    EXPECT_EQ(pixel(drawn(canvas), 10, 10), (Colour{255, 0, 0}));
  }
}

TEST(Canvas, TranslucentFaceMixesWithTheOneBehind) {
  Canvas canvas = small_canvas();
  add_square(canvas, 1, kRed, 0.25);
  add_square(canvas, 2, kBlue, 1);
  EXPECT_EQ(pixel(drawn(canvas), 10, 10), (Colour{64, 0, 191}));
}

TEST(Canvas, TrianglesThatShareASideLeaveNoSeam) {
  Canvas canvas = small_canvas();
  add_square(canvas, 1, kRed, 0.5);
  Canvas behind = small_canvas();
  add_square(behind, 2, kBlue, 1);
  canvas.triangles.insert(canvas.triangles.end(), behind.triangles.begin(), behind.triangles.end());
  const Image image = drawn(canvas);
  for (int y = 5; y < 15; ++y)
    for (int x = 5; x < 15; ++x) {
      EXPECT_NEAR(pixel(image, x, y).red, 127.5, 1);
      EXPECT_NEAR(pixel(image, x, y).blue, 127.5, 1);
    }
}

TEST(Canvas, FaceEndsAtItsBorder) {
  Canvas canvas = small_canvas();
  add_square(canvas, 1, kRed, 1);
  const Image image = drawn(canvas);
  EXPECT_EQ(pixel(image, 14, 10), (Colour{255, 0, 0}));
  EXPECT_EQ(pixel(image, 15, 10), pixel(image, 19, 10));
  EXPECT_NE(pixel(image, 15, 10), pixel(image, 14, 10));
}

TEST(Canvas, LineBehindAFaceShinesThrough) {
  Canvas canvas = small_canvas();
  add_square(canvas, 1, kBlue, 1);
  CanvasLine line;
  line.points = {{0, 20, 2}, {40, 20, 2}};
  line.colour = kRed;
  line.width = 6;
  line.hidden = 0.25;
  canvas.lines = {line};
  EXPECT_EQ(pixel(drawn(canvas), 10, 10), (Colour{64, 0, 191}));
  canvas.lines[0].lift = 2;
  EXPECT_EQ(pixel(drawn(canvas), 10, 10), (Colour{255, 0, 0}));
}

// Reads back what png_bytes writes: one IDAT, 8 bits, RGB.
Image decoded(const std::string& png) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value * 256 + static_cast<unsigned char>(png[at + i]);
    return value;
  };
  Image image{number(16), number(20), {}};
  const std::size_t data = png.find("IDAT") + 4;
  const std::size_t row_size = static_cast<std::size_t>(image.width) * 3;
  std::vector<unsigned char> raw((row_size + 1) * static_cast<std::size_t>(image.height));
  uLongf size = raw.size();
  EXPECT_EQ(uncompress(raw.data(), &size, reinterpret_cast<const Bytef*>(&png[data]),
                       static_cast<uLong>(number(data - 8))),
            Z_OK);
  EXPECT_EQ(size, raw.size());
  std::vector<int> above(row_size + 3, 0), row(row_size + 3, 0);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    const unsigned char* in = &raw[y * (row_size + 1)];
    for (std::size_t i = 0; i < row_size; ++i) {
      const int a = row[i], b = above[i + 3], c = above[i], p = a + b - c;
      const int nearest = std::min({std::abs(p - a), std::abs(p - b), std::abs(p - c)});
      const int paeth = std::abs(p - a) == nearest ? a : std::abs(p - b) == nearest ? b : c;
      const std::array<int, 5> guess = {0, a, b, (a + b) / 2, paeth};
      row[i + 3] = (in[i + 1] + guess[in[0]]) & 0xFF;
    }
    for (std::size_t x = 0; x < row_size; x += 3)
      image.pixels.push_back({static_cast<std::uint8_t>(row[x + 3]),
                              static_cast<std::uint8_t>(row[x + 4]),
                              static_cast<std::uint8_t>(row[x + 5])});
    above = row;
    std::fill(row.begin(), row.begin() + 3, 0);
    std::fill(above.begin(), above.begin() + 3, 0);
  }
  return image;
}

TEST(Png, ReadsBackAsTheSamePixels) {
  // Rows that are best told from the left, from above, from both and from neither.
  Image image{61, 47, {}};
  unsigned seed = 1;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      seed = seed * 1664525u + 1013904223u;
      const int slope = x < 30 ? 5 * x : 5 * y;
      const int noise = static_cast<int>(seed >> (y % 5 == 0 ? 24 : 30));
      if (y > 40) {  // stripes
        image.pixels.push_back(image.pixels[static_cast<std::size_t>(40 * image.width + x)]);
        continue;
      }
      image.pixels.push_back({static_cast<std::uint8_t>(y < 10 ? 4 * x : slope),
                              static_cast<std::uint8_t>(y < 20 ? 4 * y : 150 - slope / 2),
                              static_cast<std::uint8_t>(noise)});
    }
  const Image back = decoded(png_bytes(image));
  EXPECT_EQ(back.width, 61);
  EXPECT_EQ(back.height, 47);
  EXPECT_TRUE(back.pixels == image.pixels);
}

std::string png_of(const Picture& picture) { return picture_png(picture, scene_meshes(picture)); }

bool is_red(const Colour& c) { return c.red > 150 && c.green < 90 && c.blue < 90; }

TEST(Picture, ShowsFacesAndCurvesInTheWholeFrame) {
  Picture picture;
  picture.groups = {{{testing::bowl()}, kFirstColour, 1}};
  std::vector<Vec3> circle;
  for (int i = 0; i <= 64; ++i)
    circle.push_back({0.5 * std::cos(i * 0.0981747704), 0.5 * std::sin(i * 0.0981747704), 0.25});
  picture.curves = {circle};

  const Image image = decoded(png_of(picture));

  EXPECT_EQ(image.width, 1200);
  EXPECT_EQ(image.height, 900);
  // The near half of the circle is behind the bowl's wall, where it shines through.
  EXPECT_GT(std::ranges::count_if(image.pixels, is_red), 500);
  int left = image.width, right = 0, top = image.height, bottom = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      if (int(pixel(image, x, y).red) + 40 > int(pixel(image, x, y).blue)) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  EXPECT_TRUE(right - left > 0.8 * image.width || bottom - top > 0.8 * image.height);
  EXPECT_GT(left, 0);
  EXPECT_LT(right, image.width - 1);
}

TEST(Picture, IsTheSameBytesEveryTime) {
  Picture picture;
  picture.groups = {{{testing::bowl(), testing::half_pipe()}, kFirstColour, 0.5}};
  EXPECT_TRUE(png_of(picture) == png_of(picture));
}

}  // namespace
}  // namespace blossom::cli
