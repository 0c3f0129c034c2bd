// SPDX-License-Identifier: LGPL-2.1-or-later
// Cells of the heights of patches and curves along an axis: Bernstein coefficients of one
// coordinate, and of the weights where there are any, in one store that is used again.

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/forms/patch.h"

namespace blossom {

/// A net of heights: rows x columns numerators, then as many weights of a rational one.
struct HeightNet {
  std::size_t at = 0;  ///< its place in the store
  int rows = 0;
  int columns = 0;  ///< 1 of a curve
  bool rational = false;

  int size() const { return rows * columns; }
  std::size_t numbers() const { return static_cast<std::size_t>(rational ? 2 * size() : size()); }
};

/// How heights vary over a cell.
struct HeightBounds {
  double upper = 0;            ///< no height is above this
  bool may_be_highest = true;  ///< false: a derivative vanishes nowhere where a height is wanted
  bool varies_along_u = true;  ///< more than along v
};

class HeightCells {
 public:
  /// The heights of a patch, or of a curve that all its columns are.
  HeightNet load(const RationalBezierPatch& patch, bool rational, bool is_curve, int axis,
                 double sign);

  /// Halves a net, which becomes the lower half.
  /// returns   the upper half
  HeightNet split(const HeightNet& net, bool along_u);

  /// Its place is used again.
  void release(const HeightNet& net);

  /// wanted     heights that matter are above this
  /// across     whether the derivative along u and v vanishes where a height is the largest
  /// rounding   of numbers of the net, relative to the largest
  HeightBounds bounds(const HeightNet& net, double wanted, const std::array<bool, 2>& across,
                      double rounding) const;

  /// The height at a corner.
  double corner(const HeightNet& net, bool last_row, bool last_column) const;

 private:
  std::size_t room_for(std::size_t numbers);

  std::vector<double> store_;
  std::array<std::vector<std::size_t>, 12> free_;  // places, by the power of two of their sizes
};

}  // namespace blossom
