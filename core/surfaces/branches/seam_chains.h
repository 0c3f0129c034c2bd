// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves that go on across the seams of closed surfaces.
//
// A curve ends where a parameter jumps, as edges of faces do. Where the surface runs into itself,
// the curve goes on from there; pieces that follow each other so are one curve.

#pragma once

#include <span>
#include <vector>

#include "core/forms/surface.h"
#include "core/results/result.h"

namespace blossom {

struct ChainUse {
  int curve = 0;        ///< its place in the list
  bool forward = true;  ///< false: walked from its last point to the first one
};

struct CurveChain {
  std::vector<ChainUse> uses;  ///< in order; one for a curve that goes on nowhere
  bool closed = false;         ///< the last use ends where the first one starts
};

/// Every curve in one chain, chains in the order of their first curves.
///
/// Two ends continue each other if they are one point of space and, in both charts, one place or
/// two that differ by a whole turn of a closed direction, or lie in one pole, in one of them at
/// least. Of several such ends those go together that leave in the most opposite directions.
///
/// a, b        the surfaces of the curves
/// tolerance   model units; ends as near as this are one point
std::vector<CurveChain> chains_over_seams(std::span<const IntersectionCurve> curves,
                                          const BezierSurface& a, const BezierSurface& b,
                                          double tolerance);

}  // namespace blossom
