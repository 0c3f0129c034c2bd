// SPDX-License-Identifier: LGPL-2.1-or-later
// Cells that a quadric keeps apart from a patch: by their values in its equation.
//
// All of a patch on a quadric, and all that is within tolerance of it, lies in a band of values
// |q| <= half. A cell over which q stays outside of the band does not come that close. Surfaces
// of one shape bend alike, so boxes and planes need many cells where one value tells.

#pragma once

#include <map>
#include <optional>

#include "core/cells/cell_tree.h"
#include "core/forms/quadric.h"

namespace blossom {

class QuadricBand {
 public:
  /// The band of a patch; nothing if it lies on no quadric that can be told.
  ///
  /// tree        of the patch; its origin is that of the cells to be asked about
  /// tolerance   model units
  static std::optional<QuadricBand> of(const CellTree& tree, double tolerance);

  /// True if it is proven that the cell stays farther from the patch than the tolerance.
  ///
  ///   q(S(u, v)) is a form of twice the cell's degrees; with X_i the cell's homogeneous points its
  ///   coefficients are means of X_i^T Q X_j
  ///
  /// shape       of the cell's net
  /// cost        O(n^2 m^2) for a cell on neither side of the quadric that has corners on one
  bool misses(const Cell& cell, const NetShape& shape) const;

  /// True if the values over this patch and those over another one are proven to be, together,
  /// within half of the tolerance: where they are steep the patches are as close to each other.
  bool holds_tightly(const CellTree& other) const;

  /// Largest value over this patch and largest over a cell of another one, added, as parts of the
  /// tolerance. Where values change by so much of the distance at least (`is_steep_in`), the patch
  /// and the cell are within tolerance of each other. Infinite for nets that are too large.
  ///
  /// shape       of the cell's net
  double spread_over(const Cell& cell, const NetShape& shape) const;

  /// True if values change by this part of the distance at least, and by half of it, at all points
  /// of the cell.
  ///
  ///   |grad q|^2 is a quadric, too: with Q' the upper three rows of Q, its matrix is 4 Q'^T Q'
  ///
  /// shape       of the cell's net
  bool is_steep_in(const Cell& cell, const NetShape& shape, double part) const;

 private:
  bool is_steep_in_box_of(const Cell& cell, double part) const;
  double largest_over(const Cell& cell, const NetShape& shape) const;

  Quadric quadric_;
  double half_ = 0;       // largest |q| in the band; about a distance
  double tolerance_ = 0;  // model units
  double off_ = 0;        // largest |q| over the patch
};

/// The bands of patches, made when first asked for.
class QuadricBands {
 public:
  /// tolerance   model units
  explicit QuadricBands(double tolerance) : tolerance_(tolerance) {}

  /// Null if the patch lies on no quadric that can be told.
  const QuadricBand* of(const CellTree& tree);

 private:
  double tolerance_;
  std::map<const CellTree*, std::optional<QuadricBand>> bands_;
};

}  // namespace blossom
