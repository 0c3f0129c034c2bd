// SPDX-License-Identifier: LGPL-2.1-or-later
// When a contact of curves is a point and when a run.

#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace blossom {

/// A contact shorter than this is a point. Two curves that touch with the curvature of their own
/// size stay within tolerance of each other along a third of that.
inline double longest_touch(double tolerance, double size) {
  return 10 * std::sqrt(tolerance * size);
}

/// A longer one is a run if the gap, sampled along it, is far below the tolerance along most of
/// it, or hardly anywhere: two curves side by side. A contact of order k is that near along
/// 0.01^(1/k) of its length, which is below 0.6 up to order 9.
inline bool is_common_run(std::span<const double> gaps, double tolerance, double margin) {
  constexpr double kFar = 0.01, kMost = 0.6, kHardly = 0.05;
  const auto near = std::count_if(gaps.begin(), gaps.end(),
                                  [&](double g) { return g < kFar * tolerance + margin; });
  const double share = static_cast<double>(near) / static_cast<double>(gaps.size());
  return share > kMost || share < kHardly;
}

}  // namespace blossom
