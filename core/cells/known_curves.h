// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves along which the surfaces are known to touch: edges that two faces share.
//
// Two faces that go on smoothly across their common edge stay close to each other on both sides of
// it, and their borders agree only within the edge's tolerance. No subdivision can tell there what
// meets and what does not, and none has to: the model says it.

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/bounds/box_tree.h"
#include "core/results/options.h"

namespace blossom {

class KnownCurves {
 public:
  /// origin   taken away from the curves' points, as from the cells
  KnownCurves(const std::vector<KnownCurve>& curves, const Vec3& origin);

  bool empty() const { return capsules_.empty(); }

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
  bool compare_with(double extent) const { return extent <= kMaxRadii * widest_; }

 private:
  // A piece of a polygon with all that lies within a radius of it.
  struct Capsule {
    Vec3 from, step;
    double inverse_square;  // of the step's length; 0 for a point
    double square_radius;

    bool holds(const Vec3& p) const {
      const Vec3 aside = p - from;
      const Vec3 rest = aside - std::clamp(dot(aside, step) * inverse_square, 0.0, 1.0) * step;
      return dot(rest, rest) <= square_radius;
    }
    bool holds(const Box& box) const;
  };
  // Capsules that follow one another, so that most points are seen to be far from all of them.
  struct Run {
    Box box;
    std::size_t first, last;
  };

  void add(const KnownCurve& curve, const Vec3& origin);
  template <class Wanted>
  bool any_round(const Vec3& p, Wanted wanted) const;
  bool hold(const Box& box, int halvings) const;

  static constexpr double kMaxRadii = 16;

  std::vector<Capsule> capsules_;
  std::vector<Run> runs_;
  double widest_ = 0;
};

}  // namespace blossom
