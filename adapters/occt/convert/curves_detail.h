// SPDX-License-Identifier: LGPL-2.1-or-later
// What curves and surfaces share on their way to Bezier form: flat knots and their spans, arcs of
// circles, homogeneous points, and the check of numbers. For this folder only.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Geom_Curve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <gp_Pnt.hxx>
#include <gp_XYZ.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/arc_cuts.h"
#include "core/forms/curve.h"
#include "core/math/grid.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

inline Vec3 head(const Vec4& p) { return {p[0], p[1], p[2]}; }
inline Vec4 with_weight(const Vec3& p, double w) { return {p[0], p[1], p[2], w}; }

/// (wx, wy, wz, w). A product is chosen that divides back to x bit for bit wherever one exists:
/// always for powers of two; else x may come back off by one unit in the last place.
Vec4 homogeneous(const gp_Pnt& point, double weight);

/// The point that a homogeneous point stands for; the bits are kept when the weight is 1.
gp_Pnt euclidean(const Vec4& point);

/// One direction of a B-spline: basis function i lives between knots i and i + degree + 1.
/// Periodic ones go on without end in both directions.
class FlatKnots {
 public:
  /// One span between neighbouring different knots, cut by the range asked for.
  struct Span {
    int index;       ///< knot(index) < knot(index + 1) are the ends of the uncut span
    Interval place;  ///< the span cut by the range
  };

  FlatKnots(int degree, const TColStd_Array1OfReal& knots,
            const TColStd_Array1OfInteger& multiplicities, bool periodic);
  /// Of a Bezier curve: 0 and 1 only.
  explicit FlatKnots(int degree);

  int degree() const { return degree_; }
  double knot(int i) const;
  /// Where basis function i finds its control point, 0-based.
  int pole(int i) const;
  /// Spans that make up the range; slivers at its ends that rounding made are left out.
  std::vector<Span> spans(const Interval& range) const;

 private:
  int degree_;
  std::vector<double> knots_;
  double period_ = 0;  ///< 0 when not periodic
};

/// The Bezier points of one span from the degree + 1 control points of that span.
///
///   point k = the blossom at degree - k copies of place.from and k copies of place.to
///
/// Convex combinations only; ends that are knots of full multiplicity keep the points' bits, and
/// neighbouring spans share their common point bit for bit. The factors are made once for any
/// number of control polygons. Source: de Boor's algorithm with different arguments (Ramshaw 1989).
class SpanForm {
 public:
  SpanForm(const FlatKnots& knots, const FlatKnots::Span& span);

  /// poles, points   degree + 1 each; not the same ones
  void bezier_points(const Vec4* poles, Vec4* points) const;

 private:
  int degree_;
  std::vector<double> alphas_;  // by point, step and place, in the order of use; none: all 0 or 1
};

/// Bezier points of w(t) (cos, sin, 1) over one span of an arc of the unit circle.
struct ArcSpan {
  Interval place;  ///< radians, less than half a turn
  double cosine[3];
  double sine[3];
  double weight[3];
};

/// The arc in as many spans as are at most quarters of a turn, if they are equal; a whole turn ends
/// in the bits it began with.
std::vector<ArcSpan> arc_spans(const Interval& angles, ArcCuts cuts = ArcCuts::Even);

/// A curve's span fitted by interpolation in Chebyshev-Lobatto nodes, ends included.
inline constexpr int kFitDegree = 5;

/// Local parameters of the nodes in [0, 1].
const std::vector<double>& fit_nodes();

/// Takes values in the nodes to Bezier points; (kFitDegree + 1) x (kFitDegree + 1). The first and
/// the last row are exact.
const Grid<double>& fit_matrix();

/// What sampled errors are multiplied with, since samples may miss the largest one.
inline constexpr double kErrorSafety = 2.0;

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

/// throws   BadModel naming `what` unless all coordinates are finite
void check_finite(const gp_XYZ& point, const std::string& what);
void check_weight(double weight, const std::string& what);

}  // namespace blossom::occt
