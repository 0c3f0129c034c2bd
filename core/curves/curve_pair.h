// SPDX-License-Identifier: LGPL-2.1-or-later
// What a pair of curve cells proves: that it holds no common point, or one at most, and where.

#pragma once

#include <optional>

#include "core/cells/curve_cells.h"

namespace blossom {

/// Two curves and a cell of each.
struct CurvePair {
  const CurveTree& tree_a;
  const CurveCell& a;
  const CurveTree& tree_b;
  const CurveCell& b;

  int dimension() const { return tree_a.dimension(); }
  /// Bound on the error of a - b at given parameters, model units.
  double margin() const { return 2 * (tree_a.evaluation_margin() + tree_b.evaluation_margin()); }
};

/// A point of each curve, and how far they are from each other.
struct CurveFoot {
  SpanPoint a, b;
  CurveJet jet_a, jet_b;

  Vec3 gap() const { return jet_a.point - jet_b.point; }
};

/// The jets at a pair of places.
CurveFoot foot_at(const CurvePair& pair, const SpanPoint& a, const SpanPoint& b);

/// True if the boxes prove that the distance of all points of the cells is above the tolerance,
/// rounding included.
bool boxes_apart(const CurvePair& pair, double tolerance);

/// A lower bound on the sine of the angle between any direction of one cell and any of the other.
/// Nothing if the double cones of directions are not apart. If they are, the cells have at most
/// one common point: chords of the two curves are never parallel, as they would have to be between
/// two common points.
std::optional<double> least_sine(const CurvePair& pair);

/// The places nearest to each other, by the method of Gauss and Newton; with residual 0 that is
/// Newton's. `start` holds the first guess; the result may lie outside the cells.
/// returns   nothing if the steps do not settle or leave the cells blown up to twice their size
std::optional<CurveFoot> nearest_feet(const CurvePair& pair, CurveFoot start);

/// Where the chords of the cells come closest, for a start.
CurveFoot chord_feet(const CurvePair& pair);

/// In the plane, with cones apart: true if the cones at one point of each cell (`foot`) prove that
/// the cells have no common point.
bool cones_exclude(const CurvePair& pair, const CurveFoot& foot);

}  // namespace blossom
