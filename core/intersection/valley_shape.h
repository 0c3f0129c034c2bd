// SPDX-License-Identifier: LGPL-2.1-or-later
// The gap over a cell in which it is strictly convex in one direction.
//
// The axes are turned so that z runs across the valley, where the gap bends most, and w along it.
// On each line w = const the gap has one least value m(w).

#pragma once

#include <array>
#include <optional>

#include "core/intersection/gap_model.h"
#include "core/math/polynomial.h"
#include "core/math/vec.h"

namespace blossom {

/// Bounds over a piece of valley, model units; the slope by w.
struct ValleyBounds {
  double low, high;              ///< of m
  double slope_low, slope_high;  ///< of m'
};

struct ValleyShape {
  Vec2 w_axis, z_axis;                 ///< unit, in the cell's x, y in [-1, 1]
  double reach = 0;                    ///< |w|, |z| in the cell are at most this
  double bend_low = 0, bend_high = 0;  ///< of the second derivative by z; bend_low > 0
  double twist = 0;                    ///< bound on the mixed derivative
  std::array<double, 3> error{};       ///< of the gap and its first, second derivatives
  TaylorPolynomial gap{}, gap_w{}, gap_z{}, gap_zz{};  ///< of w, z; turned over if it was concave

  /// Nothing if no direction is proven convex.
  static std::optional<ValleyShape> of(const GapModel& model);

  /// Place of parameter t in [-1, 1] of an edge: 0, 1 are x = -1, 1; 2, 3 are y = -1, 1.
  Vec2 on_edge(int edge, double t) const;

  /// A function of w, z along an edge.
  Polynomial along_edge(const TaylorPolynomial& p, int edge) const;

  /// z of the valley at w; nothing if it leaves the range of the cell.
  std::optional<double> valley_at(double w) const;

  std::optional<ValleyBounds> bounds_on(double from, double to) const;

  /// Range of a function of w, z along a curve close to the valley, and how far z of that curve is
  /// at most from the valley; nothing if the valley leaves the range of the cell.
  struct Along {
    PolynomialRange range;
    double off;
  };
  std::optional<Along> along(const TaylorPolynomial& f, double from, double to) const;

  /// z at the end of the line w = const in the cell, and a little beyond: the lower end for side
  /// 0, the upper one for side 1.
  double chord_end(double w, int side) const;

 private:
  std::optional<Polynomial> cubic_over(double from, double to) const;
};

}  // namespace blossom
