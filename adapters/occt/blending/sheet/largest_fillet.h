// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest radius with which edges can be rounded, found by rounding them.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/sheet/filleting.h"
#include "adapters/occt/fillet.h"

namespace blossom::occt {

struct LargestFillet {
  double radius = 0;    ///< model units; the edges were rounded with it
  std::string stopped;  ///< what stops larger balls, in words; empty where only rounding told
};

/// A radius that works, at most 1 % below one that does not: at or just below where a ball beside
/// the edge at fault is stopped (`fillet_limit`), if that works and a larger one does not; else
/// bracketed. Where only the limit itself fails, larger ones are bracketed as well.
///
/// Each radius that fails names an edge; its limit is looked at next. So a few steps come to the
/// edge of a chain that stops the smallest ball. Of some hundred edges at once only a few radii are
/// tried: the one that works may then be far below one that does not.
///
/// chains   rounded together
/// why      they cannot be rounded by `radius`
/// returns  nothing if no radius down to 1e-3 of the one asked for works, or no radius can help
/// throws   LimitFailure
std::optional<LargestFillet> largest_fillet(Filleting& work, const std::vector<FilletEdges>& chains,
                                            double radius, const FilletRefusal& why);

}  // namespace blossom::occt
