// SPDX-License-Identifier: LGPL-2.1-or-later
// Values and derivatives of a curve or patch at a point, without allocation.
//
// Bernstein polynomials are positive on [0, 1], so the sums below lose no digits there.

#pragma once

#include "core/forms/curve.h"
#include "core/forms/patch.h"
#include "core/math/roundoff.h"

namespace blossom {

/// Point and partial derivatives by the patch's local parameters, model units.
struct PatchJet {
  Vec3 point;
  Vec3 u, v;
  Vec3 uu, uv, vv;  ///< zero when only first derivatives were asked for
};

/// The point of a rational patch at (u, v); any real parameters. Cost: O((n + 1)(m + 1)).
Vec3 point_at(const RationalBezierPatch& patch, double u, double v);

/// The jet of a rational patch at (u, v); `order` is 1 or 2. Any real parameters.
/// Cost: O((n + 1)(m + 1)).
PatchJet jet_at(const RationalBezierPatch& patch, double u, double v, int order);

/// Point and derivatives by the curve's local parameter, model units.
struct CurveJet {
  Vec3 point;
  Vec3 first;
  Vec3 second;
};

/// The jet of a rational curve at t in [0, 1], or a little outside.
///
/// accuracy  a coordinate of the point: evaluation_error(n), relative to the largest coordinate of
///           a control point in space
/// cost      O(n^2)
CurveJet jet_at(const RationalBezierCurve& curve, double t);

/// n levels with three roundings each, weights likewise, and the quotient.
constexpr double evaluation_error(int degree) { return (6.0 * degree + 4.0) * kUnitRoundoff; }

}  // namespace blossom
