// SPDX-License-Identifier: LGPL-2.1-or-later
// Places that stay open at one tolerance and are regular at a finer one.
//
// Where surfaces cross at a small angle they stay within tolerance of each other along a strip, and
// what is in it is sought as a contact. At a finer tolerance the strip is thinner, and the same
// curve may be a regular one, with a proof.

#pragma once

#include <array>

#include "core/results/result.h"

namespace blossom {

/// The tolerances of further attempts, as parts of the first one.
inline constexpr std::array kFinerTolerances{0.1, 0.01};

/// True if a branch ends on the border of a region in which several meet, or nearly: at a finer
/// tolerance they may pass each other.
bool ends_beside_node(const SurfaceIntersection& found);

/// False if no answer at the finer tolerance can decide what a search left open: something
/// overlaps; a place that is neither open nor a touch holds a near miss, which the finer search
/// cannot see; or there are only touches whose surfaces stay within the finer tolerance.
bool may_be_settled(const SurfaceIntersection& found, double finer_tolerance);

/// True if the answer at a finer tolerance decides what a search left open. It does if
///   (1) the finer answer is complete, and nothing overlaps in the coarser one; where
///       branches ended beside a node it may list contacts, but no node
///   (2) each open place may hold one of the finer curves or points
///   (3) each other place holds one, or the surfaces come within the finer tolerance there; where
///       they do not, it is a near miss, which the finer search cannot see
///
/// tolerance, finer_tolerance   of both, model units
bool is_settled(const SurfaceIntersection& found, const SurfaceIntersection& finer,
                double tolerance, double finer_tolerance);

/// The finer answer as one at the coarser tolerance: `tolerance`, with the reason, since near
/// misses between the two in the places that were open are not told.
SurfaceIntersection settled(SurfaceIntersection finer);

}  // namespace blossom
