// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/drawings/dxf.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <string_view>

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

// Names that are unlike each other by more than the case of letters, also with kInner behind them.
class UnlikeNames {
 public:
  /// Begins with the letters as far as there is room, and ends with a number if it has to.
  std::string add(const std::string& letters, std::size_t room) {
    std::string name = letters.substr(0, room);
    int& number = numbers_[upper_case(name)];
    for (const std::string whole = name; is_known(name);) {
      const std::string ending = "_" + std::to_string(number++ + 2);
      name = whole.substr(0, room - ending.size()) + ending;
    }
    known_.insert({upper_case(name), upper_case(name + kInner)});
    return name;
  }

 private:
  bool is_known(const std::string& name) const {
    return known_.contains(upper_case(name)) || known_.contains(upper_case(name + kInner));
  }

  std::set<std::string> known_;
  std::map<std::string, int> numbers_;  // so many were tried, by what is before them
};

// Layers are "DECK-Shaft": what planes are called, in capitals, and where there are several parts
// the parts, in all planes alike.
class LayerNames {
 public:
  explicit LayerNames(const std::vector<DrawnPlane>& planes) {
    UnlikeNames of_planes, of_parts;
    std::size_t longest = 0;
    for (const DrawnPlane& plane : planes) {
      plane_words_.push_back(of_planes.add(layer_letters(upper_case(plane.layer)), kRoom / 2));
      longest = std::max(longest, plane_words_.back().size());
    }
    for (const DrawnPlane& plane : planes)
      for (const DrawnPart& part : plane.parts)
        if (!part_words_.contains(part.name))
          part_words_[part.name] = of_parts.add(layer_letters(part.name), kRoom - longest);
  }

  /// Of all parts of a plane; those of one name share theirs.
  std::vector<std::string> add(std::size_t plane, const std::vector<DrawnPart>& parts) {
    std::map<std::string, std::string> made;
    std::vector<std::string> names;
    for (const DrawnPart& part : parts) {
      if (!made.contains(part.name)) {
        const std::string& word = plane_words_[plane];
        const bool several = part_words_.size() > 1;
        // "DECK" with "B-Shaft" is like "DECK-B" with "Shaft".
        made[part.name] = layers_.add(several ? word + "-" + part_words_[part.name] : word, kAll);
      }
      names.push_back(made[part.name]);
    }
    return names;
  }

 private:
  static constexpr std::size_t kAll = kLongestName - std::string_view(kInner).size();
  static constexpr std::size_t kRoom = kAll - 1;  // of both words, with "-" between them

  std::vector<std::string> plane_words_;
  std::map<std::string, std::string> part_words_;
  UnlikeNames layers_;
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
  LayerNames names(planes);
  std::map<std::string, std::size_t> order;  // of the parts' colours
  std::vector<std::vector<PartLayers>> layers;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    std::vector<PartLayers>& own = layers.emplace_back();
    const std::vector<std::string> outlines = names.add(i, planes[i].parts);
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      const DrawnPart& part = planes[i].parts[k];
      const std::size_t place = order.emplace(part.name, order.size()).first->second;
      const int colour = kColourNumbers[place % kColourNumbers.size()];
      const std::string inner = has_inner_wires(part) ? outlines[k] + kInner : "";
      own.push_back({{outlines[k], colour}, {inner, colour}});
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
