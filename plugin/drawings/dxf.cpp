// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/drawings/dxf.h"

#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "plugin/reports/text/number_text.h"

namespace blossom::drawings {
namespace {

using reports::number_text;

constexpr std::size_t kLongestName = 31;                       // of a layer in release 12
constexpr std::array kColourNumbers{7, 1, 5, 3, 6, 4, 2, 30};  // of AutoCAD's index, by parts

struct DxfLayer {
  std::string name;
  int colour = 7;
};

// The lines of a file: a group code and its value by turns.
class DxfLines {
 public:
  void add(int code, const std::string& value) {
    text_ += std::to_string(code) + "\n" + value + "\n";
  }
  void add(int code, double value) { add(code, number_text(value)); }
  void add(int code, int value) { add(code, std::to_string(value)); }
  /// x, y and z; the codes of points go up by ten.
  void add_point(int code, const Vec2& point, double z) {
    add(code, point[0]);
    add(code + 10, point[1]);
    add(code + 20, z);
  }
  void add_entity(const char* kind, const DxfLayer& layer) {
    add(0, std::string(kind));
    add(8, layer.name);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

constexpr const char* kInner = "-inner";

// The letters that layers may have; umlauts as they are spelt without their dots, others as one
// "_".
std::string layer_letters(const std::string& name) {
  static const std::map<std::string, std::string> kSpelt{
      {"ä", "ae"}, {"ö", "oe"}, {"ü", "ue"}, {"Ä", "Ae"}, {"Ö", "Oe"}, {"Ü", "Ue"}, {"ß", "ss"}};
  std::string letters;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const auto is_inside = [](char byte) { return (byte & 0xC0) == 0x80; };  // of UTF-8
    if (is_inside(c)) continue;
    const auto spelt = kSpelt.find(name.substr(i, 2));
    if (spelt != kSpelt.end())
      letters += spelt->second;
    else
      letters += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '$' ? c : '_';
  }
  return letters;
}

std::string upper_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// What layers call things, by their names: each unlike all others by more than the case of letters,
// also with kInner behind it, and of `room` letters at most.
std::map<std::string, std::string> layer_words(const std::vector<std::string>& names,
                                               std::size_t room) {
  std::map<std::string, std::string> words;
  std::set<std::string> known;
  for (const std::string& name : names) {
    if (words.contains(name)) continue;
    const std::string letters = layer_letters(name);
    std::string word = letters.substr(0, room);
    for (int i = 2; known.contains(upper_case(word)); ++i) {
      const std::string ending = "_" + std::to_string(i);
      word = letters.substr(0, room - ending.size()) + ending;
    }
    known.insert({upper_case(word), upper_case(word + kInner)});
    words[name] = word;
  }
  return words;
}

// Layers are "DECK-Shaft": what planes are called, in capitals, and where there are several parts
// the parts, in all planes alike.
struct LayerWords {
  explicit LayerWords(const std::vector<DrawnPlane>& planes) {
    std::vector<std::string> of_planes, of_parts;
    for (const DrawnPlane& plane : planes) {
      of_planes.push_back(upper_case(plane.layer));
      for (const DrawnPart& part : plane.parts) of_parts.push_back(part.name);
    }
    const std::size_t room = kLongestName - 1 - std::string(kInner).size();
    plane_words = layer_words(of_planes, room / 2);
    std::size_t longest = 0;
    for (const auto& [name, word] : plane_words) longest = std::max(longest, word.size());
    part_words = layer_words(of_parts, room - longest);
  }

  std::string of(const DrawnPlane& plane, const DrawnPart& part) const {
    const std::string& word = plane_words.at(upper_case(plane.layer));
    return part_words.size() > 1 ? word + "-" + part_words.at(part.name) : word;
  }

  std::map<std::string, std::string> plane_words, part_words;
};

// Those of a part; what does not bound it, a plotter or a saw must not follow.
struct PartLayers {
  DxfLayer outline, inner;  // without a name: not needed
};

bool has_inner_wires(const DrawnPart& part) {
  return !std::ranges::all_of(part.wires, &DrawnWire::bounding);
}

// One for each part of each plane, and one for its inner wires if it has any.
std::vector<std::vector<PartLayers>> layers_of(const std::vector<DrawnPlane>& planes) {
  const LayerWords words(planes);
  std::map<std::string, std::size_t> order;  // of the parts' colours
  std::vector<std::vector<PartLayers>> layers;
  for (const DrawnPlane& plane : planes) {
    std::vector<PartLayers>& own = layers.emplace_back();
    for (const DrawnPart& part : plane.parts) {
      const std::size_t place = order.emplace(part.name, order.size()).first->second;
      const int colour = kColourNumbers[place % kColourNumbers.size()];
      const std::string outline = words.of(plane, part);
      const std::string inner = has_inner_wires(part) ? outline + kInner : "";
      own.push_back({{outline, colour}, {inner, colour}});
    }
  }
  return layers;
}

void add_head(const DrawingBox& box, DxfLines& lines) {
  lines.add(0, std::string("SECTION"));
  lines.add(2, std::string("HEADER"));
  lines.add(9, std::string("$ACADVER"));
  lines.add(1, std::string("AC1009"));
  if (!box.is_empty()) {
    lines.add(9, std::string("$EXTMIN"));
    lines.add_point(10, box.low, 0);
    lines.add(9, std::string("$EXTMAX"));
    lines.add_point(10, box.high, 0);
  }
  lines.add(0, std::string("ENDSEC"));
}

void add_tables(const std::vector<std::vector<PartLayers>>& layers, DxfLines& lines) {
  std::vector<DxfLayer> all{{"0", 7}};
  std::set<std::string> known{""};  // an outline's layer may be that of several parts
  for (const auto& of_plane : layers)
    for (const PartLayers& of_part : of_plane)
      for (const DxfLayer& layer : {of_part.outline, of_part.inner})
        if (known.insert(layer.name).second) all.push_back(layer);
  lines.add(0, std::string("SECTION"));
  lines.add(2, std::string("TABLES"));
  lines.add(0, std::string("TABLE"));
  lines.add(2, std::string("LTYPE"));
  lines.add(70, 1);
  lines.add(0, std::string("LTYPE"));
  lines.add(2, std::string("CONTINUOUS"));
  lines.add(70, 0);
  lines.add(3, std::string("Solid line"));
  lines.add(72, 65);
  lines.add(73, 0);
  lines.add(40, 0.0);
  lines.add(0, std::string("ENDTAB"));
  lines.add(0, std::string("TABLE"));
  lines.add(2, std::string("LAYER"));
  lines.add(70, static_cast<int>(all.size()));
  for (const DxfLayer& layer : all) {
    lines.add(0, std::string("LAYER"));
    lines.add(2, layer.name);
    lines.add(70, 0);
    lines.add(62, layer.colour);
    lines.add(6, std::string("CONTINUOUS"));
  }
  lines.add(0, std::string("ENDTAB"));
  lines.add(0, std::string("ENDSEC"));
}

double degrees(const Vec2& from, const Vec2& to) {
  const double angle = std::atan2(to[1] - from[1], to[0] - from[0]) * 180 / std::numbers::pi;
  const double turned = angle < 0 ? angle + 360 : angle;
  return turned < 360 ? turned : 0;  // a rounding below 0 is a whole turn
}

void add_polyline(const std::vector<Vec2>& points, double z, const DxfLayer& layer,
                  DxfLines& lines) {
  lines.add_entity("POLYLINE", layer);
  lines.add(66, 1);
  lines.add_point(10, {0, 0}, z);
  lines.add(70, 0);
  for (const Vec2& point : points) {
    lines.add_entity("VERTEX", layer);
    lines.add_point(10, point, z);
  }
  lines.add_entity("SEQEND", layer);
}

void add_stroke(const Stroke& stroke, double z, const DxfLayer& layer, DxfLines& lines) {
  switch (stroke.kind) {
    case StrokeKind::Line:
      lines.add_entity("LINE", layer);
      lines.add_point(10, stroke.from, z);
      lines.add_point(11, stroke.to, z);
      return;
    case StrokeKind::Circle:
      lines.add_entity("CIRCLE", layer);
      lines.add_point(10, stroke.centre, z);
      lines.add(40, stroke.radius);
      return;
    case StrokeKind::Arc: {  // always counter-clockwise
      const bool forward = stroke.counter_clockwise;
      lines.add_entity("ARC", layer);
      lines.add_point(10, stroke.centre, z);
      lines.add(40, stroke.radius);
      lines.add(50, degrees(stroke.centre, forward ? stroke.from : stroke.to));
      lines.add(51, degrees(stroke.centre, forward ? stroke.to : stroke.from));
      return;
    }
    case StrokeKind::Polyline: add_polyline(stroke.points, z, layer, lines); return;
  }
}

}  // namespace

std::string dxf_text(const std::vector<DrawnPlane>& planes) {
  DrawingBox box;
  for (const DrawnPlane& plane : planes) box.add(plane);
  const std::vector<std::vector<PartLayers>> layers = layers_of(planes);
  DxfLines lines;
  add_head(box, lines);
  add_tables(layers, lines);
  lines.add(0, std::string("SECTION"));
  lines.add(2, std::string("ENTITIES"));
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t k = 0; k < planes[i].parts.size(); ++k) {
      const DrawnPart& part = planes[i].parts[k];
      const auto& [layer, inner] = layers[i][k];
      for (const DrawnWire& wire : part.wires)
        for (const Stroke& stroke : wire.strokes)
          add_stroke(stroke, planes[i].elevation, wire.bounding ? layer : inner, lines);
      for (const Vec2& point : part.points) {
        lines.add_entity("POINT", layer);
        lines.add_point(10, point, planes[i].elevation);
      }
    }
  lines.add(0, std::string("ENDSEC"));
  lines.add(0, std::string("EOF"));
  return lines.text();
}

}  // namespace blossom::drawings
