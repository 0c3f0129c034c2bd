// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts that are none, since the surfaces only come closer to a branch of another cell.

#pragma once

#include <vector>

#include "core/cells/surface_cells.h"
#include "core/surfaces/contacts/contact_chain.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// Takes out contacts without branches of their own along which the surfaces come closer up to an
/// end in the middle of both patches, from where the gap goes on falling towards a branch that was
/// found. All else stays: what ends where nothing was searched, or where cells stayed open.
///
/// tolerance   model units
void drop_near_misses(std::vector<ContactChain>& chains, const PairSearchResult& found,
                      SurfaceCells& a, SurfaceCells& b, double tolerance);

}  // namespace blossom
