// SPDX-License-Identifier: LGPL-2.1-or-later
// Two curve cells that run nearly parallel, as one function of one variable.
//
// Along a common direction e both cells are graphs, y_A(x) and y_B(x), in the direction m in which
// their curvatures differ. Where the gap h(x) = y_A(x) - y_B(x) is proven strictly convex (or
// concave), it has at most two zeros and one least value; so its signs at three places tell all:
// two crossings, one, a touch, or none. That decides tangential and nearly tangential contacts at
// the scale of the curvature, long before the cells are as small as the tolerance. Where the gap
// may be both, its value, slope and bend still tell that it is above the tolerance or within it all
// over, for cells that are far longer than fat lines would allow.

#pragma once

#include <array>
#include <optional>

#include "core/curves/curve_pair.h"

namespace blossom {

/// A zero of the gap or a least value within tolerance.
struct ValleyPoint {
  CurveFoot foot;
  bool touch = false;      ///< a least value; else a zero where the gap changes its sign
  ValueRange gap;          ///< proven bounds of the distance, model units
  double half_length = 0;  ///< of the run along which the gap stays within tolerance, about
};

struct ValleyPoints {
  std::array<ValleyPoint, 2> points;
  int count = 0;
  bool contact = false;  ///< within tolerance all along these parts of the spans; in the plane only
  Interval a, b;
};

/// The zeros and the touch of a pair of cells.
///
/// tolerance  least values up to this count as touches, model units
/// longest    contacts longer than this are left to others, model units
/// returns    nothing if the pair is not decided: the gap is not proven convex nor to one side of
///            the tolerance, the contact would be too long, or, in space, the curves part in the
///            third direction by more than rounding
std::optional<ValleyPoints> valley_points(const CurvePair& pair, double tolerance, double longest);

/// The same in the plane for a straight cell and a polynomial one, without a common direction: the
/// distance h(t) of the second curve from the line is a polynomial in its Bernstein form.
///
/// returns    nothing as well if neither cell is of degree 1, or both are
///
/// Source: Sederberg and Nishita 1990, for the distance.
std::optional<ValleyPoints> line_points(const CurvePair& pair, double tolerance, double longest);

}  // namespace blossom
