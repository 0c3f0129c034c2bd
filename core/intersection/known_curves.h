// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves along which the surfaces are known to touch: edges that two faces share.
//
// Two faces that go on smoothly across their common edge stay close to each other on both sides of
// it, and their borders agree only within the edge's tolerance. No subdivision can tell there what
// meets and what does not, and none has to: the model says it.

#pragma once

#include <vector>

#include "core/bounds/box_tree.h"
#include "core/intersection/options.h"

namespace blossom {

class KnownCurves {
 public:
  /// origin   taken away from the curves' points, as from the cells
  KnownCurves(const std::vector<KnownCurve>& curves, const Vec3& origin);

  bool empty() const { return links_.empty(); }

  /// True if all of the box lies within a curve's radius of it.
  bool hold(const Box& box) const;

 private:
  struct Link {
    Vec3 from, to;
    double radius;
  };
  std::vector<Link> links_;
};

}  // namespace blossom
