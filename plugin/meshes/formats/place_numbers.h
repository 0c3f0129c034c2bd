// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of different places. For this folder only.

#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/math/index.h"
#include "core/math/vec.h"

namespace blossom::meshes {

/// Points at equal places are one; 0 and -0 are equal.
class PlaceNumbers {
 public:
  /// points     gets each new place; what is there stays there
  /// expected   how many these may be: fewer or more cost time alone
  explicit PlaceNumbers(std::vector<Vec3>& points, std::size_t expected = 0)
      : points_(points), slots_(std::max(kFirstSlots, std::bit_ceil(2 * expected)), kFree) {}

  int number(Vec3 point) {
    for (double& x : point.coordinates) x += 0.0;  // -0 is 0
    if (2 * (used_ + 1) > slots_.size()) grow();
    int& slot = slots_[slot_of(point)];
    if (slot == kFree) {
      slot = static_cast<int>(points_.size());
      points_.push_back(point);
      ++used_;
    }
    return slot;
  }

 private:
  static constexpr int kFree = -1;
  static constexpr std::size_t kFirstSlots = 64;  // always a power of two

  static std::size_t hash(const Vec3& p) {
    std::uint64_t hash = 0;
    for (const double x : p.coordinates) {
      hash ^= std::bit_cast<std::uint64_t>(x);
      hash *= 0x9e3779b97f4a7c15U;  // odd, of the golden ratio: spreads neighbours
      hash ^= hash >> 32;
    }
    return hash;
  }

  /// Where the point is, or the free slot in which it is to be. At least half of them are free.
  std::size_t slot_of(const Vec3& point) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(point) & mask;
    while (slots_[slot] != kFree && points_[index(slots_[slot])] != point) slot = (slot + 1) & mask;
    return slot;
  }

  void grow() {
    std::vector<int> old(2 * slots_.size(), kFree);
    old.swap(slots_);
    for (const int number : old)
      if (number != kFree) slots_[slot_of(points_[index(number)])] = number;
  }

  std::vector<Vec3>& points_;
  std::vector<int> slots_;  // numbers of points: a node for each would take most of the time
  std::size_t used_ = 0;
};

}  // namespace blossom::meshes
