// SPDX-License-Identifier: LGPL-2.1-or-later
// Drawings as DXF, in the form of release 12 that all readers know.

#pragma once

#include <string>
#include <vector>

#include "plugin/drawings/drawing.h"

namespace blossom::drawings {

/// A layer for each plane, "DECK" or "PLANE_1", and where there are several
/// parts one for each of them in it, "PLANE_1-Shaft". Lines, circles and arcs are such, all else
/// polylines; x and y are those of the plane, z the elevation. Letters that layers cannot have
/// become "_".
std::string dxf_text(const std::vector<DrawnPlane>& planes);

}  // namespace blossom::drawings
