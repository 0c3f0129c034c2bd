// SPDX-License-Identifier: LGPL-2.1-or-later
// What a cell holds in which the gap has a slope of one sign.
//
// Let z be that direction and w the other one. On each line w = const the gap has at most one
// zero, so the zeros are graphs over w that run from border to border. Sorted by w the roots on
// the border pair up, in and out. Unlike the four-variable certificate of a pair of cells this
// does not need surfaces that turn less than they are apart.
//
// Source: `core/surfaces/README.md`, "Contacts".

#pragma once

#include <optional>

#include "core/surfaces/gap/cells/valley.h"

namespace blossom {

/// A direction in a cell's x, y and a lower bound of the gap's slope along it over the cell.
struct GapSlope {
  Vec2 direction;  ///< unit
  double least = 0;
};

/// Reads a cell of surface a by its gap model.
///
/// slope     positive
/// returns   branches only; nothing if a root on the border stays undecided, or a branch turns far
std::optional<ValleyCell> regular_cell(const RationalBezierPatch& patch_a, const Cell& a,
                                       const RationalBezierPatch& patch_b, const GapModel& model,
                                       const GapSlope& slope);

}  // namespace blossom
