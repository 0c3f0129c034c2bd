// SPDX-License-Identifier: LGPL-2.1-or-later
// Words in messages.

#pragma once

#include <string>
#include <vector>

namespace blossom::reports {

/// "cut, common or split".
std::string listed(const std::vector<std::string>& words, const std::string& last = "or");

/// The word that was most likely meant: one that begins so, if it is the only one, else the nearest
/// one by edit distance; empty if none is near.
std::string nearest_word(const std::string& typed, const std::vector<std::string>& words);

}  // namespace blossom::reports
