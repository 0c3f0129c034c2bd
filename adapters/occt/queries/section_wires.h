// SPDX-License-Identifier: LGPL-2.1-or-later
// Section curves chained over their nodes. For plane_section.cpp only.

#pragma once

#include "adapters/occt/plane_section.h"

namespace blossom::occt {

/// Fills `wires` from curves and nodes, with their areas. Where more than two curves end in a node,
/// those that are neighbours by angle go on into each other, so that wires touch but do not cross.
/// normal   unit vector of the plane
void chain_wires(PlaneSection& section, const Vec3& normal);

}  // namespace blossom::occt
