// SPDX-License-Identifier: LGPL-2.1-or-later
// Axes w, z over a cell, turned against its own x, y in [-1, 1].

#pragma once

#include "core/math/functions/polynomial.h"
#include "core/math/series/taylor_series.h"
#include "core/math/vec.h"

namespace blossom {

struct TurnedAxes {
  Vec2 w_axis, z_axis;  ///< unit, in the cell's x, y
  double reach = 0;     ///< |w|, |z| in the cell are at most this

  TurnedAxes() = default;

  /// z along a direction in x, y, not zero.
  explicit TurnedAxes(const Vec2& direction);

  /// A function of x, y as one of w, z.
  TaylorPolynomial turned(const TaylorPolynomial& p) const;

  /// Place of parameter t in [-1, 1] of an edge: 0, 1 are x = -1, 1; 2, 3 are y = -1, 1.
  Vec2 on_edge(int edge, double t) const;

  /// A function of w, z along an edge.
  Polynomial along_edge(const TaylorPolynomial& p, int edge) const;

  /// z at the end of the line w = const in the cell, and a little beyond: the lower end for side
  /// 0, the upper one for side 1.
  double chord_end(double w, int side) const;
};

}  // namespace blossom
