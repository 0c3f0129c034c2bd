// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips of balls that lean on the far edge of a face which is too narrow for them.
//
// A ball that is larger than a face is wide, as in a step lower than its radius, rolls along the
// face's far edge if nothing goes on behind it that the ball would touch: the strip ends there with
// its sections leaning on the edge, and the face is consumed. That far edge is of the other kind
// than the one that is rounded, so the ball meets it from outside.

#pragma once

#include <optional>
#include <string>

#include "adapters/occt/blending/strips/rolled_strip.h"

namespace blossom::occt {

/// The strip of `swept_strip`; where a contact of it lies beyond the far edge of a face with four
/// edges, that of the ball which leans there; on both sides only if it cannot on one.
/// throws   FilletRefused if there is no such ball
std::optional<RolledStrip> swept_or_held_strip(const BodyEdges& body, int edge, bool concave,
                                               double radius);

/// "edge 12: ..." of a strip that leans on an edge, as a note; empty for others.
std::string held_text(const RolledStrip& strip);

}  // namespace blossom::occt
