// SPDX-License-Identifier: LGPL-2.1-or-later
// What lies beside a border that two surfaces share.

#pragma once

#include <vector>

#include "core/bounds/box_tree.h"
#include "core/cells/surface_cells.h"
#include "core/results/result.h"
#include "core/surfaces/contacts/critical_places.h"

namespace blossom {

/// Where the surfaces stay within tolerance of each other all over beside a shared border. A branch
/// that comes into it may end there: its border is the contact that is told.
struct BorderStrip {
  std::vector<Box> boxes;  ///< in space
  Place place;             ///< over all of them
  bool told = false;       ///< whether the place is in the result

  bool holds(const Vec3& point) const;
};

/// Of the critical pairs that the border explains. Cells are relative to `origin`; lengths are in
/// model units.
BorderStrip border_strip(const SurfaceCells& a, const SurfaceCells& b, const Vec3& origin,
                         const std::vector<CriticalPair>& pairs, double tolerance);

}  // namespace blossom
