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

/// False if no answer at the finer tolerance settles what a search left open: where anything
/// overlaps, where a place other than a touch holds a near miss that the finer search leaves out,
/// and where there are but touches that stay within the finer tolerance.
bool may_be_settled(const SurfaceIntersection& found, double finer_tolerance);

/// True if what a search left open is told by the answer at a finer tolerance: that answer is
/// complete, one of its curves or points may be in each open place, and is in each other place,
/// too, or that holds no near miss, surfaces apart by more than the finer tolerance, which the
/// finer search leaves out. False where anything overlaps: a region within the coarser tolerance is
/// not given up for curves.
///
/// tolerance, finer_tolerance   of both, model units
bool is_settled(const SurfaceIntersection& found, const SurfaceIntersection& finer,
                double tolerance, double finer_tolerance);

/// The finer answer as one at the coarser tolerance: `tolerance`, with the reason, since near
/// misses between the two in the places that were open are not told.
SurfaceIntersection settled(SurfaceIntersection finer);

}  // namespace blossom
