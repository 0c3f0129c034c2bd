// SPDX-License-Identifier: LGPL-2.1-or-later
// Where two surfaces coincide: regions with an area, and borders that both share.
//
// The common region of two surfaces is bounded by pieces of the borders of either that lie on the
// other. So the borders are followed over the other surface, and the pieces chained.

#pragma once

#include <vector>

#include "core/base/work_limit.h"
#include "core/cells/surface_cells.h"
#include "core/surfaces/contacts/contact_chain.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// A stretch of border at which the surfaces touch but do not overlap: a smooth joint, say.
/// Neighbours on the path lie in the same pair of patches, or are one point in two pairs.
struct SharedBorder {
  std::vector<ContactPoint> path;
  int across = 0;  ///< the parameter held, whose border it is: 0 and 1 of a, 2 and 3 of b
  /// The surfaces also stay within tolerance beside it, where more may lie than the border.
  bool wide = false;
};

/// A loop of a region's boundary, the region to its left as seen from the tip of a's normal.
using BoundaryLoop = std::vector<ContactPoint>;

/// A connected region in which the surfaces stay within tolerance of each other.
struct OverlapRegion {
  /// The outer loop, then holes; two loops for a band round a closed direction. Each repeats its
  /// first point; consecutive points may lie in different patches.
  std::vector<BoundaryLoop> loops;
};

struct Overlaps {
  std::vector<OverlapRegion> regions;
  std::vector<SharedBorder> edges;
  const char* stopped = nullptr;  ///< why there are none, though there may be some; null: done
};

/// Regions and shared borders of two surfaces.
///
/// coincident   critical pairs of the search within tolerance; only pairs of patches that occur in
/// them are
///              looked at, and a shared border counts only where they hold it
/// tolerance    surfaces closer than this coincide, model units
/// size         of the surfaces, model units
/// limit        once it is reached nothing is returned but its reason
/// returns      regions wider than about 3 sqrt(tolerance size); found by samples, not proven
///
/// Source: `core/surfaces/README.md`, "Coincidence".
Overlaps find_overlaps(SurfaceCells& a, SurfaceCells& b,
                       const std::vector<CriticalPair>& coincident, double tolerance, double size,
                       const WorkLimit& limit);

/// A region or a shared border as polygons over a surface, to ask which pairs belong to it.
class Coincidence {
 public:
  Coincidence(const OverlapRegion& region, const SurfaceCells& a);
  Coincidence(const SharedBorder& border, const SurfaceCells& a, const SurfaceCells& b);

  /// True if the pair's place lies in the region or meets its boundary or the border: on a, or on
  /// the surface whose border it is.
  bool holds(const CriticalPair& pair) const;

 private:
  const SurfaceCells& own_;
  std::vector<std::vector<Vec2>> paths_;  // without jumps over seams
  bool of_a_;
  bool is_region_;
};

}  // namespace blossom
