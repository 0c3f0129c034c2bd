// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles over curved arcs in lower degrees, with bounds.

#pragma once

#include <map>
#include <utility>

#include "core/forms/algebra/degree.h"
#include "core/forms/triangle.h"

namespace blossom {

/// Lowers degrees of triangles; matrices are kept for the next one.
class TriangleLowering {
 public:
  /// The triangle in the lowest degree within the tolerance, or in the highest one if none is.
  /// Sides of a degree up to `lowest` stay as they are, to rounding.
  ///
  /// lowest, highest   degrees; the result's is one of them, or the triangle's own if that is lower
  /// tolerance         model units
  /// returns           the triangle, and a bound on its distance from the given one at equal
  ///                   parameters; model units
  ReducedOf<BezierTriangle> operator()(const BezierTriangle& triangle, int lowest, int highest,
                                       double tolerance);

  /// The same of homogeneous points with positive weights; where all are 1 they stay 1.
  ///
  ///   |Y/w - Y'/w'| <= (|Y - Y'| + R |w - w'|) / w',   Y = X - c w,   |Y/w| <= R
  ///
  /// returns   the bound in space, model units
  ReducedOf<RationalBezierTriangle> operator()(const RationalBezierTriangle& triangle, int lowest,
                                               int highest, double tolerance);

 private:
  template <class Point>
  ReducedOf<BezierTriangleOf<Point>> lowered(const BezierTriangleOf<Point>& triangle, int lowest,
                                             int highest, double tolerance);
  const TriangleReduction& reduction(int from, int to);

  std::map<std::pair<int, int>, TriangleReduction> reductions_;
};

}  // namespace blossom
