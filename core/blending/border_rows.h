// SPDX-License-Identifier: LGPL-2.1-or-later
// The border of a surface as rows of Bezier points: the curve, and the derivatives across it.
//
// Notation: E(x) border curve, D_k(x) k-th derivative across it, D_0 = E, all homogeneous; x in
// [0, 1] along the whole border, proportional to the surface's own parameter.

#pragma once

#include <string>
#include <vector>

#include "core/blending/surface_side.h"
#include "core/forms/surface.h"
#include "core/math/interval.h"

namespace blossom {

/// Homogeneous Bezier points of a curve.
using Row = std::vector<Vec4>;

/// D_0, D_1, ... over one span of a border, all of one degree. Derivatives lead out of the surface.
using BorderRows = std::vector<Row>;

struct Border {
  std::string name;            ///< for messages, as "umin"
  std::vector<double> breaks;  ///< spans + 1 increasing values of x; first 0, last 1
  Interval range;              ///< the surface's own parameters along the border
  ParameterLaw law = ParameterLaw::Linear;
  std::vector<BorderRows> spans;  ///< continuous in their weights, starting at weight 1
  double depth = 0;               ///< length of the span behind the border, own parameter
  bool closed = false;            ///< the surface is closed along the border
  bool rational = false;          ///< else all weights are 1, and 0 in derivatives
  double error = 0;               ///< bound on how far the rows are off, model units
};

/// A border of a surface with its derivatives up to `order`. These are by a parameter that is the
/// surface's own to first order, and the same for all spans. The surface has to be valid.
Border border_of(const BezierSurface& surface, SurfaceSide side, int order);

/// The same border the other way.
void reverse(Border& border);

/// A closed border that starts at x, in (0, 1), instead of at 0.
Border restarted(const Border& border, double x);

/// One piece of a border, inside one of its spans.
struct BorderPiece {
  BorderRows rows;
  int span = 0;
  Interval local;  ///< of the span's local parameter; runs backwards when the piece does
};

/// The piece over [x.from, x.to]; from > to reverses it. An end within `snap` of a break is the
/// break, and then its points are those of the surface, bit for bit.
BorderPiece piece_of(const Border& border, const Interval& x, double snap);

/// Value and derivative of a homogeneous curve, as a point and a vector of space.
struct SpaceJet {
  Vec3 point;
  Vec3 derivative;
};

/// By the local parameter t in [0, 1] of the row.
SpaceJet jet_at(const Row& row, double t);

/// The derivative across a border in space: (D - D_w / E_w E) / E_w.
Vec3 across_at(const Row& edge, const Row& across, double t);

/// The point of the border at x. Model units.
Vec3 point_at(const Border& border, double x);

/// The Bezier points of the product f(t) row(t), f given by its Bernstein coefficients:
///   p_k = sum_(i + j = k) binom(n, i) binom(m, j) / binom(n + m, k) f_i row_j
/// Source: Farouki and Rajan 1988, arithmetic of polynomials in Bernstein form.
Row product(const std::vector<double>& factor, const Row& row);

/// The same curve with its degree raised to `degree`.
Row raised(const Row& row, int degree);

}  // namespace blossom
