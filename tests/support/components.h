// SPDX-License-Identifier: LGPL-2.1-or-later
// What an intersection consists of, in numbers that can be compared.

#pragma once

#include <ostream>

#include "core/results/result.h"

namespace blossom::testing {

struct Components {
  int open = 0;        ///< curves that are not closed, tangential ones among them
  int closed = 0;      ///< likewise
  int tangential = 0;  ///< of both
  int points = 0;
  int nodes = 0;

  friend bool operator==(const Components&, const Components&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Components& c) {
    return out << "(" << c.open << " open, " << c.closed << " closed, " << c.tangential
               << " tangential, " << c.points << " points, " << c.nodes << " nodes)";
  }
};

inline Components components(const SurfaceIntersection& found) {
  Components c;
  for (const IntersectionCurve& curve : found.curves) {
    ++(curve.closed ? c.closed : c.open);
    c.tangential += curve.tangential;
  }
  c.points = static_cast<int>(found.points.size());
  c.nodes = static_cast<int>(found.nodes.size());
  return c;
}

}  // namespace blossom::testing
