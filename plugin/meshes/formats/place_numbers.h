// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of different places. For this folder only.

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/math/vec.h"

namespace blossom::meshes {

/// Points at equal places are one; 0 and -0 are equal.
class PlaceNumbers {
 public:
  /// points   gets each new place
  explicit PlaceNumbers(std::vector<Vec3>& points) : points_(points) {}

  int number(Vec3 point) {
    for (double& x : point.coordinates) x += 0.0;  // -0 is 0
    const auto [it, is_new] = places_.try_emplace(point, static_cast<int>(points_.size()));
    if (is_new) points_.push_back(point);
    return it->second;
  }

 private:
  struct Hash {
    std::size_t operator()(const Vec3& p) const {
      std::uint64_t hash = 0;
      for (const double x : p.coordinates) {
        hash ^= std::bit_cast<std::uint64_t>(x);
        hash *= 0x9e3779b97f4a7c15U;  // odd, of the golden ratio: spreads neighbours
        hash ^= hash >> 32;
      }
      return hash;
    }
  };

  std::vector<Vec3>& points_;
  std::unordered_map<Vec3, int, Hash> places_;
};

}  // namespace blossom::meshes
