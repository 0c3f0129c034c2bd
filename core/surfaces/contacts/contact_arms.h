// SPDX-License-Identifier: LGPL-2.1-or-later
// Branches of the intersection that run into contacts.

#pragma once

#include <vector>

#include "core/surfaces/contacts/contact_chain.h"

namespace blossom {

/// Makes branches that end near a contact its arms, if the surfaces stay in contact in between.
/// Where an even number of others, more than two, end in one point, that is a contact, too: a
/// corner of patches that join with kinks.
void attach(const std::vector<ArcEnd>& ends, const PairSearchResult& found, SurfaceCells& a,
            SurfaceCells& b, std::vector<ContactChain>& contacts, double size, double tolerance);

/// Lengthens the arms of all points to the points they lead to, two arms to a point of the branch
/// they are of, and tells which points are poles.
///
/// tolerance   model units
void meet_in_centres(std::vector<ContactChain>& contacts, SurfaceCells& a, SurfaceCells& b,
                     PairSearchResult& found, double tolerance);

/// Takes out the points in which the surfaces cross regularly, where nothing but one branch passes,
/// whose arms it joins, or nothing at all. What is no longer than the point goes with it.
void drop_regular(std::vector<ContactChain>& contacts, PairSearchResult& found, SurfaceCells& a);

}  // namespace blossom
