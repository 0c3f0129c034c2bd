// SPDX-License-Identifier: LGPL-2.1-or-later
// Patches at which two surfaces go on smoothly into each other, across a border or a corner, or
// across a border that is a crease.
//
// Beside a border that both surfaces have, their cells come as close to each other as they like,
// and nearly flat: neither boxes nor normals tell them apart, on any scale. But what makes them
// neighbours proves that they have nothing else in common: from a point of one cell a path leads
// to the border, along it and on into the other cell, on which no parameter turns back, so the
// proof of `core/cells/direction_cones.h`, that a surface does not meet itself, holds for two.
// Through a corner such a path goes straight on, and some direction that grows along it is enough.
//
// Borders that are one point, as the apex of two half cones, are taken for exactly that point: the
// parts around it meet in the borders that end there, or, on either side of a plane through it, in
// it alone.
//
// Borders and corners are common when their control points are the same, or so near each other that
// paths which jump across prove it of all points farther than the tolerance from them. What differs
// at all may be as far as the rounding of its coordinates tells, 2^-49 of the largest one, and a
// path may jump by 1/2001 of the tolerance: so that holds up to coordinates of about 2.8e11
// tolerances, 28,000 at 1e-7. Poles, where both surfaces are moved to be one point, are found up to
// half of that. Beyond, pairs of neighbours are searched as all others.

#pragma once

#include <vector>

#include "core/base/work_limit.h"
#include "core/cells/surface_cells.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// What neighbours have in common.
struct NeighbourContacts {
  std::vector<FoundArc> arcs;                  ///< along borders; not tangential along creases
  bool touch = false;                          ///< some of them are tangential
  std::vector<CornerContact> corner_contacts;  ///< corners and poles
  double gap = 0;                              ///< between the surfaces there, model units
  Certificate certificate;  ///< of the pairs of cells that have nothing else in common
};

/// Takes out the pairs of patches that are proven to meet in a common outer border, corner or pole
/// of both surfaces alone, where samples have common normals, to 1e-3, or the border is exactly one
/// curve. What lies outside of the parts that count is not looked at and not reported.
///
/// pairs      of whole patches of two different surfaces
/// tolerance  model units: what they have in common lies within it of what is reported
/// limit      asked before each pair that may be taken; when it is reached no more are
/// cost       few pairs of cells where patches do not turn far; at most 1024 for each pair
NeighbourContacts take_neighbours(SurfaceCells& a, SurfaceCells& b, std::vector<StartPair>& pairs,
                                  double tolerance, const WorkLimit& limit);

/// Adds them to what the search over the other pairs found.
void add(const NeighbourContacts& neighbours, PairSearchResult& found);

}  // namespace blossom
