// SPDX-License-Identifier: LGPL-2.1-or-later
// Drawings as SVG, to look at and to print.

#pragma once

#include <string>
#include <vector>

#include "plugin/drawings/drawing.h"

namespace blossom::drawings {

/// The planes side by side in rows, all at one scale, each in a group with its name as a title and
/// a group for each of its parts. What closed wires of solids bound is hatched, each part with a
/// colour and an angle of its own; a legend has the names of several parts. One unit is a
/// millimetre.
std::string svg_text(const std::vector<DrawnPlane>& planes);

}  // namespace blossom::drawings
