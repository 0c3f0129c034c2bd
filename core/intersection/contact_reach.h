// SPDX-License-Identifier: LGPL-2.1-or-later
// What belongs to a contact because the surfaces stay in contact on the way to it.

#pragma once

#include "core/intersection/contact_chains.h"
#include "core/intersection/pair_search.h"

namespace blossom {

/// A point of one pair of patches in the parameters of the pair of `to`.
Point4 in_patches(const SurfaceCells& a, const SurfaceCells& b, int from_a, int from_b,
                  const Point4& x, const ContactPoint& to);

/// True if the surfaces stay within a few tolerances of each other between two points of contact,
/// as far as points in between tell.
bool in_contact(SurfaceCells& a, SurfaceCells& b, const ContactPoint& p, const ContactPoint& q,
                double tolerance);

/// Takes out the critical pairs beside which a line of contact passes, if such a line was found
/// there: all they may hold belongs to it.
///
/// tolerance   model units
void drop_beside_contacts(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b,
                          double tolerance);

}  // namespace blossom
