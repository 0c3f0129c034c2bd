// SPDX-License-Identifier: LGPL-2.1-or-later
// Where borders cross lines between patches, and which they run along.

#pragma once

#include <cstddef>
#include <vector>

#include "core/forms/surface.h"
#include "core/regions/trimmed_chart.h"

namespace blossom {

/// Adds where a coordinate of the curve takes a value, and then the ends of stretches along which
/// it keeps it; returns the number of the first.
///
/// unit         the curve with ranges of length 1, and the value there: one tolerance, kOnLine,
///              serves both directions
std::size_t add_crossings(const PlanarCurve& curve, const PlanarCurve& unit, int direction,
                          double value, double unit_value, std::vector<double>& at);

/// A line between patches along which a border runs.
struct LineRun {
  int direction = -1;  ///< of which the line is a value; -1: there is none
  double line = 0;     ///< grid coordinate

  friend bool operator==(const LineRun&, const LineRun&) = default;
};

/// The line between two patches that a piece of a border leaves by no more than a distance, in
/// space and at samples, and by much less than the piece is long: near a pole ways in the chart are
/// long that are none in space.
///
/// curve     in the surface's own parameters
/// place     of its parameters, between neighbouring patches
/// within    model units
LineRun line_run(const BezierSurface& surface, const PlanarCurve& curve, const Interval& place,
                 double within);

}  // namespace blossom
