// SPDX-License-Identifier: LGPL-2.1-or-later
// The gap over a cell in which it is strictly convex in one direction.
//
// The axes are turned so that z runs across the valley, where the gap bends most, and w along it.
// On each line w = const the gap has one least value m(w).

#pragma once

#include <array>
#include <optional>

#include "core/intersection/cells/turned_axes.h"
#include "core/intersection/gap/gap_model.h"
#include "core/math/polynomial.h"
#include "core/math/taylor_curve.h"

namespace blossom {

/// Bounds over a piece of valley, model units; the slope by w.
struct ValleyBounds {
  double low, high;              ///< of m
  double slope_low, slope_high;  ///< of m'
};

struct ValleyShape : TurnedAxes {
  double bend_low = 0, bend_high = 0;  ///< of the second derivative by z; bend_low > 0
  double twist = 0;                    ///< bound on the mixed derivative
  std::array<double, 3> error{};       ///< of the gap and its first, second derivatives
  TaylorPolynomial gap{}, gap_w{}, gap_z{}, gap_zz{};  ///< of w, z; turned over if it was concave

  /// Nothing if no direction is proven convex.
  static std::optional<ValleyShape> of(const GapModel& model);

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

 private:
  std::optional<TaylorCurve> cubic_over(double from, double to) const;
  double rest_along(const TaylorCurve& cubic) const;
};

}  // namespace blossom
