// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomial and rational tensor-product patches of one span.
//
// Rows of a net run along u, columns along v: points(i, j) belongs to B_i(u) B_j(v).
// A rational patch is its homogeneous form: points (wx, wy, wz, w).

#pragma once

#include "core/forms/curve.h"
#include "core/math/grid.h"
#include "core/math/vec.h"

namespace blossom {

/// S(u, v) = sum_ij points(i, j) B_i^n(u) B_j^m(v), (u, v) in [0, 1]^2; (n + 1) x (m + 1) points.
template <class Point>
struct BezierPatchOf {
  Grid<Point> points;

  int degree_u() const { return points.rows() - 1; }
  int degree_v() const { return points.columns() - 1; }
  friend bool operator==(const BezierPatchOf&, const BezierPatchOf&) = default;
};

/// S(u, v) = sum_ij coefficients(i, j) ((u - centre_u) / scale_u)^i ((v - centre_v) / scale_v)^j.
template <class Point>
struct MonomialPatchOf {
  Grid<Point> coefficients;
  double centre_u = 0;
  double centre_v = 0;
  double scale_u = 1;
  double scale_v = 1;

  int degree_u() const { return coefficients.rows() - 1; }
  int degree_v() const { return coefficients.columns() - 1; }
  friend bool operator==(const MonomialPatchOf&, const MonomialPatchOf&) = default;
};

using BezierPatch = BezierPatchOf<Vec3>;
using RationalBezierPatch = BezierPatchOf<Vec4>;
using MonomialPatch = MonomialPatchOf<Vec3>;
using RationalMonomialPatch = MonomialPatchOf<Vec4>;

}  // namespace blossom
