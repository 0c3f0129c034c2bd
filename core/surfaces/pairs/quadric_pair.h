// SPDX-License-Identifier: LGPL-2.1-or-later
// What the quadrics that two patches lie on tell about pairs of their cells.

#pragma once

#include "core/cells/surface_cells.h"
#include "core/surfaces/pairs/quadric_band.h"

namespace blossom {

/// True if a surface is all of a quadric: it ends nowhere, as a whole sphere, and all of its
/// patches lie on one.
bool is_whole_quadric(SurfaceCells& surface, QuadricBands& bands);

class QuadricPair {
 public:
  /// one_is_whole   one of the patches' surfaces is all of a quadric
  /// size           of the surfaces, model units
  QuadricPair(const CellTree& a, const CellTree& b, QuadricBands& bands, bool one_is_whole,
              double size);

  /// Of patch b; null if it lies on none that can be told.
  const QuadricBand* band_b() const { return band_b_; }

  /// True if both patches lie on one quadric and one of their surfaces is all of it: then they
  /// coincide as far as the other one goes.
  bool is_one() const { return is_one_; }

  /// True if both patches lie on one quadric, and neither surface is known to be all of it.
  bool is_common() const { return is_common_; }

  /// True if b's quadric is smooth all over both cells, and values in it tell that they are within
  /// tolerance of each other.
  bool is_steep(const Cell& a, const Cell& b) const;

  /// Of patches on one quadric: true if the cells are so small that the whole surface passes
  /// through their common box once.
  bool coincide(const Cell& a, const Cell& b) const;

  /// Of patches on two quadrics that hardly differ there: the same for cells that lie within
  /// tolerance of the other one's quadric.
  bool touch_all_over(const Cell& a, const Cell& b) const;

  /// Where surfaces coincide or touch all over: true if the cells also have the middle of one of
  /// them in common, or are too small to tell more of the border of what the patches have in
  /// common.
  bool cover_each_other(const Cell& a, const Cell& b) const;

  /// True if the equation of one patch proves that the other one's cell does not come close to it.
  bool are_disjoint(const Cell& a, const Cell& b) const;

 private:
  const CellTree &tree_a_, &tree_b_;
  const QuadricBand *band_a_, *band_b_;
  bool is_small(const Cell& a, const Cell& b) const;

  double size_;
  double spread_;  // of values, see QuadricBand::spread_over
  bool is_one_, is_common_;
};

}  // namespace blossom
