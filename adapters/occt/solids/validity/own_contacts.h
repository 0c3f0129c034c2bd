// SPDX-License-Identifier: LGPL-2.1-or-later
// Where solids that could not be combined meet themselves: what is inside of them is not known
// there.

#pragma once

#include <vector>

#include "adapters/occt/solid_trim.h"

namespace blossom::occt {

/// Where faces of one solid of an input meet each other beside the edges and vertices that they
/// share, or a face itself beside its seam: one for each pair of faces, in the order of these.
///
/// tool      what the input is, as in `InputFace`
/// options   with a time limit: what is found by then is told
/// throws    BadModel if a face cannot be converted
std::vector<Finding> own_contacts(const TrimTool& input, int tool,
                                  const IntersectionOptions& options);

}  // namespace blossom::occt
