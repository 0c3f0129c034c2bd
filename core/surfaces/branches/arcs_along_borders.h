// SPDX-License-Identifier: LGPL-2.1-or-later
// Arcs along a border that two pairs of cells share, and whether they are proven.

#pragma once

#include "core/cells/surface_cells.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// Leaves one of the arcs along a border that pairs on both sides of it have. Rounding may put the
/// curve beyond the border for both sides, for one or for none: so neither of them answers alone.
/// `found.along_border` is left only if some arc along a border is neither exactly that border nor
/// proven to be one arc of both sides (`regular_contact.h`).
///
/// size       of the surfaces, model units
/// shortest   arcs along upper borders no longer than this are left to the neighbours, which may
///            have a contact there, as at a pole; model units
void drop_repeated_arcs(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, double size,
                        double shortest);

/// Marks the arcs that run along a border of a whole surface from end to end: both ends are on it,
/// and the other surface passes through it in between. Where the surfaces are nearly parallel
/// rounding would lead points of such an arc beyond the border.
///
/// rounding   largest distance of the other surface, model units
void put_on_borders(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, double rounding);

}  // namespace blossom
