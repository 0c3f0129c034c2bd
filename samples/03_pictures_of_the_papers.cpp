// SPDX-License-Identifier: LGPL-2.1-or-later
// The pictures of the papers that blossoms come from, drawn anew:
//
//   vlachkova_figure_1.png   S_1 with its control net; S_1 and its part S_2 with both nets
//   vlachkova_figure_2.png   the triangle S_3; S_1 and S_3; the triangle S_4; S_3 and S_4
//   disibuyuk_figure_1.png   a (1/2,3/5)-Bezier cubic, levels 1, 3, 6 of midpoint subdivision
//   disibuyuk_figure_2.png   the same for (-1/2,-2)
//
// usage: 03_pictures_of_the_papers OUT   (the folder that gets them)
// The control polygon of the cubics is not printed; this one is ours.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <TopoDS.hxx>

#include "adapters/occt/shapes.h"
#include "core/blossom/patch_blossom.h"
#include "core/blossom/triangle_blossom.h"
#include "core/papers/q_curve.h"
#include "plugin/nets/net.h"
#include "plugin/nets/net_shapes.h"
#include "plugin/pictures/image/drawing.h"
#include "plugin/pictures/image/raster/canvas.h"
#include "plugin/pictures/scene/picture.h"

namespace {

using namespace blossom;
using namespace blossom::pictures;
using namespace blossom::nets;

constexpr int kWidth = 800, kHeight = 600;  // pixels of one picture

void check(const std::string& what, double found, double wanted, double tolerance) {
  std::cout << what << " = " << found << '\n';
  if (std::abs(found - wanted) <= tolerance) return;
  std::cerr << "that should be " << wanted << " within " << tolerance << '\n';
  std::exit(1);
}

// Pictures of one size in rows of two or three.
Image sheet(const std::vector<Image>& images, int columns) {
  const int rows = static_cast<int>(images.size()) / columns;
  Image all{columns * kWidth, rows * kHeight, {}};
  all.pixels.resize(static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height));
  for (std::size_t k = 0; k < images.size(); ++k) {
    const int left = static_cast<int>(k) % columns * kWidth;
    const int top = static_cast<int>(k) / columns * kHeight;
    for (int y = 0; y < kHeight; ++y)
      std::copy_n(images[k].pixels.begin() + y * kWidth, kWidth,
                  all.pixels.begin() + (top + y) * all.width + left);
  }
  return all;
}

void write_png(const Image& image, const std::filesystem::path& file) {
  blossom::occt::write_text(png_bytes(image), file);
  std::cout << "wrote " << file.filename().string() << '\n';
}

// ---- Vlachkova 2025, examples 1 and 2: one polynomial surface, formulas (9) and (14)

MonomialPatch example_surface() {
  const Vec3 coefficients[4][3] = {
      {{0, 0, 0}, {0, 7.0 / 5, -1}, {0, 3.0 / 5, 1.0 / 5}},
      {{3, 0, 3}, {0, 9.0 / 5, -3}, {0, -24.0 / 5, 27.0 / 5}},
      {{0, 0, -15.0 / 4}, {0, -9.0 / 5, 117.0 / 10}, {0, 39.0 / 5, -141.0 / 10}},
      {{1, 0, 19.0 / 20}, {0, 13.0 / 5, -38.0 / 5}, {0, -23.0 / 5, 179.0 / 20}}};
  MonomialPatch patch{Grid<Vec3>(4, 3)};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) patch.coefficients(i, j) = coefficients[i][j];
  return patch;
}

Vec4 homogeneous(const Vec3& p) { return {p[0], p[1], p[2], 1}; }

Net net_of(const BezierPatch& patch) {
  RationalBezierPatch value{Grid<Vec4>(patch.points.rows(), patch.points.columns())};
  std::ranges::transform(patch.points.values(), value.points.values().begin(), homogeneous);
  Net net;
  net.value = std::move(value);
  return net;
}

Net net_of(const BezierTriangle& triangle) {
  RationalBezierTriangle value{triangle.degree, std::vector<Vec4>(triangle.points.size())};
  std::ranges::transform(triangle.points, value.points.begin(), homogeneous);
  Net net;
  net.value = std::move(value);
  return net;
}

// A surface to be drawn, with or without its control net. Pieces of one surface are drawn beside
// each other, never one on the other.
struct Shown {
  Net net;
  Vec3 colour;
  bool with_face = true;
  bool with_net = true;
};

Image image_of(const std::vector<Shown>& all) {
  Picture picture;
  picture.width = kWidth;
  picture.height = kHeight;
  for (const Shown& shown : all) {
    if (shown.with_face)
      picture.groups.push_back({{TopoDS::Face(net_shape(shown.net))}, shown.colour});
    if (!shown.with_net) continue;
    for (auto& line : net_lines(shown.net)) {
      picture.points.insert(picture.points.end(), line.begin(), line.end());
      picture.curves.push_back(std::move(line));
    }
  }
  return picture_image(picture, scene_meshes(picture));
}

Shown without_face(Shown shown) {
  shown.with_face = false;
  return shown;
}

void draw_figure_1(const MonomialPatch& surface, const std::filesystem::path& out) {
  const Interval u{1.0 / 3, 2.0 / 3}, v{1.0 / 4, 3.0 / 4};
  const BezierPatch s1 = bezier_points(surface, {0, 1}, {0, 1});
  const BezierPatch s2 = bezier_points(surface, u, v);
  check("y of p_00 of S_2", s2.points(0, 0)[1], 983.0 / 2160, 1e-15);  // Table 1
  check("z of p_32 of S_1", s1.points(3, 2)[2], 0.75, 1e-14);

  const Shown whole{net_of(s1), kFirstColour};
  std::vector<Shown> parts = {without_face(whole), {net_of(s2), kSecondColour}};
  const Interval around[4][2] = {
      {{0, u.from}, {0, 1}}, {{u.to, 1}, {0, 1}}, {u, {0, v.from}}, {u, {v.to, 1}}};
  for (const auto& [along_u, along_v] : around)
    parts.push_back({net_of(bezier_points(surface, along_u, along_v)), kFirstColour, true, false});
  write_png(sheet({image_of({whole}), image_of(parts)}, 2), out / "vlachkova_figure_1.png");
}

void draw_figure_2(const MonomialPatch& surface, const std::filesystem::path& out) {
  const Vec2 a{0, 0}, b{1, 0}, c{0, 1};
  const Vec2 ab{0.5, 0}, bc{0.5, 0.5}, ca{0, 0.5};  // the corners of S_4
  const BezierTriangle s3 = bezier_points(surface, {a, b, c});
  const BezierTriangle s4 = bezier_points(surface, {ca, ab, bc});
  check("z of S_3 at (1, 0)", s3(0, 5)[2], 0.2, 1e-15);  // Table 2, in its own order of indices
  check("z of S_4 at (1/2, 1/2)", s4(0, 0)[2], 347.0 / 640, 1e-15);

  const auto rest = [&](const TriangleCorners& corners, const Vec3& colour) {
    return Shown{net_of(bezier_points(surface, corners)), colour, true, false};
  };
  const Shown large{net_of(s3), kSecondColour}, small{net_of(s4), kFirstColour};
  const std::vector<Shown> both = {without_face(large), small, rest({a, ab, ca}, kSecondColour),
                                   rest({ab, b, bc}, kSecondColour),
                                   rest({ca, bc, c}, kSecondColour)};
  write_png(sheet({image_of({large}), image_of({large, rest({Vec2{1, 1}, c, b}, kFirstColour)}),
                   image_of({small}), image_of(both)},
                  2),
            out / "vlachkova_figure_2.png");
}

// ---- Disibuyuk 2022, figures 1 and 2: control polygons of midpoint subdivision

using QCurve2 = QBezierCurveOf<Vec2>;

// The largest distance of a control point from the curve at the parameter k / n of its piece.
double polygon_distance(const QCurve2& curve, int levels) {
  double largest = 0;
  for (const QCurve2& piece : midpoint_pieces(curve, levels))
    for (int k = 0; k <= piece.degree(); ++k) {
      const double x = at(piece.interval, static_cast<double>(k) / piece.degree());
      largest = std::max(largest,
                         distance(piece.points[static_cast<std::size_t>(k)], point_at(curve, x)));
    }
  return largest;
}

// Model units to samples: x from 0 to 4, y from 0 to 2, with a margin.
Vec3 on_canvas(const Vec2& p) {
  constexpr double kMargin = 60, kScale = (kWidth - 2 * kMargin) / 4;
  return Vec3{kMargin + kScale * p[0], kHeight / 2 + kScale * (1 - p[1]), 0} * kSamples;
}

CanvasLine line_of(const std::vector<Vec2>& points, const Vec3& colour, double width) {
  CanvasLine line;
  for (const Vec2& p : points) line.points.push_back(on_canvas(p));
  line.colour = colour;
  line.width = width * kSamples;
  return line;
}

Image polygons_image(const QCurve2& curve, int levels) {
  constexpr int kFine = 256;
  constexpr Vec3 kGrey = {0.6, 0.64, 0.7};
  Canvas canvas{kWidth, kHeight, {}, {}};
  canvas.lines.push_back(line_of(curve.points, kGrey, 2.5));
  std::vector<Vec2> fine;
  for (int k = 0; k <= kFine; ++k)
    fine.push_back(point_at(curve, at(curve.interval, static_cast<double>(k) / kFine)));
  canvas.lines.push_back(line_of(fine, kFirstColour, 9));
  for (const QCurve2& piece : midpoint_pieces(curve, levels)) {
    canvas.lines.push_back(line_of(piece.points, kCurveColour, 2.5));
    if (levels > 3) continue;
    for (const Vec2& p : piece.points) canvas.lines.push_back(line_of({p, p}, kCurveColour, 10));
  }
  return drawn(canvas);
}

void draw_cubic(const std::string& name, const QParameters& q, const std::filesystem::path& out) {
  const QCurve2 curve{{{0, 0}, {1, 2}, {3, 2}, {4, 0}}, {0, 1}, q};
  check(name + ": distance of level 5 over that of level 6",
        polygon_distance(curve, 5) / polygon_distance(curve, 6), 2, 0.1);
  write_png(
      sheet({polygons_image(curve, 1), polygons_image(curve, 3), polygons_image(curve, 6)}, 3),
      out / (name + ".png"));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: 03_pictures_of_the_papers OUT\n";
    return 2;
  }
  const std::filesystem::path out = argv[1];
  try {
    std::filesystem::create_directories(out);
    draw_figure_1(example_surface(), out);
    draw_figure_2(example_surface(), out);
    draw_cubic("disibuyuk_figure_1", {0.5, 0.6}, out);
    draw_cubic("disibuyuk_figure_2", {-0.5, -2}, out);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
