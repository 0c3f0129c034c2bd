// SPDX-License-Identifier: LGPL-2.1-or-later
// B-splines, also periodic and rational ones, as Bezier spans and patches.

#pragma once

#include <span>
#include <vector>

#include "core/forms/curve_spans.h"
#include "core/forms/surface.h"
#include "core/math/grid.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

/// One direction of a B-spline: basis function i lives between knots i and i + degree + 1.
/// Periodic ones go on without end in both directions.
class FlatKnots {
 public:
  /// One span between neighbouring different knots, cut by the range asked for.
  struct Span {
    int index;       ///< knot(index) < knot(index + 1) are the ends of the uncut span
    Interval place;  ///< the span cut by the range
  };

  /// knots            strictly increasing
  /// multiplicities   one for each knot
  FlatKnots(int degree, std::span<const double> knots, std::span<const int> multiplicities,
            bool periodic);
  /// Of a Bezier curve: 0 and 1 only.
  explicit FlatKnots(int degree);

  int degree() const { return degree_; }
  double knot(int i) const;
  /// Where basis function i finds its control point, 0-based.
  int pole(int i) const;
  /// Spans that make up the range; slivers at its ends that rounding made are left out. None if the
  /// range lies outside of the knots.
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

/// A curve with homogeneous control points on spans of its knots, at least one.
CurveSpans spline_spans(const FlatKnots& knots, const std::vector<FlatKnots::Span>& spans,
                        const std::vector<Vec4>& poles);

/// A surface with a net of homogeneous control points, likewise. What `rational` and `closed_u`,
/// `closed_v` say is left to the caller.
BezierSurface spline_patches(const FlatKnots& u, const std::vector<FlatKnots::Span>& u_spans,
                             const FlatKnots& v, const std::vector<FlatKnots::Span>& v_spans,
                             const Grid<Vec4>& net);

}  // namespace blossom
