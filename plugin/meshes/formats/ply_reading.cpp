// SPDX-License-Identifier: LGPL-2.1-or-later
// Stanford's .ply: text, and binary of either byte order, numbers of any type.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/math/index.h"
#include "plugin/meshes/formats/mesh_formats.h"
#include "plugin/meshes/formats/text_scanner.h"
#include "plugin/meshes/formats/text_words.h"
#include "plugin/meshes/mesh_polygons.h"
#include "plugin/reports/text/number_text.h"

namespace blossom::meshes {
namespace {

enum class Type { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float, Double };

std::optional<Type> type_named(std::string_view name) {
  static constexpr std::array<std::array<std::string_view, 2>, 8> kNames{{{"char", "int8"},
                                                                          {"uchar", "uint8"},
                                                                          {"short", "int16"},
                                                                          {"ushort", "uint16"},
                                                                          {"int", "int32"},
                                                                          {"uint", "uint32"},
                                                                          {"float", "float32"},
                                                                          {"double", "float64"}}};
  for (std::size_t k = 0; k < kNames.size(); ++k)
    if (name == kNames[k][0] || name == kNames[k][1]) return static_cast<Type>(k);
  return {};
}

std::size_t size_of(Type type) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  Type type = Type::Float;
  std::optional<Type> count;  // of a list's length
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  bool text = false, swap = false;
  std::vector<Element> elements;
  std::map<std::int64_t, std::string> groups;
  std::size_t end = 0;
};

Type wanted_type(TextScanner& words) {
  const std::string name(words.word_of_line());
  const auto type = type_named(name);
  if (!type) throw BadContent(words.place() + "PLY has no numbers of the type '" + name + "'");
  return *type;
}

Property property_of(TextScanner& words) {
  Property property;
  TextScanner ahead = words;
  if (ahead.word_of_line() == "list") {
    words.word_of_line();
    property.count = wanted_type(words);
  }
  property.type = wanted_type(words);
  property.name = words.word_of_line();
  return property;
}

// `comment group NUMBER NAME`, as ply_content writes it.
void take_comment(TextScanner& words, Header& header) {
  if (words.word_of_line() != "group") return;
  const std::string_view number = words.word_of_line();
  std::int64_t group = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), group);
  if (read.ec == std::errc()) header.groups[group] = words.rest_of_line();
}

void take_format(TextScanner& words, Header& header) {
  const std::string_view format = words.word_of_line();
  header.text = format == "ascii";
  const bool big = format == "binary_big_endian";
  if (!header.text && !big && format != "binary_little_endian")
    throw BadContent(words.place() + "PLY has no format '" + std::string(format) + "'");
  header.swap = big != (std::endian::native == std::endian::big);
}

Header header_of(std::string_view bytes) {
  Header header;
  TextScanner words(bytes);
  if (words.word() != "ply") throw BadContent("has no header of PLY");
  for (auto word = words.word(); word != "end_header"; word = words.word()) {
    if (word.empty()) throw BadContent("its header has no end: it is cut off");
    if (word == "format") {
      take_format(words, header);
    } else if (word == "element") {
      Element element;
      element.name = words.word_of_line();
      element.count = words.whole();
      header.elements.push_back(std::move(element));
    } else if (word == "property") {
      if (header.elements.empty()) throw BadContent(words.place() + "a property of no element");
      header.elements.back().properties.push_back(property_of(words));
    } else if (word == "comment") {
      take_comment(words, header);
    }
    words.rest_of_line();
  }
  header.end = words.offset();
  if (header.end < bytes.size() && bytes[header.end] == '\r') ++header.end;
  if (header.end < bytes.size() && bytes[header.end] == '\n') ++header.end;
  return header;
}

// Numbers one after the other.
class Numbers {
 public:
  Numbers(std::string_view bytes, const Header& header)
      : bytes_(bytes), words_(bytes), at_(header.end), text_(header.text), swap_(header.swap) {
    words_.move_to(header.end);
  }

  double next(Type type) {
    if (text_) return finite_or_not(words_.word());
    std::array<char, 8> raw{};
    const std::size_t size = size_of(type);
    if (bytes_.size() - at_ < size) throw BadContent("ends in " + place() + ": it is cut off");
    std::memcpy(raw.data(), bytes_.data() + at_, size);
    at_ += size;
    if (swap_) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
    return value_of(raw, type);
  }

  // An element's name and number, for messages.
  void begin(const std::string& element, std::int64_t number) {
    if (element != element_) element_ = element;
    number_ = number;
  }
  std::string place() const { return element_ + " " + std::to_string(number_ + 1); }

 private:
  template <class Number>
  static double as(const std::array<char, 8>& raw) {
    Number number;
    std::memcpy(&number, raw.data(), sizeof number);
    return static_cast<double>(number);
  }

  static double value_of(const std::array<char, 8>& raw, Type type) {
    switch (type) {
      case Type::Int8: return as<std::int8_t>(raw);
      case Type::Uint8: return as<std::uint8_t>(raw);
      case Type::Int16: return as<std::int16_t>(raw);
      case Type::Uint16: return as<std::uint16_t>(raw);
      case Type::Int32: return as<std::int32_t>(raw);
      case Type::Uint32: return as<std::uint32_t>(raw);
      case Type::Float: return as<float>(raw);
      case Type::Double: break;
    }
    return as<double>(raw);
  }

  // Of what is no place a file may have no number, as of normals.
  double finite_or_not(std::string_view word) const {
    if (word.empty()) throw BadContent("ends in " + place() + ": it is cut off");
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc() && end == word.data() + word.size()) return value;
    if (word == "nan" || word == "-nan" || word == "inf" || word == "-inf") return std::nan("");
    return number_of(word, words_.place());
  }

  std::string_view bytes_;
  TextScanner words_;
  std::size_t at_;
  bool text_, swap_;
  std::string element_;
  std::int64_t number_ = 0;
};

// What counts of a vertex or a face, by places of properties.
struct Places {
  std::array<int, 3> xyz{-1, -1, -1}, rgb{-1, -1, -1};
  int corners = -1, group = -1;

  explicit Places(const Element& element) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const Property& property = element.properties[k];
      const std::string& name = property.name;
      const int place = static_cast<int>(k);
      for (std::size_t c = 0; c < 3; ++c) {
        if (name == std::string(1, static_cast<char>('x' + c))) xyz[c] = place;
        if (name == std::array{"red", "green", "blue"}[c]) rgb[c] = place;
      }
      if (name == "vertex_indices" || name == "vertex_index") corners = place;
      if (name == "group") group = place;
    }
  }
};

class PlyReader {
 public:
  explicit PlyReader(std::string_view bytes)
      : header_(header_of(bytes)),
        numbers_(bytes, header_),
        size_(bytes.size()),
        polygons_(mesh_, [this] { return numbers_.place() + ": "; }) {}

  FileMesh read() {
    for (const Element& element : header_.elements) {
      const bool vertices = element.name == "vertex", faces = element.name == "face";
      // A number takes a byte at least.
      const std::uint64_t least = std::max<std::size_t>(element.properties.size(), 1);
      if (element.count < 0 || static_cast<std::uint64_t>(element.count) > size_ / least)
        throw BadContent("its header promises " + std::to_string(element.count) + " of '" +
                         element.name + "', more than its " + std::to_string(size_) +
                         " bytes can hold: it is cut off or damaged");
      const Places places(element);
      if (vertices && std::ranges::count(places.xyz, -1) > 0)
        throw BadContent("its vertices have no x, y and z");
      if (faces && places.corners < 0) throw BadContent("its faces have no vertex_indices");
      if (!vertices && !faces && element.count > 0 && element.name == "tristrips")
        throw BadContent("is of strips of triangles, which are not read");
      for (std::int64_t k = 0; k < element.count; ++k) {
        numbers_.begin(element.name, k);
        take(element);
        if (vertices) add_vertex(places);
        if (faces) add_face(element, places);
      }
    }
    if (own_groups_)
      mesh_.groups = std::move(groups_);
    else
      polygons_.make_groups_of_colours();
    return std::move(mesh_);
  }

 private:
  void take(const Element& element) {
    values_.clear();
    corners_.clear();
    for (const Property& property : element.properties) {
      if (!property.count) {
        values_.push_back(numbers_.next(property.type));
        continue;
      }
      values_.push_back(0);
      const double count = numbers_.next(*property.count);
      if (!(count >= 0) || count > static_cast<double>(size_))
        throw BadContent(numbers_.place() + " has a list of " + reports::number_text(count) +
                         " numbers");
      const bool kept = property.name == "vertex_indices" || property.name == "vertex_index";
      for (double left = count; left > 0; --left) {
        const double value = numbers_.next(property.type);
        if (kept) corners_.push_back(std::isfinite(value) ? static_cast<std::int64_t>(value) : -1);
      }
    }
  }

  double value(int place) const { return values_[index(place)]; }

  void add_vertex(const Places& places) {
    Vec3 point;
    for (int c = 0; c < 3; ++c) {
      point[c] = value(places.xyz[index(c)]);
      if (!std::isfinite(point[c]))
        throw BadContent(numbers_.place() + " has a coordinate that is no finite number");
    }
    mesh_.points.push_back(point);
  }

  std::optional<MeshColour> colour_of(const Element& element, const Places& places) const {
    if (std::ranges::count(places.rgb, -1) > 0) return {};
    MeshColour colour{};
    for (std::size_t c = 0; c < 3; ++c) {
      const int place = places.rgb[c];
      const Type type = element.properties[index(place)].type;
      const double scale = type == Type::Float || type == Type::Double ? 255 : 1;
      const double part = value(place) * scale;
      colour[c] = static_cast<std::uint8_t>(
          std::isfinite(part) ? std::lround(std::clamp(part, 0.0, 255.0)) : 0);
    }
    return colour;
  }

  void add_face(const Element& element, const Places& places) {
    const std::size_t first = mesh_.triangles.size();
    polygons_.add(corners_);
    const std::optional<MeshColour> colour = colour_of(element, places);
    polygons_.colour(colour);
    if (places.group < 0) return;
    const double number = value(places.group);
    if (own_groups_ && number == last_group_) return;
    own_groups_ = true;
    last_group_ = number;
    const auto name = header_.groups.find(static_cast<std::int64_t>(number));
    groups_.push_back({name != header_.groups.end()
                           ? name->second
                           : "group " + std::to_string(static_cast<std::int64_t>(number)),
                       first, is_grey(colour) ? std::nullopt : colour});
  }

  // What ply_content gives groups without a colour beside those that have one.
  static bool is_grey(const std::optional<MeshColour>& colour) { return colour == kNoColour; }

  Header header_;
  Numbers numbers_;
  std::uint64_t size_;
  FileMesh mesh_;
  Polygons polygons_;
  std::vector<double> values_;
  std::vector<std::int64_t> corners_;
  std::vector<MeshGroup> groups_;
  bool own_groups_ = false;
  double last_group_ = 0;
};

}  // namespace

FileMesh read_ply(std::string_view bytes) { return PlyReader(bytes).read(); }

}  // namespace blossom::meshes
