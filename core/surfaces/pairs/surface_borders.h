// SPDX-License-Identifier: LGPL-2.1-or-later
// Which borders of a pair of cells are borders of the surfaces.

#pragma once

#include <array>

#include "core/cells/surface_cells.h"

namespace blossom {

/// Which borders of a pair are borders of the whole surfaces, by parameter; not the second one
/// of the two that meet in the seam of a closed surface.
struct SurfaceBorders {
  std::array<bool, 4> high{};
};

/// The upper borders of a pair of cells beyond which the surfaces end.
SurfaceBorders upper_borders(const SurfaceCells& a, int patch_a, const Cell& cell_a,
                             const SurfaceCells& b, int patch_b, const Cell& cell_b);

}  // namespace blossom
