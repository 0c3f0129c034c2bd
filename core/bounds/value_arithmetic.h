// SPDX-License-Identifier: LGPL-2.1-or-later
// Ranges of sums and products. Ends are rounded like any number: who needs bounds adds a slack.

#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/value_range.h"

namespace blossom {

/// Of all products of a value of each.
inline ValueRange times(const ValueRange& a, const ValueRange& b) {
  const auto [least, most] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {least, most};
}

/// The largest absolute value.
inline double magnitude(const ValueRange& range) {
  return std::max(std::abs(range.low), std::abs(range.high));
}

inline ValueRange padded(const ValueRange& range, double pad) {
  return {range.low - pad, range.high + pad};
}

/// Whether all values of one are farther than `distance` from all of the other.
inline bool are_apart(const ValueRange& a, const ValueRange& b, double distance) {
  return a.low > b.high + distance || b.low > a.high + distance;
}

}  // namespace blossom
