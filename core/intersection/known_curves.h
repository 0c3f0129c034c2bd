// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves along which the surfaces are known to touch: edges that two faces share.
//
// Two faces that go on smoothly across their common edge stay close to each other on both sides of
// it, and their borders agree only within the edge's tolerance. No subdivision can tell there what
// meets and what does not, and none has to: the model says it.

#pragma once

#include <algorithm>
#include <vector>

#include "core/bounds/box_tree.h"
#include "core/intersection/options.h"

namespace blossom {

class KnownCurves {
 public:
  /// origin   taken away from the curves' points, as from the cells
  KnownCurves(const std::vector<KnownCurve>& curves, const Vec3& origin);

  bool empty() const { return links_.empty(); }

  /// True if all of the box is seen to lie within the curves' radii of them.
  bool hold(const Box& box) const;

  /// The same for what two boxes that meet have in common: surfaces in them meet nowhere else.
  bool hold_common(const Box& a, const Box& b) const {
    Box common;
    for (int k = 0; k < 3; ++k) {
      common.low[k] = std::max(a.low[k], b.low[k]);
      common.high[k] = std::min(a.high[k], b.high[k]);
    }
    return !empty() && hold(common);
  }

  /// True if a cell of this size is not much larger than the curves' radii: larger ones may yet
  /// tell what is beside the curve exactly.
  bool compare_with(double extent) const { return extent <= kMostRadii * widest_; }

 private:
  struct Link {
    Vec3 from, to;
    double radius;
  };

  bool hold(const Box& box, int halvings) const;
  static bool holds_corners(const Link& link, const Box& box);

  static constexpr double kMostRadii = 16;

  std::vector<Link> links_;
  double widest_ = 0;
};

}  // namespace blossom
