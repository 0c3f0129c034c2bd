// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces, edges and solids by number, in the words that the doors of text have in common.

#pragma once

#include <optional>
#include <string_view>

namespace blossom::reports {

/// The 12 of "12", "edge:12" and "Edge12", as other programs name it, whatever the case of the
/// letters; nothing if it is none of these.
///
/// kind   "face", "edge" or "solid"
std::optional<int> entity_number(std::string_view word, std::string_view kind);

/// All numbers from the first to the last.
struct EntityRange {
  int first = 0, last = 0;
};

/// The same, or a range, "5-9"; nothing if it is none, runs backwards, or has more than a million.
std::optional<EntityRange> entity_range(std::string_view word, std::string_view kind);

}  // namespace blossom::reports
