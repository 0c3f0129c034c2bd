// SPDX-License-Identifier: LGPL-2.1-or-later
// A piece of a trimming curve in the parameters of the Bezier patch under it.
//
// Exact where the patch's parameters are linear functions of the surface's; where one is an angle,
// or where the degree is too high, a polynomial within a stated bound.

#pragma once

#include "core/forms/surface.h"
#include "core/plane/planar_curves.h"
#include "core/regions/limits.h"

namespace blossom {

/// Where the parameters of a patch, [0, 1]^2, lie in those of the surface.
struct PatchChart {
  Interval u;
  Interval v;
  ParameterLaw u_law = ParameterLaw::Linear;
  ParameterLaw v_law = ParameterLaw::Linear;
};

PatchChart chart_of(const BezierSurface& surface, int patch_u, int patch_v);

struct ArcForm {
  PlanarBezier curve;  ///< homogeneous, weights 1 at both ends
  Vec2 error;          ///< bound on the distance in each parameter of the patch
  bool exact = true;   ///< the very curve, though perhaps run through in another way
};

struct ArcFormOptions {
  int highest_degree = kMaxDegree;  ///< at least 1
  /// Whether the form has to be a polynomial and run as evenly as the curve's own parameter;
  /// else a rational curve or a straight line may have a parameter of its own.
  bool keep_parameter = false;
  bool polynomial = false;  ///< whether it has to be a polynomial in any case
  /// A polynomial gets the lowest degree that is within this, in the patch's parameters. Below
  /// kArcRounding the form still counts as exact.
  double lower_within = 0;
};

/// The form of one piece. It is exact if its degree allows and either both laws are linear, the
/// piece runs along a line of the patch, or an angle does not change along it. Otherwise degree 5
/// or less.
///
/// curve        in the surface's parameters
/// place        within one span of the curve; from > to runs backwards
/// accuracy     the bound holds for everything but rounding: comparison of coefficients, the error
///              of interpolation for arcs of angles (Davis 1963), `local_form` and `reduced`
/// throws       InvalidInput if the highest degree is below 1
ArcForm arc_form(const PlanarCurve& curve, const Interval& place, const PatchChart& chart,
                 const ArcFormOptions& options);

/// Bounds on the lengths of the derivatives of a patch by its parameters, model units.
///
///   S_u = (X_u - S w_u) / w, with X as seen from the middle of the net
///
/// returns   infinity if a weight is not positive, as beyond the domain of a rational patch
Vec2 derivative_bounds(const RationalBezierPatch& patch);

/// The same over a box of the parameters, which may reach beyond the patch.
Vec2 derivative_bounds(const RationalBezierPatch& patch, PlanarBox box);

}  // namespace blossom
