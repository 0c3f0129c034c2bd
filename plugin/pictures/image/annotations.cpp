// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/image/annotations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "plugin/pictures/image/overlay.h"
#include "plugin/pictures/image/raster/canvas.h"
#include "plugin/pictures/image/raster/lettering.h"
#include "plugin/reports/text/number_text.h"

namespace blossom::pictures {
namespace {

constexpr Vec3 kInk = {0.13, 0.16, 0.20};
constexpr Vec3 kPaper = {1, 1, 1};
constexpr std::array<Vec3, 3> kAxisColours = {Vec3{0.80, 0.13, 0.13}, Vec3{0.10, 0.55, 0.15},
                                              Vec3{0.15, 0.30, 0.80}};
constexpr std::size_t kMaxEntries = 16;  // of a legend; the others are counted

// Lengths in units that grow with the image: 1 is a pixel of a picture 900 high.
constexpr double kTitle = 15;      // height of capitals
constexpr double kText = 10;       // likewise
constexpr double kBorder = 16;     // round everything
constexpr double kRow = 22;        // of the legend
constexpr double kSwatch = 26;     // its width
constexpr double kColumnGap = 28;  // between entries of the legend
constexpr double kCorner = 250;    // width of the lower right corner: axes and scale bar
constexpr double kAxis = 30;       // length of an axis
constexpr double kMark = 7;        // radius of marks

double unit_of(const Picture& picture) {
  return std::clamp(std::min(picture.width, picture.height) / 900.0, 0.7, 3.0);
}

struct Entry {
  std::string text;
  Vec3 colour;
  std::optional<LayerStyle> style{};  // none for faces
  double opacity = 1;
};

std::vector<Entry> entries_of(const Picture& picture) {
  std::vector<Entry> entries;
  for (const PictureFaces& group : picture.groups)
    if (!group.name.empty() && !group.faces.empty())
      entries.push_back({group.name, group.colour, std::nullopt, group.opacity});
  for (const PictureLayer& layer : all_layers(picture))
    if (!layer.name.empty()) entries.push_back({layer.name, layer.colour, layer.style});
  // Pieces may be very many; what curves and marks mean is not left out for them.
  std::size_t faces = 0;
  for (const Entry& entry : entries) faces += entry.style ? 0 : 1;
  const std::size_t others = entries.size() - faces;
  const std::size_t room = kMaxEntries > others ? kMaxEntries - others : 1;
  if (faces > room) {
    const auto from = entries.begin() + static_cast<std::ptrdiff_t>(room);
    entries.erase(from, entries.begin() + static_cast<std::ptrdiff_t>(faces));
    entries.insert(entries.begin() + static_cast<std::ptrdiff_t>(room),
                   {"and " + std::to_string(faces - room) + " more", kPaper, std::nullopt, 0});
  }
  return entries;
}

struct PlacedEntry {
  Entry entry;
  double x = 0;  // pixels from the left
  int row = 0;
};

struct Legend {
  std::vector<PlacedEntry> entries;
  int rows = 0;
};

// Entries side by side as long as there is room beside the corner, then in the next row.
Legend legend_of(const Picture& picture) {
  const double u = unit_of(picture);
  const double end = std::max(picture.width - u * kCorner, picture.width * 0.6);
  Legend legend;
  double x = u * kBorder;
  for (Entry& entry : entries_of(picture)) {
    entry.text = fitting(entry.text, u * kText, end - u * (kBorder + kSwatch + 8));
    const double width = u * (kSwatch + 8) + lettering_of(entry.text, u * kText).width;
    if (x + width > end && x > u * kBorder) {
      ++legend.rows;
      x = u * kBorder;
    }
    legend.entries.push_back({std::move(entry), x, legend.rows});
    x += width + u * kColumnGap;
  }
  if (!legend.entries.empty()) ++legend.rows;
  return legend;
}

double head_height(const Picture& picture) {
  if (picture.title.empty()) return 0;
  return unit_of(picture) *
         (kBorder + kTitle + (picture.subtitle.empty() ? 0 : kText + 11) + kBorder / 2);
}

double foot_height(const Picture& picture) {
  const double corner = 2 * kAxis + kBorder + 10;
  return unit_of(picture) * std::max(corner, kBorder + kRow * legend_of(picture).rows + 4);
}

void draw_mark(Overlay& overlay, LayerStyle style, const Vec2& at, double radius,
               const Vec3& colour) {
  const double pen = 0.36 * radius;
  const double halo = pen + std::max(1.5, 0.3 * radius);
  const auto square = [&](double width, const Vec3& ink) {
    const Vec2 a = {at[0] - radius, at[1] - radius}, b = {at[0] + radius, at[1] - radius};
    const Vec2 c = {at[0] + radius, at[1] + radius}, d = {at[0] - radius, at[1] + radius};
    overlay.stroke({{a, b, c, d, a}}, width, ink);
  };
  if (style == LayerStyle::Dot) {
    overlay.disc(at, radius, kPaper);
    overlay.disc(at, 0.75 * radius, colour);
  } else if (style == LayerStyle::Ring) {
    overlay.ring(at, radius, halo, kPaper);
    overlay.ring(at, radius, pen, colour);
  } else {
    square(halo, kPaper);
    square(pen, colour);
  }
}

bool is_mark(LayerStyle style) {
  return style == LayerStyle::Dot || style == LayerStyle::Ring || style == LayerStyle::Square;
}

void draw_marks(const Picture& picture, const View& view, Overlay& overlay) {
  const double radius = unit_of(picture) * kMark;
  for (const PictureLayer& layer : all_layers(picture)) {
    if (!is_mark(layer.style)) continue;
    for (const PictureItem& item : layer.items) {
      const Vec3 at = view(item.points.front()) * (1.0 / kSamples);
      draw_mark(overlay, layer.style, {at[0], at[1]}, radius, layer.colour);
    }
  }
}

void draw_swatch(Overlay& overlay, const Entry& entry, const Vec2& low, double u) {
  const Vec2 high = {low[0] + u * kSwatch, low[1] + u * 13};
  const double middle = (low[1] + high[1]) / 2;
  if (!entry.style) {
    if (entry.opacity == 0) return;
    overlay.fill(low, high, entry.colour, entry.opacity);
    overlay.stroke({{low, {high[0], low[1]}, high, {low[0], high[1]}, low}}, std::max(1.0, u), kInk,
                   0.6);
  } else if (is_mark(*entry.style)) {
    draw_mark(overlay, *entry.style, {(low[0] + high[0]) / 2, middle}, u * kMark * 0.9,
              entry.colour);
  } else if (*entry.style == LayerStyle::Hatch) {
    for (double x = low[0]; x < high[0] - u * 5; x += u * 6)
      overlay.stroke({{{x, high[1]}, {x + u * 8, low[1]}}}, std::max(1.0, 1.5 * u), entry.colour);
  } else {
    const double width = u * (*entry.style == LayerStyle::Curve ? 4.5 : 1.5);
    overlay.stroke({{{low[0], middle}, {high[0], middle}}}, width, entry.colour);
  }
}

void draw_legend(const Picture& picture, Overlay& overlay) {
  const double u = unit_of(picture);
  const Legend legend = legend_of(picture);
  for (const PlacedEntry& placed : legend.entries) {
    const double top =
        picture.height - u * (kBorder / 2 + kRow * (legend.rows - placed.row)) + u * 3;
    draw_swatch(overlay, placed.entry, {placed.x, top}, u);
    const double x = placed.entry.opacity == 0 ? placed.x : placed.x + u * (kSwatch + 8);
    overlay.write(placed.entry.text, {x, top + u * 11.5}, u * kText, kInk);
  }
}

void draw_title(const Picture& picture, Overlay& overlay) {
  if (picture.title.empty()) return;
  const double u = unit_of(picture);
  const double width = picture.width - 2 * u * kBorder;
  const double base = u * (kBorder + kTitle);
  overlay.write(fitting(picture.title, u * kTitle, width), {u * kBorder, base}, u * kTitle, kInk);
  if (picture.subtitle.empty()) return;
  overlay.write(fitting(picture.subtitle, u * kText, width), {u * kBorder, base + u * (kText + 11)},
                u * kText, kInk);
}

// Axes that point away from the eye come first, so that nearer ones are drawn over them.
void draw_axes(const Picture& picture, const View& view, Overlay& overlay) {
  const double u = unit_of(picture);
  const Vec2 centre = {picture.width - u * (kBorder + kAxis + 8),
                       picture.height - u * (kBorder + kAxis)};
  std::array<int, 3> order = {0, 1, 2};
  std::ranges::sort(order, [&](int i, int j) { return view.forward[i] > view.forward[j]; });
  for (const int k : order) {
    const Vec2 along = {view.right[k], -view.up[k]};
    const Vec2 tip = centre + (u * kAxis) * along;
    const Vec3& colour = kAxisColours[static_cast<std::size_t>(k)];
    if (norm(along) < 0.05) {
      overlay.disc(centre, u * 3.5, colour);
    } else {
      overlay.stroke({{centre, tip}}, u * 2.4, colour);
    }
    const Vec2 letter =
        norm(along) < 0.05 ? centre + Vec2{-u * 12, u * 12} : tip + (u * 9 / norm(along)) * along;
    const std::string name(1, static_cast<char>('X' + k));
    const double half = lettering_of(name, u * kText).width / 2;
    overlay.write(name, {letter[0] - half, letter[1] + u * kText / 2}, u * kText, colour);
  }
}

// 1, 2 or 5 times a power of ten, at most as long as given.
double round_length(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= longest) return digit * power;
  return power;
}

void draw_scale_bar(const Picture& picture, const View& view, Overlay& overlay) {
  const double u = unit_of(picture);
  const double pixels_per_unit = view.scale / kSamples;
  const double longest = u * (kCorner - 2 * kAxis - 3 * kBorder - 30) / pixels_per_unit;
  if (!(longest > 0) || !std::isfinite(longest)) return;
  const double length = round_length(longest);
  const double right = picture.width - u * (2 * kAxis + 2 * kBorder + 30);
  const double left = right - length * pixels_per_unit;
  const double y = picture.height - u * (kBorder + 6), tick = u * 4;
  overlay.stroke({{{left, y - tick}, {left, y + tick}},
                  {{left, y}, {right, y}},
                  {{right, y - tick}, {right, y + tick}}},
                 std::max(1.0, 1.6 * u), kInk);
  const std::string text = reports::number_text(reports::rounded(length)) + " mm";
  const double half = lettering_of(text, u * kText).width / 2;
  overlay.write(text, {(left + right) / 2 - half, y - u * 9}, u * kText, kInk);
}

}  // namespace

Frame free_frame(const Picture& picture) {
  if (!picture.annotated) return {0, 0, double(picture.width), double(picture.height)};
  const double head = head_height(picture), foot = foot_height(picture);
  // A small picture keeps half of itself for the scene.
  const double height = std::max(picture.height - head - foot, picture.height * 0.5);
  return {0, std::min(head, picture.height - height), double(picture.width), height};
}

void annotate(const Picture& picture, const View& view, Image& image) {
  Overlay overlay(image);
  draw_marks(picture, view, overlay);
  if (!picture.annotated) return;
  draw_title(picture, overlay);
  draw_legend(picture, overlay);
  draw_axes(picture, view, overlay);
  draw_scale_bar(picture, view, overlay);
}

}  // namespace blossom::pictures
