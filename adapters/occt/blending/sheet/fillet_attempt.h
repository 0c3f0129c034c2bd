// SPDX-License-Identifier: LGPL-2.1-or-later
// Chains of edges that are rounded together, or why they cannot be.

#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/sheet/filleting.h"
#include "adapters/occt/fillet.h"

namespace blossom::occt {

struct FilletAttempt {
  std::vector<FilletedSolid> solids;
  std::vector<std::string> notes;
  std::set<int> gone_on;  ///< as `Filleting::gone_on`
  std::optional<FilletRefusal> why;
  bool is_tolerant = false;  ///< as `Filleting::is_tolerant`
};

/// radius   model units
/// throws   LimitFailure
FilletAttempt fillet_attempt(Filleting& work, const std::vector<FilletEdges>& chains,
                             double radius);

/// Why balls of a radius do not roll along the edges, or chamfers do not run along them; nothing if
/// they do, whatever is at their ends.
/// throws   LimitFailure
std::optional<FilletRefusal> roll_attempt(Filleting& work, const std::vector<FilletEdges>& chains,
                                          double radius);

/// Whether a chain has its fault alone, whatever else is rounded.
bool is_own_fault(FilletFault fault);

}  // namespace blossom::occt
