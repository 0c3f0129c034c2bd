// SPDX-License-Identifier: LGPL-2.1-or-later
// In which order edges get their fillets where those of several kinds or radii meet.

#pragma once

#include <vector>

#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/fillet.h"

namespace blossom::occt {

/// Edges whose fillets are made at once, group after group, each in what the ones before made; each
/// edge in the last group that it may be in.
///
/// Where of three edges at a vertex one of its kind meets the others, whether these all have
/// fillets or not, it comes first: its strip ends in a face that the others have in common, and
/// they go on smoothly along that end. Edges of one kind that meet are of one group, as their
/// corners need all of them; so are edges of both kinds that meet in a vertex of more than three
/// sharp edges, but for two and two, or three and three, that alternate: of these the concave ones
/// come first, which meet in mitres, and the others go on over them. Where these rules contradict
/// each other only edges that have fillets count, and where they still do the kind that more
/// corners ask for comes first.
///
/// But of three edges of one kind at a vertex, two of which have one radius, the third one comes
/// first if its own is larger: the smaller ball rolls on along the end of the larger one's strip,
/// in which it fits.
std::vector<FilletEdges> fillet_order(const BodyEdges& body, const FilletEdges& edges,
                                      const FilletOptions& options);

}  // namespace blossom::occt
