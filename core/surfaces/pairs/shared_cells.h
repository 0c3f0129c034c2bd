// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of cells of two patches that are parts of one surface.

#pragma once

#include <optional>

#include "core/bounds/box_tree.h"
#include "core/cells/cell_tree.h"
#include "core/surfaces/pairs/shared_chart.h"

namespace blossom {

/// What a pair of cells has in common: nothing, or a rectangle in which they coincide.
struct SharedPart {
  bool empty = true;
  Box4 box{};  ///< in the parameters of the patches
  Box hull;    ///< relative to the origin
};

/// Settles pairs of cells of two patches once it is known that these are parts of one surface.
class SharedCells {
 public:
  SharedCells(const CellTree& a, const CellTree& b, double tolerance)
      : a_(a), b_(b), tolerance_(tolerance) {}

  /// Looks for the common chart near a pair of nearly parallel cells, a few times at most; true if
  /// it is known.
  bool look_near(const Cell& a, const Cell& b);

  bool is_known() const { return chart_.has_value(); }

  /// returns   nothing unless it is proven that the cells meet only where they coincide: b must be
  ///           a graph over a plane as far as the place of a
  std::optional<SharedPart> part(const Cell& a, const Cell& b) const;

 private:
  const CellTree& a_;
  const CellTree& b_;
  double tolerance_;
  int looks_ = 0;
  int asked_ = 0;
  std::optional<SharedChart> chart_;
};

}  // namespace blossom
