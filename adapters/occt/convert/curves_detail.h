// SPDX-License-Identifier: LGPL-2.1-or-later
// What curves and surfaces share on their way to Bezier form: knots, homogeneous points, and the
// check of numbers. For this folder only.

#pragma once

#include <limits>
#include <string>
#include <vector>

#include <Geom_Curve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <gp_Pnt.hxx>
#include <gp_XYZ.hxx>

#include "adapters/occt/base/points.h"
#include "core/forms/spans/flat_knots.h"
#include "core/forms/spans/homogeneous.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// (wx, wy, wz, w). A product is chosen that divides back to x bit for bit wherever one exists:
/// always for powers of two; else x may come back off by one unit in the last place.
Vec4 homogeneous(const gp_Pnt& point, double weight);

/// The point that a homogeneous point stands for; the bits are kept when the weight is 1.
gp_Pnt euclidean(const Vec4& point);

FlatKnots flat_knots(int degree, const TColStd_Array1OfReal& knots,
                     const TColStd_Array1OfInteger& multiplicities, bool periodic);

/// throws   BadModel if the range lies outside of the knots
std::vector<FlatKnots::Span> spans_in(const FlatKnots& knots, const Interval& range);

TColStd_Array1OfReal knot_array(const std::vector<double>& knots);

/// A range inside `natural`; overshoot by rounding is cut off.
/// what      "the box in u" and the like, for messages
/// throws    BadModel if the range is not finite, empty or leaves `natural`
Interval checked_range(const Interval& range, const Interval& natural, const std::string& what);

/// throws   BadModel if a control point or knot is not finite or a weight is not positive
void check_numbers(const Geom_Curve& curve);

/// Numbers from here on are infinite to Open CASCADE (Precision::Infinite, 2e100), whose
/// projections crash on places so far away; model units.
inline constexpr double kFarthestPlace = 1e99;

/// Whether all coordinates are numbers, and not endless.
bool is_bounded(const gp_XYZ& point);

/// throws   BadModel naming `what` unless the point is bounded
void check_bounded(const gp_XYZ& point, const std::string& what);

/// Whether all coordinates are numbers.
bool is_finite(const gp_XYZ& point);

/// throws   BadModel naming `what` unless all coordinates are finite
void check_finite(const gp_XYZ& point, const std::string& what);
void check_weight(double weight, const std::string& what);

/// The weights of one curve or surface.
class WeightRange {
 public:
  void add(double weight);

  /// throws   BadModel if the lightest point is lost in the roundings of the heaviest: what lies
  ///          between them then is no place that double precision can tell
  void check() const;

 private:
  double least_ = std::numeric_limits<double>::infinity();
  double most_ = 0;
};

}  // namespace blossom::occt
