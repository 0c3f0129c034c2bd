// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest radius with which a ball rolls along an edge of a body.

#pragma once

#include <optional>
#include <string>

#include "adapters/occt/blending/body_edges.h"

namespace blossom::occt {

struct FilletLimit {
  double radius = 0;     ///< model units
  std::string cause;     ///< what stops larger balls, in words
  bool reached = false;  ///< whether the ball of that radius itself may still roll
};

/// Nothing if it is not below `most`, or cannot be told: the strip's ends, and other edges that are
/// rounded, are not looked at.
///
/// rolls   a radius with which a ball is known to roll along the edge; 0: none is
std::optional<FilletLimit> fillet_limit(const BodyEdges& body, int edge, bool concave, double rolls,
                                        double most);

}  // namespace blossom::occt
