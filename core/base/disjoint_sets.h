// SPDX-License-Identifier: LGPL-2.1-or-later
// Sets of numbered elements that are joined step by step.

#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace blossom {

/// Elements 0, 1, ..., each in a set of its own at first. Each set is known by one of its elements.
/// Source: Tarjan and van Leeuwen 1984, path halving without ranks.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count = 0) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t size() const { return parent_.size(); }

  /// A new element in a set of its own; returns its number.
  std::size_t add() {
    parent_.push_back(parent_.size());
    return parent_.back();
  }

  /// The element by which the set of `i` is known.
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// Makes one of two sets; it is known as that of `into` was.
  void join(std::size_t i, std::size_t into) { parent_[find(i)] = find(into); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace blossom
