// SPDX-License-Identifier: LGPL-2.1-or-later
// Sums of points with seven coordinates in vector registers.

#pragma once

#include <cstring>

#include "core/math/four.h"
#include "core/math/vec.h"

namespace blossom {

/// Two fours that have the middle one of seven coordinates in common.
struct PackedVec7 {
  Four low{}, high{};
};

[[gnu::always_inline]] inline void load(const Vec<double, 7>& x, PackedVec7& to) {
  std::memcpy(&to.low, x.coordinates.data(), sizeof to.low);
  std::memcpy(&to.high, x.coordinates.data() + 3, sizeof to.high);
}

[[gnu::always_inline]] inline void store(const PackedVec7& x, Vec<double, 7>& to) {
  std::memcpy(to.coordinates.data(), &x.low, sizeof x.low);
  std::memcpy(to.coordinates.data() + 3, &x.high, sizeof x.high);
}

/// sum += factor x.
[[gnu::always_inline]] inline void add(double factor, const Vec<double, 7>& x, PackedVec7& sum) {
  PackedVec7 loaded;
  load(x, loaded);
  sum.low += factor * loaded.low;
  sum.high += factor * loaded.high;
}

}  // namespace blossom
