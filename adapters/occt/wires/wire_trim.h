// SPDX-License-Identifier: LGPL-2.1-or-later
// Wires, edges and vertices without faces, combined with each other, with sheets and with solids.

#pragma once

#include <string>
#include <vector>

#include "adapters/occt/solid_trim.h"

namespace blossom::occt {

/// Whether one of the inputs has edges or vertices alone.
bool takes_wires(const TrimTool& part, const std::vector<TrimTool>& tools);

/// Why such inputs have no place in the operation; empty if they have.
std::string misplaced_wires(const TrimTool& part, const std::vector<TrimTool>& tools,
                            SolidOperation operation);

/// As `trim_solids`, where `takes_wires` says so and nothing is misplaced.
///
/// Edges are divided where they meet what they are combined with (edge_divider.h), and of the
/// pieces stays what is outside of it (cut), in or on it (common), or both (split); of wires that
/// are fused each stretch once. In common with something else is what has the lowest dimension:
/// where two edges only cross, that is nothing. Tools are taken one after the other.
SolidTrimResult trim_wires(const TrimTool& part, const std::vector<TrimTool>& tools,
                           SolidOperation operation, const IntersectionOptions& options);

}  // namespace blossom::occt
