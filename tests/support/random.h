// SPDX-License-Identifier: LGPL-2.1-or-later
// Random numbers for property tests. A seed gives the same numbers on every machine.

#pragma once

#include <cstdint>
#include <random>

namespace blossom::testing {

using Random = std::mt19937_64;

inline Random seeded(int seed) { return Random(static_cast<std::uint64_t>(seed) + 1); }

/// Uniform in [low, high); by hand, since the standard's distributions differ between libraries.
inline double uniform(Random& random, double low, double high) {
  const double unit = static_cast<double>(random() >> 11) * 0x1p-53;
  return low + (high - low) * unit;
}

/// One of low, low + 1, .., high.
inline int pick(Random& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
}

}  // namespace blossom::testing
