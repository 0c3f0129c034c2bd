// SPDX-License-Identifier: LGPL-2.1-or-later
// Watertight pieces with equal degrees along edges.

#pragma once

#include "core/watertight/watertight_pieces.h"

namespace blossom {

/// Elevates triangles, and sides on edges, until each such side and all triangles that have it are
/// of one degree. The sides' ends are the vertices then.
void raise_degrees(WatertightPieces& pieces);

}  // namespace blossom
