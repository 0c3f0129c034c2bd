// SPDX-License-Identifier: LGPL-2.1-or-later
// The trims of a face as the core takes them, and one system of coordinates for all its patches.
//
// Grid coordinates: patch (i, j) covers [i, i + 1] x [j, j + 1], with its own parameters on top. In
// them lines between patches are whole numbers, however the surface's parameters run.

#pragma once

#include <vector>

#include "core/forms/surface.h"
#include "core/plane/planar_curves.h"
#include "core/regions/limits.h"

namespace blossom {

/// One curve of a trimming loop; the region lies on the left of its walk.
struct RegionBorder {
  PlanarCurve curve;      ///< in the surface's own parameters
  bool reversed = false;  ///< walked from the last of its parameters to the first
  int from = 0;           ///< corners where the walk starts and ends
  int to = 0;
  std::vector<double> stops;  ///< parameters where it has to be divided, in any order
  bool is_point = false;      ///< in space, as at the pole of a sphere
  double tolerance = 0;       ///< of its arcs, where it is above the region's; model units
};

struct TrimmedChart {
  std::vector<RegionBorder> borders;  ///< of all loops, in any order
  std::vector<Vec2> corners;          ///< in the surface's own parameters
};

/// A parameter of the surface as a grid coordinate; exactly a whole number within kOnLine of one.
double grid_coordinate(const std::vector<double>& knots, ParameterLaw law, double parameter);

/// The same without that: a whole number on a line alone.
double unrounded_grid_coordinate(const std::vector<double>& knots, ParameterLaw law,
                                 double parameter);

Vec2 grid_point(const BezierSurface& surface, const Vec2& uv);
Vec2 unrounded_grid_point(const BezierSurface& surface, const Vec2& uv);

}  // namespace blossom
