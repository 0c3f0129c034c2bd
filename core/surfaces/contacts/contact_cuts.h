// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of what a cell of a holds whose foot points lie in the patch of b.
//
// Charts reach beyond the patch, so branches and contacts that were read in one are cut where they
// leave it. A point so close to a border that it may be on it counts as inside.

#pragma once

#include "core/surfaces/gap/cells/valley.h"

namespace blossom {

/// Branches and contacts, cut where they cross the border of the patch of b between two of their
/// points: a stretch that leaves the patch and comes back between them is not seen, and of one
/// that comes in and leaves again only what the chord shows.
ValleyCell part_inside(const RationalBezierPatch& patch_a, const RationalBezierPatch& patch_b,
                       const ValleyCell& cell);

}  // namespace blossom
