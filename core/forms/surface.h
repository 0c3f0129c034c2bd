// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface as a grid of Bezier patches with their place in its own parameters.
//
// This is what the engines take: every B-spline, Bezier, elementary, swept and revolved
// surface comes in this form, exactly; others within a stated error.

#pragma once

#include <array>
#include <vector>

#include "core/forms/patch.h"
#include "core/math/interval.h"

namespace blossom {

/// How the local parameter t in [0, 1] of a span [k0, k1] maps to the surface's own parameter.
enum class ParameterLaw {
  /// k0 + t (k1 - k0): polynomials, B-splines, lines.
  Linear,
  /// The angle of a circular arc in rational quadratic form with end weights 1 and middle
  /// weight cos(alpha), alpha = (k1 - k0) / 2 < pi / 2:
  ///   angle(t) = (k0 + k1) / 2 + 2 atan(tan(alpha / 2) (2t - 1))
  Angle,
  /// Likewise of an arc of a hyperbola, with the weight cosh(alpha); of curves in space alone:
  ///   parameter(t) = (k0 + k1) / 2 + 2 atanh(tanh(alpha / 2) (2t - 1))
  Hyperbolic,
};

struct BezierSurface {
  std::vector<double> u_knots;  ///< strictly increasing; spans + 1 of them
  std::vector<double> v_knots;
  ParameterLaw u_law = ParameterLaw::Linear;
  ParameterLaw v_law = ParameterLaw::Linear;

  /// (u spans) x (v spans) patches; neighbours meet along their borders. Weights are positive.
  Grid<RationalBezierPatch> patches{};

  /// True when some weight differs from 1.
  bool rational = false;

  /// The surface runs into itself: the last span continues in the first one.
  bool closed_u = false;
  bool closed_v = false;

  /// Bound on the distance to the surface it stands for, model units; 0 when exact.
  double error = 0;
};

/// The surface's own parameter at local parameter `t` of a span.
double parameter_at(ParameterLaw law, const Interval& span, double t);

/// First and second derivative of `parameter_at` by t.
double parameter_derivative(ParameterLaw law, const Interval& span, double t);
double parameter_second_derivative(ParameterLaw law, const Interval& span, double t);

/// The local parameter of a span that has the given parameter; inverse of `parameter_at`.
double local_parameter(ParameterLaw law, const Interval& span, double parameter);

/// The point of the surface at its own parameters, clamped to the knots' range. Model units.
Vec3 point_at(const BezierSurface& surface, const Vec2& uv);

/// S_u x S_v up to positive factors, likewise, at four places beside the point: 1e-6 of a span away
/// in both directions, on either side of knot lines that it is on.
std::array<Vec3, 4> one_sided_normals(const BezierSurface& surface, const Vec2& uv);

/// Throws InvalidInput, naming `name`, unless the surface is well formed: sizes agree, knots
/// increase, degrees are in 1..kMaxDegree, all numbers are finite and all weights positive.
void validate(const BezierSurface& surface, const char* name);

/// The same but for the patches, of which there has to be one; and what it asks of each of them.
void validate_frame(const BezierSurface& surface, const char* name);
bool is_valid(const RationalBezierPatch& patch);

}  // namespace blossom
