// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/text/words.h"

#include <algorithm>
#include <cstddef>
#include <regex>

namespace blossom::reports {
namespace {

// How many letters are changed, left out, put in, or exchanged with their neighbours.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, changed});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

constexpr std::size_t kFewEdges = 4;  // that are named of those of one kind

/// Findings that differ in numbers and places alone.
struct FindingKind {
  std::string words, first;
  std::vector<std::string> edges{};  // of the others
  std::size_t others = 0;
};

std::string without_numbers(const std::string& finding) {
  static const std::regex number("\\b(edge|face) [0-9]+\\b"), place("\\([-+.,e0-9 ]+\\)");
  return std::regex_replace(std::regex_replace(finding, number, "$1"), place, "()");
}

std::string first_edge(const std::string& finding) {
  static const std::regex edge("\\bedge ([0-9]+)\\b");
  std::smatch found;
  return std::regex_search(finding, found, edge) ? found[1].str() : std::string();
}

std::string likewise(const FindingKind& kind) {
  if (kind.edges.size() < kind.others) return "; likewise " + std::to_string(kind.others) + " more";
  std::string text = kind.others == 1 ? "; likewise edge " : "; likewise edges ";
  const std::size_t named = kind.others == kFewEdges + 1 ? kind.others : kFewEdges;
  for (std::size_t i = 0; i < std::min(named, kind.others); ++i) {
    const bool last = i > 0 && i + 1 == kind.others;
    text += (i == 0 ? "" : last ? " and " : ", ") + kind.edges[i];
  }
  if (kind.others > named) text += " and " + std::to_string(kind.others - named) + " more";
  return text;
}

}  // namespace

std::vector<std::string> by_kind(const std::vector<std::string>& findings) {
  std::vector<FindingKind> kinds;
  for (const std::string& finding : findings) {
    const std::string words = without_numbers(finding);
    const auto known = std::ranges::find(kinds, words, &FindingKind::words);
    if (known == kinds.end()) {
      kinds.push_back({words, finding});
      continue;
    }
    ++known->others;
    const std::string edge = first_edge(finding);
    if (!edge.empty()) known->edges.push_back(edge);
  }
  std::vector<std::string> lines;
  for (const FindingKind& kind : kinds)
    lines.push_back(kind.first + (kind.others > 0 ? likewise(kind) : ""));
  return lines;
}

std::string listed(const std::vector<std::string>& words, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? ", " : " " + last + " ";
    text += words[i];
  }
  return text;
}

std::string nearest_word(const std::string& typed, const std::vector<std::string>& words) {
  std::vector<std::string> longer;
  for (const std::string& word : words)
    if (!typed.empty() && word.starts_with(typed)) longer.push_back(word);
  if (longer.size() == 1) return longer.front();
  std::string nearest;
  std::size_t least = 1 + std::max<std::size_t>(1, typed.size() / 3);
  for (const std::string& word : words) {
    const std::size_t distance = edit_distance(typed, word);
    if (distance < least) {
      least = distance;
      nearest = word;
    }
  }
  return nearest;
}

}  // namespace blossom::reports
