// SPDX-License-Identifier: LGPL-2.1-or-later
// Where two cuts of a face cross each other, with those that touch told from those that cross
// twice.

#pragma once

#include <vector>

#include "core/plane/planar_crossings.h"

namespace blossom {

/// A node of two cuts. At the end of a closed cut it has two parameters.
struct CutCrossing {
  std::vector<double> a, b;
  Vec2 point;
  double uncertainty = 0;  ///< how far from the point the cuts cross as well, by what they are off
  std::vector<double> beside{};  ///< on a, where that is
};

struct CutCrossings {
  std::vector<CutCrossing> nodes;
  bool complete = true;  ///< as PlanarCrossings
};

/// The nodes of two cuts. Crossings between which the cuts keep within tolerance of each other, no
/// farther apart than a touch may take, are one node: half way, or where a cut ends there. So are
/// an end that lies on the other cut and a crossing beside it. The ends of runs that cuts share are
/// none.
///
/// tolerance  distance in the chart, positive
/// longest    of a touch, in the chart
CutCrossings cut_crossings(const PlanarCurve& a, const PlanarCurve& b, double tolerance,
                           double longest);

/// A parameter on the way from one to another, over the end of a closed curve where that is
/// shorter.
///
/// part       of the way, from 0 to 1
/// tolerance  ends so near are one, in the chart
double on_the_way(const PlanarCurve& curve, double from, double to, double part, double tolerance);

}  // namespace blossom
