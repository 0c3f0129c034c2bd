// SPDX-License-Identifier: LGPL-2.1-or-later
// Scalar functions in Bernstein form: curves and patches whose points are numbers.

#pragma once

#include "core/forms/curve.h"
#include "core/forms/patch.h"

namespace blossom {

/// Highest degree of a form that elevation, products and composition make: that of a bicubic patch
/// along a curve of degree 10. The binomials up to 67 fit 64 bits; beyond, pieces of lower degree
/// give closer hulls anyway.
inline constexpr int kMaxProductDegree = 60;

/// f(t) = sum_i points[i] B_i^n(t) on [0, 1].
using BezierFunction = BezierCurveOf<double>;
/// f(u, v) = sum_ij points(i, j) B_i^n(u) B_j^m(v) on the unit square.
using BezierFunction2 = BezierPatchOf<double>;

}  // namespace blossom
