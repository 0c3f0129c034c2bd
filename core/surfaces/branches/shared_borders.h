// SPDX-License-Identifier: LGPL-2.1-or-later
// Stretches of borders at which surfaces touch, as tangential curves.

#pragma once

#include "core/cells/surface_cells.h"
#include "core/surfaces/coincidence/overlaps.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// Adds a border to what the search found, as tangential arcs in place of the arcs and contacts
/// that the search has along it. Nothing changes if a branch begins at such a contact.
///
/// returns   whether it was added
bool add_shared_border(const SharedBorder& border, PairSearchResult& found);

}  // namespace blossom
