// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest radius with which edges can be rounded, whatever radius was asked for.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/sheet/filleting.h"
#include "adapters/occt/fillet.h"

namespace blossom::occt {

struct LargestFillet {
  double radius = 0;      ///< model units; all edges were rounded with it
  std::string stopped;    ///< what stops larger balls, in words; empty where only rounding told
  bool at_least = false;  ///< the search ended before it knew that none that is larger works
};

/// The largest radius that works, on the range of such radii that is next to the one asked for.
///
/// Radii are tried on a ladder that does not depend on the one asked for, in steps of 2^(1/2): from
/// the second rung above it down to where balls roll along all edges, then to where all are
/// rounded. Between there and the rung above, the largest with which the edges near the place that
/// fails are rounded alone; that place has the next one then, until all are rounded. So the answer
/// is the same for any radius asked for from which no wider gap than a rung lies before that range.
///
/// Balls stop where a condition has its solution (`fillet_limit`), to 1e-8 of the radius, or else
/// where rolling tells; blends meet where the share of an edge that they take tells; the rest is
/// told by rounding: a larger radius fails for what is near some place. Rolling and rounding tell
/// to 1e-3, or 1e-6 of up to four edges.
///
/// chains   rounded together
/// why      they cannot be rounded by `radius`
/// returns  nothing if no radius tried from 1e-3 to 16 of the one asked for works, or none can help
/// throws   LimitFailure if the time is up before any radius worked
std::optional<LargestFillet> largest_fillet(Filleting& work, const std::vector<FilletEdges>& chains,
                                            double radius, const FilletRefusal& why);

}  // namespace blossom::occt
