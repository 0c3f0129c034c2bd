// SPDX-License-Identifier: LGPL-2.1-or-later
// What blfillet and blchamfer have in common.

#pragma once

#include <string>

#include "adapters/occt/fillet.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {

/// Blends edges: words are the result, the solid, the size, and edges: numbers, "7:3" with a
/// radius of its own, or "all", "convex" or "concave".
/// returns   how many edges were changed, volumes before and after, and edges that have nothing to
///           be rounded
/// throws    WrongWords; Failure with the place and the cause where an edge is refused
std::string blended_edges(const Words& words, occt::FilletOptions options);

}  // namespace blossom::draw
