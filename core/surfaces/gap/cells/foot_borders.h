// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the foot points of a cell lie, and how its branches cross the border of b's patch.

#pragma once

#include <optional>

#include "core/surfaces/gap/cells/regular_cell.h"
#include "core/surfaces/gap/chart_ownership.h"

namespace blossom {

inline constexpr Box2 kWholePatch{Interval{0, 1}, Interval{0, 1}};

/// Holds all foot points of the cell, errors included.
Box2 foot_box(const GapModel& model);

/// True if it is proven that each branch in a regular cell crosses the border of b's patch at most
/// once, so that its ends tell where it lies: foot points reach over one side of the patch only,
/// and along the branches they move to that side or away from it.
///
///   with z the direction of the slope and w the other one, along the zeros of the gap
///   ds/dw gap_z = s_w gap_z - s_z gap_w
///
/// slope     positive
bool crosses_border_once(const GapModel& model, const GapSlope& slope);

/// The direction in which a cell that stays undecided is halved best. Nearly coincident surfaces
/// and those that touch along a curve want cells far longer than wide, nodes do not: so if the gap
/// has a clear slope and foot points lie on both sides of a border, the direction in which they
/// cross it; if the gap bends in one direction, that one.
///
/// tolerance  model units
/// returns    true for u; nothing if the cell ought to keep its shape, or the model is too rough to
///            tell
std::optional<bool> halving_of(const GapModel& model, double tolerance);

/// The same for a cell without a model: the direction in which it is wide to the chart. Nothing if
/// it is not.
std::optional<bool> halving_of(const Cell& a, const GraphChart& chart);

}  // namespace blossom
