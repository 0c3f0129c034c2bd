// SPDX-License-Identifier: LGPL-2.1-or-later
// The gap between two nearly parallel surfaces as one function of two variables.
//
// Over a plane with unit normal n let a piece of surface b be a graph g. Then a point A(x, y) of
// surface a lies on b exactly where
//   gap(x, y) = n . A(x, y) - g(plane part of A(x, y)) = 0
// and the foot point of A(x, y), the point of b over the same place of the plane, lies in b. The
// curvature the surfaces share cancels in the gap, so it tells contacts apart that four variables
// cannot: touch, node, loop, cusp, tangential curve.
//
// Source: `core/surfaces/README.md`, "Contacts".

#pragma once

#include <array>
#include <optional>

#include "core/cells/cell_tree.h"
#include "core/math/series/taylor_series.h"

namespace blossom {

/// A piece of a patch that is proven to be a graph over a plane.
struct GraphChart {
  Interval s, t;            ///< the piece, in the patch's parameters
  Interval wide_s, wide_t;  ///< a larger one, extended beyond the patch, on which the proof holds
  Vec3 normal;              ///< unit, of the plane
  Vec3 e1, e2;              ///< unit, of the plane, at right angles
  Vec3 to_s, to_t;          ///< rows that take vectors to parts of the larger piece, on average
};

/// Proves that the piece [s] x [t], somewhat enlarged, is a graph over its mean tangent plane.
///
/// widening  of the piece on each side, as a part of its width
/// returns   nothing if its normals turn too far: then it has to be halved
///
/// Source: Gale and Nikaido 1965: a map of a rectangle whose mean Jacobians are P-matrices is
/// injective.
std::optional<GraphChart> graph_chart(const CellTree& tree, const Interval& s, const Interval& t,
                                      double widening);

/// False if the cell is much too large for a model over the chart.
bool may_have_model(const Cell& a, const GraphChart& chart);

/// The gap over a cell of surface a, with x, y in [-1, 1] across the cell.
struct GapModel {
  TaylorPolynomial gap{};                  ///< model units
  std::array<double, 3> gap_error{};       ///< of the value and of first, second derivatives
  std::array<TaylorPolynomial, 2> foot{};  ///< s, t: parameters of the foot point
  std::array<double, 2> foot_error{};
  std::array<double, 2> foot_slope_error{};  ///< of its first derivatives
};

/// returns   nothing if the cell is too large for a proven model, or leaves the chart
std::optional<GapModel> gap_model(const CellTree& tree_a, const Cell& a, const CellTree& tree_b,
                                  const GraphChart& chart);

/// The part of the cell outside of which no foot point lies in the patch of b, from the slopes of
/// the foot point.
///
/// returns   fractions of the cell in u and v; from > to if nothing is left
std::array<Interval, 2> part_over_patch(const GapModel& model);

}  // namespace blossom
