// SPDX-License-Identifier: LGPL-2.1-or-later
// Borders that end at a pole, without the ways they make in the chart alone.

#pragma once

#include "core/forms/surface.h"
#include "core/regions/trimmed_chart.h"

namespace blossom {

/// The chart with borders that run straight into poles: a cut that passes a pole within tolerance,
/// or ends there in noise, sweeps over a part of the chart, and over lines between patches, that is
/// no longer in space than that. The last spans of such a border keep to the other parameter that
/// they begin with, and the border that is the pole ends there, too. Where two borders meet beside
/// a pole and no border is one, their corner becomes two, with a border between them along the
/// pole.
///
///   (1) no point of a border, and no corner, moves farther than `within` in space, at equal
///       parameters; borders that are points are the same point in space all along
///   (2) only corners with one such border and one other move, and none so far that the pole would
///       be turned about or much shorter in the chart; and those that become two
///   (3) given borders and corners keep their numbers: borders along poles are added at the end,
///       and of two corners the first is the given one, where the border before it ends
///
/// within    model units
TrimmedChart with_straight_pole_ends(const BezierSurface& surface, TrimmedChart chart,
                                     double within);

}  // namespace blossom
