// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids that may touch each other, in sets that can be cut as one.

#pragma once

#include <cstddef>
#include <vector>

#include <TopoDS_Solid.hxx>

#include "adapters/occt/shared_limit.h"

namespace blossom::occt {

/// Puts each solid into the first layer of which no solid is as near as the tolerance and the
/// largest ones of both together: places in `solids`, in order. Solids whose distance stays open
/// count as touching, as all do when the limit is reached.
///
/// tolerance  model units
std::vector<std::vector<std::size_t>> solid_layers(const std::vector<TopoDS_Solid>& solids,
                                                   double tolerance, const SharedLimit& limit);

}  // namespace blossom::occt
