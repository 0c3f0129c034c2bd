// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps that all proofs by pairs of cells have in common.

#pragma once

#include <algorithm>

#include "core/cells/cell_tree.h"
#include "core/results/result.h"

namespace blossom {

/// Counts a pair as proven to have nothing in common.
inline void count_excluded(const Cell& a, const Cell& b, Certificate& certificate) {
  ++certificate.excluded;
  certificate.depth = std::max({certificate.depth, a.depth, b.depth});
  certificate.rounding_bound = std::max({certificate.rounding_bound, a.margin, b.margin});
}

/// Whether a is halved rather than b: the larger one that is not as deep as cells may be. One of
/// them has to be.
inline bool halves_first(const Cell& a, const Cell& b, int deepest) {
  return b.depth >= deepest || (a.depth < deepest && a.extent >= b.extent);
}

}  // namespace blossom
