// SPDX-License-Identifier: LGPL-2.1-or-later
// The square of the distance of a cell's points from a point or an axis, as a rational Bernstein
// form:
//
//   f = |P (X - w p)|^2 / w^2,   P = 1 for a point p, 1 - d d^T for an axis along d
//
// It lies between its coefficients, so it is known exactly where it is constant: of spheres about
// the point, of circles, cylinders and cones' circles about the axis.

#pragma once

#include <array>

#include "core/cells/cell_tree.h"
#include "core/distance/curvature_centre.h"

namespace blossom {

struct SquareForm {
  double nearest = 0;   ///< no point of the cell is nearer, model units, roundings included
  double farthest = 0;  ///< nor farther
  /// How much the coefficients bend in each direction, model units squared: what halving gains.
  double bend_u = 0, bend_v = 0;
  /// False if f is proven to be stationary nowhere in the cell: neither f_u, f_v nor what is left
  /// of one of them when the other one is taken off vanishes, in the directions asked for.
  bool may_be_stationary = true;
};

struct DistanceRange {
  double nearest = 0;
  double farthest = 0;  ///< infinite where nothing is known
};

/// The same bounds of the distance from a circle, centre.radius > 0, whose square is no form. With
/// X from the circle's centre, rho from its axis, and any number r,
///
///   d^2 - r^2 = g / (d^2 - r^2 + 4 R rho),  g = (|X|^2 + R^2 - r^2)^2 - 4 R^2 rho^2
///
/// g is a form and vanishes on the torus of radius r about the circle, so the bounds are exact
/// there.
///
/// cell     likewise, of degrees up to kMaxCircleDegree
DistanceRange circle_distance(const Cell& cell, const NetShape& shape, const Centre& centre);
inline constexpr int kMaxCircleDegree = 5;

/// The largest nets that this is made of.
inline constexpr int kMaxSquarePoints = 121;

/// cell     of no more than kMaxSquarePoints control points
/// across   u and v: whether f has to be stationary along it, to be of interest
SquareForm square_form(const Cell& cell, const NetShape& shape, const Centre& centre,
                       const std::array<bool, 2>& across = {false, false});

}  // namespace blossom
