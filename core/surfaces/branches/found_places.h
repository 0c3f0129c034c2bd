// SPDX-License-Identifier: LGPL-2.1-or-later
// Where what was found lies in space and in the surfaces' own parameters.

#pragma once

#include <array>
#include <vector>

#include "core/bounds/box_tree.h"
#include "core/cells/surface_cells.h"
#include "core/math/interval.h"
#include "core/results/result.h"
#include "core/surfaces/branches/arc_chains.h"
#include "core/surfaces/contacts/contact_chain.h"
#include "core/surfaces/contacts/critical_places.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// A point of contact: in space halfway between the surfaces. Cells are relative to `origin`.
SurfacePoint surface_point(SurfaceCells& a, SurfaceCells& b, const Vec3& origin,
                           const ContactPoint& point);

/// The rectangles of a critical pair in the surfaces' own parameters, and of all pairs of a
/// cluster.
std::array<Interval, 4> parameters_of(const SurfaceCells& a, const SurfaceCells& b,
                                      const CriticalPair& pair);
std::array<Interval, 4> parameters_of(const SurfaceCells& a, const SurfaceCells& b,
                                      const std::vector<CriticalPair>& critical,
                                      const CriticalCluster& cluster);

/// The box of all ends of a chain's arcs, relative to the cells' origin.
Box end_box(SurfaceCells& a, const PairSearchResult& found, const Chain& chain);

/// An open place round a point, as large as the tolerance, model units.
Place place_at(const SurfacePoint& point, double tolerance);

}  // namespace blossom
