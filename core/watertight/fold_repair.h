// SPDX-License-Identifier: LGPL-2.1-or-later
// Watertight triangles that do not turn over when their sides are moved.

#pragma once

#include <functional>

#include "core/watertight/watertight_pieces.h"

namespace blossom {

/// Where triangles are lower than their sides on edges were moved, these reach across them. Such
/// triangles are carried along instead: all their points move as their edge does, and so do their
/// sides inside of the face, which triangles behind them have, too. The sides are moved again then,
/// up to four times, and the pieces of which the fewest may turn over are taken.
///
/// unmoved   pieces before equal_degrees.h and border_fitting.h
/// moved     the same after both; gets the better ones and `turned`: those that are not proven to
///           turn nowhere against the unmoved ones, or against those that were carried
/// within    parts of triangles that are narrower do not count (orientation_check.h); model units
/// ask       called between pieces; may throw to end it
void spare_turns(WatertightPieces unmoved, WatertightPieces& moved, double within,
                 const std::function<void()>& ask);

}  // namespace blossom
