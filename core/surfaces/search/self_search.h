// SPDX-License-Identifier: LGPL-2.1-or-later
// The search over pairs for a surface and itself.

#pragma once

#include "core/surfaces/search/pair_search.h"

namespace blossom {

/// What pairs of places of one surface have in common, each pair once. Arcs agree on which of two
/// places is the one on a; cells at singular points are among the critical pairs, both ways round.
///
/// cells     of the surface, whose glued borders are marked as closed
/// origin    of the cells
/// size      of the surface, model units
PairSearchResult search_itself(SurfaceCells& cells, const Vec3& origin, double size,
                               const KnownCurves& known, const IntersectionOptions& options);

}  // namespace blossom
