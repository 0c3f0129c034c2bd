// SPDX-License-Identifier: LGPL-2.1-or-later
// Points in which all terms of a gap below some order vanish.
//
// Round such a point, a node of order n, the gap is a form f of degree n of the place: n lines of
// zeros, some of them perhaps in one or complex. It is less than the tolerance over a disc much
// wider than the tolerance. With f_k the terms of degree k round a point p, the node is where
//
//   f_(n - 1)(p) = 0,   and a move by e changes f_(n - 1) by e . grad f_n
//
// in the least squares of Bombieri's norm, which no turn of the plane changes.

#pragma once

#include <optional>

#include "core/math/series/taylor_series.h"

namespace blossom {

/// Tolerances: what is below one may be read off a gap up to here. A choice: the search takes cells
/// in which the gap is below one for contact, and looks somewhat beyond them.
inline constexpr double kDiscGap = 8;

struct NodeForm {
  Vec2 at;            ///< the node
  int order = 0;      ///< 3 to kTaylorDegree
  double radius = 0;  ///< of the disc: the form's valleys stay within some tolerances up to there
};

/// The node of the lowest order, if the gap within its disc is that of its form alone: but for a
/// tolerance by lower terms, and for half of it and kDiscGap tolerances by higher ones.
///
/// gap       in coordinates of unit length; model units
/// rest      the gap is this polynomial up to so much,
/// reach     so far from 0; `at` may lie as far away
/// widest    a disc that is wider is no point
std::optional<NodeForm> node_form(const TaylorPolynomial& gap, double rest, double reach,
                                  double tolerance, double widest);

}  // namespace blossom
