// SPDX-License-Identifier: LGPL-2.1-or-later
// All points that two planar curves have in common: what `core/curves/curve_meeting.h`
// finds, in the terms of charts. Trims need no proofs but ends: what cannot be told from an end of
// a curve is that end.

#pragma once

#include <vector>

#include "core/plane/planar_curves.h"

namespace blossom {

struct PlanarCrossing {
  double a = 0;  ///< parameters of the two curves
  double b = 0;
  Vec2 point;
  bool tangential = false;  ///< the directions could not be told apart
};

/// A run along which the curves stay within tolerance of each other.
struct PlanarOverlap {
  Interval a;  ///< increasing
  Interval b;  ///< the parameters of b at the ends of `a`; may decrease
};

struct PlanarCrossings {
  std::vector<PlanarCrossing> points;  ///< by increasing parameter of a; each once
  std::vector<PlanarOverlap> overlaps;
  bool complete = true;  ///< false when the budget was spent
};

/// Pairs of pieces looked at before giving up.
inline constexpr long kPlanarBudget = 400'000;

/// The common points of two curves. An end of one curve that lies within tolerance of the other
/// counts as common; a crossing within tolerance of an end is moved to that end. Spans that follow
/// each other within a sixteenth of the tolerance are taken for their chord: parameters in them are
/// as good as that.
///
/// tolerance  distance, in the unit of the plane; positive
/// throws     InvalidInput if the tolerance is not positive or a curve has no span
PlanarCrossings crossings(const PlanarCurve& a, const PlanarCurve& b, double tolerance,
                          long budget = kPlanarBudget);

}  // namespace blossom
