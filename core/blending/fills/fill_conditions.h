// SPDX-License-Identifier: LGPL-2.1-or-later
// What smoothness asks of the control points of a fill: linear equations that depend on the layout,
// the number of sides and the degree alone.
//
// f is a function over the polygon of a layout, beta_q the bilinear map of quad q, and the patch
// Q_q = f o beta_q has degree d in both parameters. Quads share the control points of their common
// edges and vertices, so f is continuous. On an edge shared by quads a and b, e is the derivative
// of beta along it, A = d beta_a and B = d beta_b the derivatives across it into each quad, and
// [x, y] the determinant of two vectors of the plane.
//
//   G1:  [A, B] Q_e + [B, e] Q_A + [e, A] Q_B = 0
//   G2:  Q_BB = p^2 Q_ee + 2 p q (Q_eA - p' Q_e - q' Q_A) + q^2 Q_AA,
//        B = p e + q A,   d^2 beta_a / de dA = p' e + q' A
//
// They say that f has continuous first, or second, derivatives across the edge. They are imposed at
// one Chebyshev node more than their degree in the edge's parameter asks for, or several.
//
// Data: each side of the polygon gives its border's control points, and for each half of it the
// Bernstein coefficients of Q_y / d and Q_yy / (d (d - 1)), y the parameter into the polygon.

#pragma once

#include <vector>

#include "core/blending/fills/fill_layout.h"
#include "core/math/grid.h"

namespace blossom {

/// How smoothly patches meet, along an edge or a side.
enum class FillContinuity { G0, G1, G2 };

/// "G0", "G1" or "G2".
const char* to_string(FillContinuity continuity);

/// A control point: its number within a sector, and the sector.
struct FillPoint {
  int number = 0;
  int sector = 0;
};

/// The distinct control points of a sector: 2 d of its side from P_0 on, without P_1; then those
/// inside, the centre last. The centre belongs to every sector.
struct FillPoints {
  int degree = 0;
  int quads = 0;                  ///< of a sector
  int border = 0;                 ///< 2 d
  int count = 0;                  ///< all of a sector
  std::vector<FillPoint> points;  ///< (quad, i, j), j fastest

  int inner() const { return count - border; }
  int centre() const { return count - 1; }
  const FillPoint& at(int quad, int i, int j) const {
    return points[static_cast<std::size_t>((quad * (degree + 1) + i) * (degree + 1) + j)];
  }
  /// `along` an edge of a quad, `inwards` from it.
  FillPoint at(const QuadEdge& edge, int along, int inwards) const;
};

FillPoints fill_points(const PolygonLayout& layout, int degree);

/// Where the data of a side lie in the vector of a sector's data.
struct FillData {
  int degree = 0;
  int order = 1;  ///< 1 with Q_y, 2 with Q_yy, too

  int count() const { return 2 * degree + 2 * order * (degree + 1); }
  /// Q_y (order 1) or Q_yy (order 2) of a half, coefficient i.
  int at(int order_of, int half, int i) const {
    return 2 * degree + (2 * (order_of - 1) + half) * (degree + 1) + i;
  }
};

/// sum of factor * point = datum; 0 if `datum` is negative.
struct FillTerm {
  FillPoint point;
  double factor = 0;
};
struct FillRow {
  std::vector<FillTerm> terms;
  int datum = -1;
  bool second_order = false;  ///< of G2, not of G1
};

/// All conditions of sector 0; those of the others are the same, turned.
std::vector<FillRow> fill_conditions(const PolygonLayout& layout, const FillPoints& points,
                                     FillContinuity continuity);

/// The thin-plate energy of a quad of sector 0 over the plane of the polygon,
///   integral of f_xx^2 + 2 f_xy^2 + f_yy^2,
/// as a quadratic form in its control points (i, j), j fastest. By Kronrod's 15 x 15 nodes.
Grid<double> thin_plate(const PolygonLayout& layout, int quad, int degree);

/// Values of the Bernstein polynomials of degree n and of their first two derivatives at t.
struct BernsteinJet {
  std::vector<double> value, first, second;
};
BernsteinJet bernstein_jet(int degree, double t);

}  // namespace blossom
