// SPDX-License-Identifier: LGPL-2.1-or-later
// The image of a chart curve on a rational patch as a truncated power series.
//
// Taylor's polynomial of the patch round the middle of the curve is composed with the curve's own
// powers. On short pieces both fall off fast: far fewer terms count than the product of the degrees
// would give, and sums of absolute values bound the rest.

#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/forms/patch.h"
#include "core/math/roundoff.h"
#include "core/math/series/power_series.h"

namespace blossom {

/// Highest degree of a chart curve.
inline constexpr int kSeriesChartDegree = 8;

/// Short pieces need no more terms than up to here.
inline constexpr std::size_t kShortSeriesDegree = 10;

/// A form over t in [0, 1] by powers of x = 2 t - 1. Of degree 1..kSeriesChartDegree.
///
/// accuracy   power_rounding(degree), relative to the largest distance of a point from the first
///            one, and a rounding of that one
PowerSeries<double> power_series(std::span<const double> points);
PowerSeries<Vec3> power_series(std::span<const Vec3> points);

constexpr double power_rounding(int degree) {
  return (degree + 4.0) * (1 << degree) * kUnitRoundoff;
}

/// A Bezier form over t in [0, 1] of at most kSeriesDegree, without memory of its own.
struct SeriesForm {
  std::array<Vec3, kSeriesDegree + 1> values;
  std::size_t count = 0;

  std::span<Vec3> points() { return {values.data(), count}; }
  std::span<const Vec3> points() const { return {values.data(), count}; }
};

/// The terms up to a degree, which is kSeriesDegree or kShortSeriesDegree.
SeriesForm bezier_form(const PowerSeries<Vec3>& series, std::size_t degree = kSeriesDegree);

/// The homogeneous image (X - w origin, w) of a chart curve.
struct ImageSeries {
  PowerSeries<Vec4> image;
  Vec4 slope_u, slope_v;  ///< bounds on its derivatives by u and v, for each coordinate
  Vec4 rounding;          ///< bounds on what rounding adds to each coordinate, all terms together
  Vec4 size;  ///< sums of the control points' absolute coordinates, by what they count for there
};

/// S(u(x), v(x)); where the curve is long the rest is large.
///
/// patch       weights positive
/// u, v        without rests; their terms above kSeriesChartDegree zero; u(0) and v(0) at most 1e-3
///             outside of [0, 1]
/// negligible  terms of Taylor's polynomial that sum up to no more, in model units, may be left out
/// degree      of what is kept of the image: kSeriesDegree or kShortSeriesDegree
///
/// Source: Makino and Berz 2003, Taylor models, with one variable and sums of absolute values in
/// place of intervals.
ImageSeries image_series(const RationalBezierPatch& patch, const Vec3& origin,
                         const PowerSeries<double>& u, const PowerSeries<double>& v,
                         double negligible, std::size_t degree = kSeriesDegree);

}  // namespace blossom
