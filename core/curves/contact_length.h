// SPDX-License-Identifier: LGPL-2.1-or-later
// When a contact of curves is a point and when a run.

#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace blossom {

/// A contact shorter than this is a point. Two curves that touch with the curvature of their own
/// size stay within tolerance of each other along a third of that.
inline double curve_touch_length(double tolerance, double size) {
  constexpr double kCurveTouch = 10;
  return kCurveTouch * std::sqrt(tolerance * size);
}

/// A longer one is a run if the gap, sampled along it, is far below the tolerance along most of
/// it, below along nearly all, or far below hardly anywhere: two curves side by side. A contact of
/// order k keeps below a part p of the tolerance along p^(1/k) of its length, which is less than
/// kMax and kNearlyAll up to order 9.
inline bool is_common_run(std::span<const double> gaps, double tolerance, double margin) {
  constexpr double kFarBelow = 0.01, kBelow = 0.1;
  constexpr double kMax = 0.6, kNearlyAll = 0.85, kHardly = 0.05;
  const auto share_below = [&](double part) {
    const auto near =
        std::ranges::count_if(gaps, [&](double gap) { return gap < part * tolerance + margin; });
    return static_cast<double>(near) / static_cast<double>(gaps.size());
  };
  const double far_below = share_below(kFarBelow);
  return far_below > kMax || far_below < kHardly || share_below(kBelow) > kNearlyAll;
}

}  // namespace blossom
