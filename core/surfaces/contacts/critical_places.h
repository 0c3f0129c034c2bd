// SPDX-License-Identifier: LGPL-2.1-or-later
// Critical pairs of cells gathered into places.
//
// Neighbouring critical pairs belong together: a touch, a node or a tangential contact leaves a
// cluster of them. What a cluster is follows from its size and from the arcs that end on it.

#pragma once

#include <vector>

#include "core/bounds/box_tree.h"
#include "core/cells/surface_cells.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// A connected set of critical pairs.
struct CriticalCluster {
  std::vector<int> pairs;  ///< indices into the search's critical pairs
  Box box;                 ///< relative to the origin
  bool within_tolerance =
      true;               ///< all pairs ended because the surfaces are within tolerance there
  bool singular = false;  ///< some pair is singular
};

/// The clusters of all critical pairs. Pairs whose boxes meet are in one cluster; of very many
/// pairs, also those that fall into neighbouring cells of a grid.
std::vector<CriticalCluster> clusters_of(const std::vector<CriticalPair>& pairs);

/// Makes one of a singular cluster and those no farther from it than its size and the tolerance:
/// near a pinch point two sheets of the surface are within tolerance, too.
void join_singular(std::vector<CriticalCluster>& clusters, double tolerance);

/// True if some pair of the cluster reaches a border of its patches. A common region ends at such
/// borders; a contact within both surfaces keeps away from them.
bool meets_border(const CriticalCluster& cluster, const std::vector<CriticalPair>& pairs);

/// True if the surfaces are proven to be one over an area of the cluster, not just along a border.
bool holds_area(const CriticalCluster& cluster, const std::vector<CriticalPair>& pairs);

}  // namespace blossom
