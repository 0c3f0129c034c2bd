// SPDX-License-Identifier: LGPL-2.1-or-later
// Where solids that could not be combined meet themselves: what is inside of them is not known
// there.

#pragma once

#include <vector>

#include "adapters/occt/solid_trim.h"

namespace blossom::occt {

/// Where faces of one solid of an input meet each other beside the edges and vertices that they
/// share, or a face itself beside its seam: one for each pair of faces, in the order of inputs and
/// of these. Solids of which the box meets nothing else are not asked: operations leave them as
/// they are.
///
/// What all pairs of faces of a solid may examine is, for each face, an equal part of what one
/// search may; what is not known then is not told. So the answer does not depend on the clock.
///
/// options   when their time limit is reached, what is found by then is told
/// throws    BadModel if a face cannot be converted
std::vector<Finding> own_contacts(const TrimTool& part, const std::vector<TrimTool>& tools,
                                  const IntersectionOptions& options);

}  // namespace blossom::occt
