// SPDX-License-Identifier: LGPL-2.1-or-later
// Borders of patches that lie on the other surface exactly.
//
// An arc along a border of its pair of cells is seen at points only: in doubles nothing tells it
// from one that crosses the border again and again by less than rounding. Control points are
// doubles, though, and so exact numbers: rationals decide what they lie on.

#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "core/cells/surface_cells.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// If q(t) is p(s) exactly, but for its degree and a change of its parameter
/// s = r t / (1 - t + r t): r, rounded. Control points are homogeneous, weights positive.
std::optional<double> parameter_ratio(const std::vector<Vec4>& p, const std::vector<Vec4>& q);

class ExactBorders {
 public:
  /// The surfaces have to outlive it.
  ExactBorders(const BezierSurface& a, const BezierSurface& b) : a_(a), b_(b) {}

  /// True if the arc, the only one in its pair of cells for each value of its parameter, is proven
  /// to be part of a border of a patch: both ends are there, and
  ///
  ///   (1) some border of the other patch, which has both ends too, is the same curve exactly, but
  ///       for its degree and a linear rational change of its parameter; or
  ///   (2) all control points of the other patch, and those of the border, lie in one plane,
  ///       exactly.
  ///
  /// throws   InvalidInput if a control point is not finite
  /// cost     rational arithmetic, a few numbers for each control point; once for each border and
  ///          patch
  bool hold(const FoundArc& arc);

 private:
  bool holds(int patch_a, int patch_b, std::size_t parameter, bool high, const FoundArc& arc);

  const BezierSurface& a_;
  const BezierSurface& b_;
  // By patches, border, and border of the other patch, or 4 for all of that: what was decided.
  std::map<std::array<int, 4>, bool> known_;
};

}  // namespace blossom
