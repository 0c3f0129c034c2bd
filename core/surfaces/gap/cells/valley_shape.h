// SPDX-License-Identifier: LGPL-2.1-or-later
// The gap over a cell in which it is strictly convex in one direction.
//
// The axes are turned so that z runs across the valley, where the gap bends most, and w along it.
// On each line w = const the gap has one least value m(w).

#pragma once

#include <array>
#include <optional>

#include "core/math/functions/polynomial.h"
#include "core/math/series/taylor_curve.h"
#include "core/surfaces/gap/gap_model.h"
#include "core/surfaces/gap/turned_axes.h"

namespace blossom {

/// Bounds over a piece of valley, model units; the slope by w.
struct ValleyBounds {
  double low, high;              ///< of m
  double slope_low, slope_high;  ///< of m'
};

/// The gap and its slope by w along a curve close to the valley, from one w to another.
struct ValleyStretch {
  double from, to;
  AlongCurve gap, slope;
  double rest;  ///< largest derivative across the valley, along the curve

  /// At `cut` between its ends.
  std::array<ValleyStretch, 2> parts(double cut) const;
};

struct ValleyShape : TurnedAxes {
  double bend_low = 0, bend_high = 0;  ///< of the second derivative by z; bend_low > 0
  double twist = 0;                    ///< bound on the mixed derivative
  std::array<double, 3> error{};       ///< of the gap and its first, second derivatives
  TaylorPolynomial gap{}, gap_w{}, gap_z{}, gap_zz{};  ///< of w, z; turned over if it was concave

  /// Nothing if no direction is proven convex.
  static std::optional<ValleyShape> of(const GapModel& model);

  /// z of the valley at w; nothing if it leaves the range of the cell.
  ///
  /// near   where it may be, for speed
  std::optional<double> valley_at(double w, double near = 0) const;

  /// Nothing if the valley leaves the range of the cell.
  std::optional<ValleyStretch> stretch(double from, double to) const;

  ValleyBounds bounds_on(const ValleyStretch& stretch) const;

  /// True if the curve of a stretch is the reason why its bounds are wide: a curve of their own
  /// serves its parts better.
  bool is_coarse(const ValleyStretch& stretch) const;

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
  std::array<double, 2> off_valley(const ValleyStretch& stretch) const;
};

}  // namespace blossom
