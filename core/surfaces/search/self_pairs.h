// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a surface may meet itself: pairs of its cells that do not touch in the parameters.
//
// Every cell with itself, and every two cells that touch, have the trivial solutions in common.
// They are halved until their derivatives' directions prove that they have nothing else in common
// (`direction_cones.h`). What this leaves are pairs of cells apart from each other, which are
// searched like those of two surfaces, and cells at singular points, where no proof exists.
//
// Borders glued together (a seam, a pole) count as one: cells touch across them.

#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/surfaces/search/pair_search.h"

namespace blossom {

struct SelfPairs {
  std::vector<StartPair> apart;        ///< to be searched
  std::vector<CriticalPair> singular;  ///< both ways round; proof failed down to the tolerance
  long excluded = 0;                   ///< cells and pairs proven to have nothing in common
  int depth = 0;                       ///< deepest bisection of a patch
  bool stopped = false, cancelled = false;
  /// What was proven with control points moved into a plane, by so much: see `FlatBorder`.
  std::optional<double> moved_into_plane{};
  std::vector<std::string> reasons{};  ///< why something is singular or left out
};

/// Borders of a surface that are glued together.
struct GluedBorders {
  bool seam_u = false, seam_v = false;         ///< the first border is the last one
  std::array<std::optional<Vec3>, 4> poles{};  ///< by PoleSide: the point that a border is
};

/// The glued borders: those that the surface says are closed, and all whose points agree within
/// 1e-12 of its size.
GluedBorders glued_borders(const BezierSurface& surface);

/// origin    of the cells
SelfPairs self_pairs(SurfaceCells& cells, const GluedBorders& glued, const Vec3& origin,
                     const IntersectionOptions& options);

}  // namespace blossom
