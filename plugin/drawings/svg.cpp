// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/drawings/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "plugin/reports/text/number_text.h"

namespace blossom::drawings {
namespace {

using reports::number_text;
using reports::rounded;

constexpr std::array kColours{"#1f4e79", "#a14a00", "#2e6b34", "#7a1f5c",
                              "#5a5a00", "#00646b", "#6b3fa0", "#8a1c1c"};
constexpr std::array kAngles{45, -45, 20, -20, 70, -70, 0, 90};  // of hatchings, degrees

std::string num(double value) { return number_text(rounded(value)); }

// Numbers of paths keep nine digits: places far from the origin, and small features.
std::string place(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9g", value);
  return text.data();
}

std::string escaped(const std::string& text) {
  std::string made;
  for (const char c : text) switch (c) {
      case '&': made += "&amp;"; break;
      case '<': made += "&lt;"; break;
      case '>': made += "&gt;"; break;
      case '"': made += "&quot;"; break;
      default: made += c;
    }
  return made;
}

// What all planes have in common. Lengths are millimetres of the drawing.
struct Sheet {
  Vec2 low, size;  // of what is drawn of each plane
  double gap = 0;  // between planes
  double line = 0, text = 0;
  std::size_t columns = 1, rows = 1;
  std::vector<std::string> parts;  // by colour

  double step_x() const { return size[0] + gap; }
  double step_y() const { return size[1] + gap + 2 * text; }
};

Sheet sheet_of(const std::vector<DrawnPlane>& planes) {
  DrawingBox box;
  Sheet sheet;
  for (const DrawnPlane& plane : planes) {
    box.add(plane);
    for (const DrawnPart& part : plane.parts)
      if (std::ranges::find(sheet.parts, part.name) == sheet.parts.end())
        sheet.parts.push_back(part.name);
  }
  if (box.is_empty()) box.low = box.high = {0, 0};
  sheet.low = box.low;
  sheet.size = box.high - box.low;
  const double largest = std::max({sheet.size[0], sheet.size[1], 1e-6});
  for (int k = 0; k < 2; ++k) sheet.size[k] = std::max(sheet.size[k], 0.02 * largest);
  const auto count = static_cast<double>(planes.size());
  // About as wide as high, as far as the shape of the planes lets it be.
  const double columns =
      std::sqrt(count * 1.4 * (sheet.size[1] + 0.1 * largest) / (sheet.size[0] + 0.1 * largest));
  sheet.columns = static_cast<std::size_t>(std::clamp(std::round(columns), 1.0, count));
  sheet.rows = (planes.size() + sheet.columns - 1) / sheet.columns;
  const double width = static_cast<double>(sheet.columns) * sheet.size[0];
  const double height = static_cast<double>(sheet.rows) * sheet.size[1];
  const double whole = std::max(width, height);
  sheet.gap = 0.04 * std::max(largest, 0.5 * whole / std::sqrt(count));
  sheet.line = 0.0012 * whole;
  sheet.text = std::min(0.016 * whole, 0.06 * std::max(largest, sheet.gap));
  return sheet;
}

// In the plane up is up; on a screen it is down.
std::string at(const Vec2& p) { return place(p[0]) + " " + place(-p[1]); }

std::string arc_to(const Stroke& arc, const Vec2& to, double sweep) {
  const std::string r = place(arc.radius);
  return "A" + r + " " + r + " 0 " + (sweep > std::numbers::pi ? "1 " : "0 ") +
         (arc.counter_clockwise ? "0 " : "1 ") + at(to);
}

std::string path_of(const DrawnWire& wire) {
  std::string path;
  for (const Stroke& stroke : wire.strokes) {
    if (stroke.kind == StrokeKind::Circle) {
      const Vec2 side{stroke.radius, 0};
      path += "M" + at(stroke.centre + side) + arc_to(stroke, stroke.centre - side, 1) +
              arc_to(stroke, stroke.centre + side, 1);
      continue;
    }
    if (path.empty()) path = "M" + at(stroke.from);
    if (stroke.kind == StrokeKind::Line) path += "L" + at(stroke.to);
    if (stroke.kind == StrokeKind::Arc) path += arc_to(stroke, stroke.to, stroke.sweep);
    for (std::size_t i = 1; i < stroke.points.size(); ++i) path += "L" + at(stroke.points[i]);
  }
  return wire.closed ? path + "Z" : path;
}

std::string part_text(const DrawnPart& part, const Sheet& sheet) {
  const auto number =
      static_cast<std::size_t>(std::ranges::find(sheet.parts, part.name) - sheet.parts.begin());
  std::string closed, open, inner;
  for (const DrawnWire& wire : part.wires)
    (!wire.bounding ? inner : wire.closed ? closed : open) += path_of(wire);
  std::string text = "<g stroke=\"" + std::string(kColours[number % kColours.size()]) + "\">";
  text += "<title>" + escaped(part.name) + "</title>";
  const std::string fill = part.solid ? "url(#hatch-" + std::to_string(number + 1) + ")" : "none";
  if (!closed.empty())
    text += "<path fill=\"" + fill + "\" fill-rule=\"evenodd\" d=\"" + closed + "\"/>";
  if (!open.empty()) text += "<path fill=\"none\" d=\"" + open + "\"/>";
  if (!inner.empty())
    text += "<path fill=\"none\" stroke-dasharray=\"" + num(4 * sheet.line) + "\" d=\"" + inner +
            "\"/>";
  for (const Vec2& point : part.points)
    text += "<circle cx=\"" + place(point[0]) + "\" cy=\"" + place(-point[1]) + "\" r=\"" +
            num(2 * sheet.line) + "\"/>";
  return text + "</g>\n";
}

std::string hatchings(const Sheet& sheet) {
  std::string text = "<defs>\n";
  const double step = 10 * sheet.line;
  for (std::size_t i = 0; i < sheet.parts.size(); ++i)
    text += "<pattern id=\"hatch-" + std::to_string(i + 1) +
            "\" patternUnits=\"userSpaceOnUse\" width=\"" + num(step) + "\" height=\"" + num(step) +
            "\" patternTransform=\"rotate(" + std::to_string(kAngles[i % kAngles.size()]) +
            ")\"><line x1=\"0\" y1=\"0\" x2=\"" + num(step) + "\" y2=\"0\" stroke=\"" +
            kColours[i % kColours.size()] + "\" stroke-width=\"" + num(0.8 * sheet.line) +
            "\"/></pattern>\n";
  return text + "</defs>\n";
}

std::string text_at(double x, double y, const std::string& text) {
  return "<text stroke=\"none\" x=\"" + place(x) + "\" y=\"" + place(y) + "\">" + escaped(text) +
         "</text>\n";
}

std::string plane_text(const DrawnPlane& plane, std::size_t number, const Sheet& sheet) {
  const auto column = static_cast<double>(number % sheet.columns);
  const auto row = static_cast<double>(number / sheet.columns);
  const double x = column * sheet.step_x() - sheet.low[0];
  const double y = row * sheet.step_y() + sheet.low[1] + sheet.size[1];
  std::string text = "<g id=\"plane-" + std::to_string(number + 1) + "\" transform=\"translate(" +
                     place(x) + " " + place(y) + ")\">\n";
  text += "<title>" + escaped(plane.name) + "</title>\n";
  for (const DrawnPart& part : plane.parts) text += part_text(part, sheet);
  return text + text_at(sheet.low[0], -sheet.low[1] + 1.5 * sheet.text, plane.name) + "</g>\n";
}

std::string legend(const Sheet& sheet, double y) {
  std::string text;
  for (std::size_t i = 0; i < sheet.parts.size(); ++i) {
    const double top = y + 1.6 * sheet.text * static_cast<double>(i);
    text += "<rect x=\"0\" y=\"" + place(top) + "\" width=\"" + num(2 * sheet.text) +
            "\" height=\"" + num(sheet.text) + "\" stroke=\"" + kColours[i % kColours.size()] +
            "\" fill=\"url(#hatch-" + std::to_string(i + 1) + ")\"/>\n" +
            text_at(2.6 * sheet.text, top + 0.85 * sheet.text, sheet.parts[i]);
  }
  return text;
}

}  // namespace

std::string svg_text(const std::vector<DrawnPlane>& planes) {
  const Sheet sheet = sheet_of(planes);
  const bool legend_wanted = sheet.parts.size() > 1;
  const double margin = sheet.gap;
  const double width = static_cast<double>(sheet.columns) * sheet.step_x() - sheet.gap;
  const double planes_high = static_cast<double>(sheet.rows) * sheet.step_y() - sheet.gap;
  const double height =
      planes_high +
      (legend_wanted ? sheet.text * (1 + 1.6 * static_cast<double>(sheet.parts.size())) : 0);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + place(width + 2 * margin) +
          "mm\" height=\"" + place(height + 2 * margin) + "mm\" viewBox=\"" + place(-margin) + " " +
          place(-margin) + " " + place(width + 2 * margin) + " " + place(height + 2 * margin) +
          "\">\n";
  text += hatchings(sheet);
  text += "<rect x=\"" + place(-margin) + "\" y=\"" + place(-margin) +
          "\" width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  text += "<g stroke-width=\"" + num(sheet.line) + "\" stroke-linejoin=\"round\" font-size=\"" +
          num(sheet.text) + "\" font-family=\"sans-serif\">\n";
  for (std::size_t i = 0; i < planes.size(); ++i) text += plane_text(planes[i], i, sheet);
  if (legend_wanted) text += legend(sheet, planes_high + sheet.text);
  return text + "</g>\n</svg>\n";
}

}  // namespace blossom::drawings
