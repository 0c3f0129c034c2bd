// SPDX-License-Identifier: LGPL-2.1-or-later
// Two Bezier curves that are parts of one curve, proven by an identity of polynomials.
//
// Pieces of one curve, also elevated, reversed or re-parametrised by a linear rational function,
// satisfy A(s) = B(map(s)). Value and two derivatives at one common point give the map; with it
// both sides of  w_B X_A = w_A X_B  are polynomials, so the largest coefficient of their difference
// bounds the distance.

#pragma once

#include <optional>

#include "core/forms/curve.h"
#include "core/math/interval.h"
#include "core/surfaces/pairs/shared_chart.h"

namespace blossom {

/// Where curve a lies on curve b.
struct SharedCurve {
  LinearRational map;  ///< from the common part of a to that of b; its `from` is the common part
  double gap = 0;      ///< bound on the distance along it, model units
};

/// The common part of two curves that meet at A(s) and B(t).
///
/// tolerance    the distance that is proven over the whole common part, model units
/// returns      nothing if the curves are not parts of one, or share less than a thousandth of a
///
/// Source: Farouki and Rajan 1988, for the products.
std::optional<SharedCurve> shared_curve(const RationalBezierCurve& a, const RationalBezierCurve& b,
                                        double s, double t, double tolerance);

/// Bound on the distance of two curves at equal parameters, model units.
///
/// error   of a control point of either, relative to the largest one
double distance_bound(const RationalBezierCurve& a, const RationalBezierCurve& b, double error);

/// The same of A(s) and B(map(s)) where the map is defined.
double distance_bound(const RationalBezierCurve& a, const RationalBezierCurve& b,
                      const LinearRational& map);

}  // namespace blossom
