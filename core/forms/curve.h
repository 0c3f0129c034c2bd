// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomial and rational curves of one span, in Bezier and in monomial form.
//
// A rational curve is its homogeneous form: points (wx, wy, wz, w).

#pragma once

#include <vector>

#include "core/math/vec.h"

namespace blossom {

/// Highest degree per direction. The binomials up to here are exact in double, and
/// it is the highest that Open CASCADE accepts (Geom_BezierSurface::MaxDegree).
inline constexpr int kMaxDegree = 25;

/// C(t) = sum_i points[i] B_i^n(t), t in [0, 1]; n + 1 points.
template <class Point>
struct BezierCurveOf {
  std::vector<Point> points;

  int degree() const { return static_cast<int>(points.size()) - 1; }
  friend bool operator==(const BezierCurveOf&, const BezierCurveOf&) = default;
};

/// C(t) = sum_i coefficients[i] ((t - centre) / scale)^i; n + 1 coefficients.
///
/// centre 0 and scale 1 give the plain power basis. A curve that is re-centred keeps the
/// relative accuracy of its local shape (see `core/forms/algebra/conversion.h`).
template <class Point>
struct MonomialCurveOf {
  std::vector<Point> coefficients;
  double centre = 0;
  double scale = 1;

  int degree() const { return static_cast<int>(coefficients.size()) - 1; }
  friend bool operator==(const MonomialCurveOf&, const MonomialCurveOf&) = default;
};

using BezierCurve = BezierCurveOf<Vec3>;
using BezierCurve2 = BezierCurveOf<Vec2>;
using RationalBezierCurve = BezierCurveOf<Vec4>;
using MonomialCurve = MonomialCurveOf<Vec3>;
using RationalMonomialCurve = MonomialCurveOf<Vec4>;

}  // namespace blossom
