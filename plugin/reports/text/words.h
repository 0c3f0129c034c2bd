// SPDX-License-Identifier: LGPL-2.1-or-later
// Words in messages.

#pragma once

#include <string>
#include <vector>

namespace blossom::reports {

/// "cut, common or split".
std::string listed(const std::vector<std::string>& words, const std::string& last = "or");

/// A line for each kind of findings, in their order: those that differ in the numbers of edges and
/// faces and in places are of one kind. It is the first of them, and of the others, with the edges
/// that these name first: "; likewise edges 5, 9, 13, 17 and 42 more".
std::vector<std::string> by_kind(const std::vector<std::string>& findings);

/// The word that was most likely meant: one that begins so, if it is the only one, else the nearest
/// one by edit distance; empty if none is near.
std::string nearest_word(const std::string& typed, const std::vector<std::string>& words);

}  // namespace blossom::reports
