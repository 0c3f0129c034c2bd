// SPDX-License-Identifier: LGPL-2.1-or-later
// Is a file whole? Open CASCADE reads what is left of a cut file without a word, or hangs on it.

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <vector>

#include "adapters/occt/errors.h"
#include "adapters/occt/shapes/shapes_detail.h"

namespace blossom::occt {
namespace {

/// Blanks, and the zeros and end marks with which some systems fill files.
bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0 || c == '\0' || c == '\x1a';
}
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// A number at the start of a text, and what follows it.
struct Number {
  long value = 0;
  std::string_view rest;
  bool found = false;
};

Number leading_number(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  Number number;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number.value);
  number.found = end.ec == std::errc();
  number.rest = text.substr(static_cast<std::size_t>(end.ptr - text.data()));
  return number;
}

/// The entity numbers of a STEP file, outside of strings and comments.
struct References {
  std::vector<long> defined;
  std::vector<long> used;
};

/// The place after the string, comment or file reference that begins at `i`, or `i` if none does.
std::size_t after_literal(std::string_view text, std::size_t i) {
  std::size_t end = i;
  if (text[i] == '\'' || text[i] == '"') {
    end = text.find(text[i], i + 1);
    end += end == std::string_view::npos ? 0 : 1;
  } else if (text.substr(i, 2) == "/*") {
    end = text.find("*/", i + 2);
    end += end == std::string_view::npos ? 0 : 2;
  } else if (text[i] == '<') {
    end = text.find('>', i + 1);
  }
  return std::min(end, text.size());
}

References references(std::string_view text) {
  References found;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t after = after_literal(text, i);
    if (after > i) {
      i = after;
    } else if (text[i] == '#' && i + 1 < text.size() && is_digit(text[i + 1])) {
      const Number number = leading_number(text.substr(i + 1));
      i = text.size() - number.rest.size();
      std::size_t next = i;
      while (next < text.size() && is_space(text[next])) ++next;
      const bool definition = next < text.size() && text[next] == '=';
      (definition ? found.defined : found.used).push_back(number.value);
    } else {
      ++i;
    }
  }
  return found;
}

void check_step(std::string_view text) {
  if (!text.starts_with("ISO-10303-21")) throw BadModel("is no STEP file");
  if (text.rfind("END-ISO-10303-21") == std::string_view::npos)
    throw BadModel("is cut off: END-ISO-10303-21 is missing");
  if (text.find("DATA") == std::string_view::npos)
    throw BadModel("is damaged: it has no DATA section");
  References found = references(text);
  std::sort(found.defined.begin(), found.defined.end());
  for (const long number : found.used)
    if (!std::binary_search(found.defined.begin(), found.defined.end(), number))
      throw BadModel("is damaged: it uses #" + std::to_string(number) + ", which is not there");
}

void check_iges(std::string_view text) {
  constexpr std::size_t kSectionColumn = 72;
  constexpr std::string_view kSections = "SGDP";
  std::array<long, 4> counted{};
  std::string_view last;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.size() <= kSectionColumn) {
      if (trimmed(line).empty()) continue;
      throw BadModel(counted[0] == 0 ? "is no IGES file" : "is cut off within a line");
    }
    const std::size_t section = kSections.find(line[kSectionColumn]);
    if (section != std::string_view::npos) ++counted[section];
    if (counted[0] == 0) throw BadModel("is no IGES file");
    last = line;
  }
  if (last.size() <= kSectionColumn || last[kSectionColumn] != 'T')
    throw BadModel("is cut off: its terminate section is missing");
  for (std::size_t i = 0; i < kSections.size(); ++i) {
    const std::size_t place = last.find(kSections[i]);
    const Number wanted =
        leading_number(last.substr(place == std::string_view::npos ? last.size() : place + 1));
    if (wanted.found && wanted.value != counted[i])
      throw BadModel(std::string("is damaged: section ") + kSections[i] + " has " +
                     std::to_string(counted[i]) + " lines instead of " +
                     std::to_string(wanted.value));
  }
}

/// No table of a text BREP file has more entries than the text has lines: Open CASCADE would look
/// for as many as a damaged number says.
void check_brep_tables(std::string_view text) {
  const long lines = std::count(text.begin(), text.end(), '\n');
  for (const std::string_view name : {"Locations", "Curve2ds", "Curves", "Polygon3D",
                                      "PolygonOnTriangulations", "Surfaces", "Triangulations"}) {
    const std::size_t start = text.find("\n" + std::string(name) + " ");
    if (start == std::string_view::npos) continue;
    const Number count = leading_number(text.substr(start + name.size() + 2));
    if (!count.found || count.value < 0 || count.value > lines)
      throw BadModel("is damaged: it cannot have as many entries as its table '" +
                     std::string(name) + "' says");
  }
}

/// A text BREP file ends with its shapes, each closed by a star, and the whole's place and
/// orientation ("+1 0").
void check_brep(std::string_view text) {
  if (text.find("CASCADE Topology V") == std::string_view::npos)
    throw BadModel("is no BREP text file");
  check_brep_tables(text);
  constexpr std::string_view kShapes = "\nTShapes ";
  const std::size_t start = text.rfind(kShapes);
  if (start == std::string_view::npos) throw BadModel("is cut off: it has no shapes section");
  const Number count = leading_number(text.substr(start + kShapes.size()));
  std::string_view rest = count.rest;
  long stars = 0;
  while (stars < count.value) {
    const std::size_t star = rest.find('*');
    if (star == std::string_view::npos) break;
    rest.remove_prefix(star + 1);
    ++stars;
  }
  if (!count.found || stars < count.value)
    throw BadModel("is cut off: " + std::to_string(stars) + " of " + std::to_string(count.value) +
                   " shapes are there");
  rest = trimmed(rest);
  if (rest.size() < 4 || std::string_view("+-ie").find(rest.front()) == std::string_view::npos)
    throw BadModel("is cut off: the last line, which names the whole shape, is missing");
}

}  // namespace

void check_whole(Format format, std::string_view text) {
  const std::string_view content = trimmed(text);
  if (content.empty()) throw BadModel("is empty");
  switch (format) {
    case Format::Step: return check_step(content);
    case Format::Iges: return check_iges(text);
    case Format::Brep: return check_brep(content);
  }
}

}  // namespace blossom::occt
