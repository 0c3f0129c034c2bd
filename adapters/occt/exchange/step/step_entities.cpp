// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_entities.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "adapters/occt/exchange/file_text.h"
#include "adapters/occt/exchange/step/step_scan.h"

namespace blossom::occt {
namespace {

bool is_keyword(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '!';
}

bool is_small(char c) { return 'a' <= c && c <= 'z'; }

/// The place behind the parenthesis that closes the one at a place; nowhere if none does.
std::size_t behind_parenthesis(std::string_view text, std::size_t place) {
  int open = 0;
  while (place < text.size()) {
    if (const std::size_t behind = behind_quoted(text, place); behind > place) {
      place = behind;
      continue;
    }
    if (text[place] == '(') ++open;
    if (text[place] == ')') --open;
    ++place;
    if (open == 0) return place;
  }
  return kNowhere;
}

/// A part of a complex entity: where it begins and ends, and how long its name is.
struct ComplexPart {
  std::size_t begin, end, name;
};

/// The parts in the parenthesis at a place; none if it holds anything else.
std::vector<ComplexPart> parts_at(std::string_view text, std::size_t place) {
  std::vector<ComplexPart> parts;
  place = behind_blanks(text, place + 1);
  while (place < text.size() && text[place] != ')') {
    std::size_t end = place;
    while (end < text.size() && is_keyword(text[end])) ++end;
    const std::size_t open = behind_blanks(text, end);
    if (end == place || open >= text.size() || text[open] != '(') return {};
    const std::size_t behind = behind_parenthesis(text, open);
    if (behind == kNowhere) return {};
    parts.push_back({place, behind, end - place});
    place = behind_blanks(text, behind);
  }
  return parts;
}

void sort_parts(std::string& text, std::vector<ComplexPart> parts) {
  const auto name = [&](const ComplexPart& part) {
    return std::string_view(text).substr(part.begin, part.name);
  };
  if (std::ranges::is_sorted(parts, {}, name)) return;
  const std::size_t begin = parts.front().begin, end = parts.back().end;
  std::ranges::stable_sort(parts, {}, name);
  std::string sorted;
  for (const ComplexPart& part : parts) sorted.append(text, part.begin, part.end - part.begin);
  sorted.resize(end - begin, ' ');
  text.replace(begin, end - begin, sorted);
}

/// The place of the last "#12=" of a text, behind which nothing but blanks stands; its end if there
/// is none.
std::size_t head_at_end(std::string_view text) {
  const std::size_t sharp = text.rfind('#'), sign = text.rfind('=');
  const bool head = sharp != kNowhere && sign != kNowhere && sharp < sign &&
                    std::ranges::all_of(text.substr(sign + 1), is_blank);
  return head ? sharp : text.size();
}

/// Behind "ENDSCOPE" and the list of what it exports, "/#2,#3/".
std::size_t behind_exports(std::string_view text, std::size_t place) {
  place = behind_blanks(text, place);
  if (place >= text.size() || text[place] != '/') return place;
  const std::size_t end = text.find('/', place + 1);
  return end == kNowhere ? text.size() : end + 1;
}

bool crashes_when_empty(std::string_view keyword) {
  constexpr std::string_view kKeywords[] = {
      "B_SPLINE_CURVE_WITH_KNOTS",
      "B_SPLINE_SURFACE_WITH_KNOTS",
      "CONTEXT_DEPENDENT_INVISIBILITY",
      "DERIVED_UNIT",
      "DIRECTION",
      "EDGE_LOOP",
      "GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE",
      "INTERSECTION_CURVE",
      "INVISIBILITY",
      "RATIONAL_B_SPLINE_CURVE",
      "RATIONAL_B_SPLINE_SURFACE",
      "SEAM_CURVE",
      "SURFACE_CURVE",
      "TRIMMED_CURVE",
  };
  return keyword.ends_with("_TOLERANCE") ||
         std::ranges::find(kKeywords, keyword) != std::end(kKeywords);
}

bool is_empty_list(std::string_view text, std::size_t open) {
  const std::size_t next = behind_blanks(text, open + 1);
  return next < text.size() && text[next] == ')';
}

/// The places in the empty lists of a statement, among the fields of keywords that crash.
void add_empty_lists(std::string_view text, std::size_t begin, std::size_t end,
                     std::vector<std::size_t>& places) {
  std::vector<std::string_view> owners;  // of open parentheses: the keyword whose fields they hold
  std::string_view word;
  for (std::size_t at = begin; at < end;) {
    if (const std::size_t behind = behind_quoted(text, at); behind > at) {
      if (text[at] != '/') word = {};
      at = behind;
      continue;
    }
    if (is_keyword(text[at])) {
      const std::size_t from = at;
      while (at < end && is_keyword(text[at])) ++at;
      word = text.substr(from, at - from);
      continue;
    }
    if (text[at] == '(') {
      const std::string_view owner = word.empty() && !owners.empty() ? owners.back() : word;
      if (word.empty() && crashes_when_empty(owner) && is_empty_list(text, at))
        places.push_back(at + 1);
      owners.push_back(owner);
    }
    if (text[at] == ')' && !owners.empty()) owners.pop_back();
    if (!is_blank(text[at])) word = {};
    ++at;
  }
}

/// The edge that an oriented edge is of, and where its "#" stands.
struct EdgeReference {
  std::string_view edge;
  std::size_t place = 0;
};
using OrientedEdges = std::unordered_map<std::string_view, EdgeReference>;  // by their numbers

OrientedEdges oriented_edges(std::string_view text) {
  OrientedEdges oriented;
  for_each_head(text, [&](std::string_view number, std::size_t place) {
    if (!has_word(text, place, "ORIENTED_EDGE")) return;
    while (place < text.size() && text[place] != '#' && text[place] != ';') {
      const std::size_t behind = behind_quoted(text, place);
      place = behind > place ? behind : place + 1;
    }
    if (place >= text.size() || text[place] == ';') return;
    std::size_t end = place + 1;
    while (end < text.size() && is_digit(text[end])) ++end;
    const std::string_view edge = text.substr(place + 1, end - place - 1);
    oriented.try_emplace(number, EdgeReference{without_zeros(edge), place});
  });
  return oriented;
}

bool is_of_itself(const OrientedEdges& oriented, std::string_view number) {
  auto next = oriented.find(number);
  for (std::size_t steps = 0; next != oriented.end() && steps < oriented.size(); ++steps) {
    if (next->second.edge == number) return true;
    next = oriented.find(next->second.edge);
  }
  return false;
}

}  // namespace

bool has_small_keywords(std::string_view text) {
  bool small = false;
  for_each_head(text, [&](std::string_view, std::size_t place) {
    if (small || place >= text.size()) return;
    if (text[place] == '(') place = behind_blanks(text, place + 1);
    for (; place < text.size() && is_keyword(text[place]); ++place)
      small = small || is_small(text[place]);
  });
  return small;
}

void sort_complex_entities(std::string& text) {
  for_each_head(text, [&](std::string_view, std::size_t place) {
    if (place >= text.size() || text[place] != '(') return;
    if (std::vector<ComplexPart> parts = parts_at(text, place); !parts.empty())
      sort_parts(text, std::move(parts));
  });
}

void open_scopes(std::string& text) {
  if (text.find("&SCOPE") == kNowhere) return;
  std::string opened;
  std::vector<std::string> heads;
  for (std::size_t place = 0; place < text.size();) {
    if (const std::size_t behind = behind_quoted(text, place); behind > place) {
      opened.append(text, place, behind - place);
      place = behind;
    } else if (has_word(text, place, "&SCOPE")) {
      const std::size_t head = head_at_end(opened);
      heads.push_back(opened.substr(head));
      opened.resize(head);
      place += std::string_view("&SCOPE").size();
    } else if (!heads.empty() && has_word(text, place, "ENDSCOPE")) {
      place = behind_exports(text, place + std::string_view("ENDSCOPE").size());
      opened += heads.back();
      heads.pop_back();
    } else {
      opened += text[place++];
    }
  }
  text = std::move(opened);
}

void fill_empty_lists(std::string& text) {
  std::vector<std::size_t> places;
  for (std::size_t open = text.find('('); open != kNowhere; open = text.find('(', open + 1)) {
    if (!is_empty_list(text, open)) continue;
    const std::size_t begin = text.rfind(';', open) + 1;
    const std::size_t end = std::min(semicolon_from(text, begin), text.size());
    add_empty_lists(text, begin, end, places);
    open = std::max(open, end - 1);
  }
  if (places.empty()) return;
  std::string filled;
  std::size_t done = 0;
  for (const std::size_t place : places) {
    filled.append(text, done, place - done) += '$';
    done = place;
  }
  filled.append(text, done);
  text = std::move(filled);
}

void open_edge_circles(std::string& text) {
  std::vector<std::size_t> places;
  const OrientedEdges oriented = oriented_edges(text);
  for (const auto& [number, of] : oriented)
    if (oriented.contains(of.edge) && is_of_itself(oriented, number)) places.push_back(of.place);
  for (std::size_t place : places) {
    text[place] = '$';
    while (is_digit(text[++place])) text[place] = ' ';
  }
}

}  // namespace blossom::occt
