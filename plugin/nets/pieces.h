// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of nets, and nets in other forms.

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plugin/nets/net.h"

namespace blossom::nets {

/// What of each net is wanted; all in the source's parameters. At most one of the places.
struct Cut {
  std::optional<Interval> interval;                  ///< curves only
  std::optional<std::array<Interval, 2>> rectangle;  ///< patches only
  std::optional<TriangleCorners> triangle;           ///< patches and triangles
  int levels = 0;                                    ///< halvings in each direction
  std::optional<QParameters> q;                      ///< give pieces in (q1,q2)-Bezier form
  Stop stop;                                         ///< asked for every piece
};

/// A cut whose places are given by their numbers; an empty list for none.
struct CutNumbers {
  const std::vector<double>& interval;   ///< from, to
  const std::vector<double>& rectangle;  ///< u from, u to, v from, v to
  const std::vector<double>& triangle;   ///< u and v of three corners
  const std::vector<double>& q;          ///< q1, q2
};
Cut cut_of(const CutNumbers& numbers, int levels);

/// How many pieces a cut makes of a net at most.
double piece_count(const Net& net, const Cut& cut);

/// The pieces in Bezier or (q1,q2)-Bezier form, row by row of a grid.
///
/// A span of a face or an edge is clipped to the place, and gives no piece outside of it; where a
/// parameter is an angle, sides of triangles are straight in the rational form's own parameter. A
/// net of a file is taken on the whole place, also outside of its domain. Places run backwards if
/// from > to.
/// throws   occt::BadModel, naming the source, if the place is not one for this kind of net, a
/// weight is not positive there, or the (q1,q2)-basis does not exist
std::vector<Net> pieces(const Net& net, const Cut& cut);

/// The net on its whole domain in Bezier form.
/// throws   occt::BadModel as above
Net bezier_net(const Net& net);

/// The same in monomial form, its origin in the middle; triangles over x and y of `corners` a, b.
/// throws   as above, and if a triangle's degree is above kMaxDegree
Net monomial_net(const Net& net);

/// A patch as two triangles of degree n + m, lower left and upper right; a triangle as itself.
/// throws   occt::BadModel for a curve, and as above
std::vector<Net> triangle_nets(const Net& net);

/// A triangle as one patch of bidegree (N, N), its side u = 0 collapsed to the corner c, or to the
/// corner opposite to a side that is a point.
/// throws   occt::BadModel if the degree is above kMaxDegree
Net collapsed_net(const Net& net);

}  // namespace blossom::nets
