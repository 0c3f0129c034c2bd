// SPDX-License-Identifier: LGPL-2.1-or-later
// Control points by Theorems 1, 2 and 3, compositions, normals and signs in CGAL's exact rationals,
// and the doubles' distance from them: a check that shares neither rounding nor number type with
// the core.

#pragma once

#include "core/blossom/composition.h"
#include "core/blossom/curve_blossom.h"
#include "core/blossom/normal_net.h"
#include "core/blossom/patch_blossom.h"
#include "core/blossom/triangle_blossom.h"
#include "core/forms/algebra/sign.h"

namespace blossom::cgal {

/// How far the core's control points are from the exact ones. Model units.
struct ExactCheck {
  double largest_error = 0;  ///< over all points and coordinates, the difference taken exactly
  double bound = 0;          ///< what the core states for this input

  bool within() const { return largest_error <= bound; }
};

/// The exact control points, rounded to double once (to at most one unit in the last place).
/// Arguments, results and errors are those of the core's bezier_points.
BezierCurve exact_bezier_points(const MonomialCurve& curve, const Interval& interval);
BezierPatch exact_bezier_points(const MonomialPatch& patch, const Interval& u, const Interval& v);
BezierTriangle exact_bezier_points(const MonomialPatch& patch, const TriangleCorners& corners,
                                   int degree);

/// Compares the core's bezier_points in double with the exact ones.
ExactCheck check_bezier_points(const MonomialCurve& curve, const Interval& interval);
ExactCheck check_bezier_points(const MonomialPatch& patch, const Interval& u, const Interval& v);
ExactCheck check_bezier_points(const MonomialPatch& patch, const TriangleCorners& corners,
                               int degree);

/// Compares the core's composition and normal net in double with the exact ones.
ExactCheck check_composition(const RationalBezierPatch& patch, const BezierCurve2& curve);
ExactCheck check_normal_net(const BezierPatch& patch);
ExactCheck check_normal_net(const RationalBezierPatch& patch);

/// The sign of a form at a parameter by its exact value alone. Arguments and errors are those of
/// the core's sign_at.
int exact_sign_at(const BezierFunction& f, const Ratio& t);
int exact_sign_at(const BezierFunction2& f, const Ratio& u, const Ratio& v);

/// "CGAL 5.5.1, <exact number type>".
const char* version();

}  // namespace blossom::cgal
