// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of curves, and curves with surfaces, whose number of common points and runs is known
// exactly: by Sturm's chain over rationals, or by construction.

#pragma once

#include <string>
#include <vector>

#include "core/forms/curve.h"
#include "core/math/grid.h"
#include "core/math/vec.h"

namespace blossom::bench {

struct CurveCase {
  BezierCurve a, b;    ///< b unless there is a surface; of planar families z = 0
  Grid<Vec3> surface;  ///< Bezier points, or none
  int truth = 0;       ///< common points; a touch is one
  int runs = 0;        ///< common parts of both curves
};

struct CurveFamily {
  std::string name;
  bool with_surface = false;
  std::vector<CurveCase> cases;
};

/// All families, the same in every run, with `cases` cases each.
std::vector<CurveFamily> curve_families(int cases);

/// Those whose curves touch, have a part in common, or have a cusp.
std::vector<CurveFamily> contact_families(int cases);

/// A graph of y over x in [0, 1] by its Bernstein coefficients.
BezierCurve graph(const std::vector<double>& y);

}  // namespace blossom::bench
