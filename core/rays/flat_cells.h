// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces cut into cells that are nearly flat, with what makes queries on them fast.
//
// In the cell's own parameters x in [-1/2, 1/2]^2, S(x) = S(0) + x_u M_u + x_v M_v + rest. The dual
// vectors D (D_i . M_j = 1 or 0) and the unit normal N turn the rest into numbers: for every
// derivative S_j of the cell
//
//   |D_i . (S_j - M_j)| <= spread[i][j],   |N . (S_j - M_j)| <= tilt[j]
//
// so where and how often a line or a foot point can be in the cell follows from these six numbers.

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/bounds/box_tree.h"
#include "core/forms/surface.h"
#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/rays/two_forms.h"

namespace blossom {

struct FlatCell {
  int patch = 0;         ///< index into FlatCells::patches()
  bool regular = false;  ///< false near poles: then there are no dual vectors
  Interval u, v;         ///< place in the patch's [0, 1]^2
  Vec3 centre;           ///< S(0), model units
  std::array<Vec3, 2> dual;
  Vec3 normal;
  Matrix2 spread{};
  std::array<double, 2> tilt{};
  std::array<double, 2> dual_length{};
  std::array<double, 2> reach{};  ///< bounds of |S_u|, |S_v| by the cell's own parameters
};

/// A patch with its place in its surface.
struct PlacedPatch {
  const RationalBezierPatch* patch = nullptr;
  int surface = 0;
  int row = 0;
  int column = 0;
  std::array<bool, 2> ends_low{};   ///< the surface ends at u = 0, v = 0 of this patch
  std::array<bool, 2> ends_high{};  ///< likewise at 1
  double reach = 0;  ///< how far beyond its ends the surface still counts, model units
  double least_weight = 1;
  double largest_weight = 1;
};

class FlatCells {
 public:
  /// Cuts all patches until their cells are flat enough for one step of Newton's method to be
  /// good, or a cell is no larger than `smallest`.
  /// surfaces  validated, the result keeps them
  /// smallest  model units
  /// reaches   one for each surface: how far beyond its borders it still counts, as where edges
  ///           close gaps between faces; model units; empty stands for `smallest`
  /// throws    InvalidInput if there is no surface, one is not well formed, or the numbers of
  ///           surfaces and reaches differ
  FlatCells(std::vector<BezierSurface> surfaces, double smallest, std::vector<double> reaches);

  FlatCells(FlatCells&&) = default;
  FlatCells(const FlatCells&) = delete;  // patches are found by address
  FlatCells& operator=(const FlatCells&) = delete;

  const std::vector<BezierSurface>& surfaces() const { return surfaces_; }
  const std::vector<PlacedPatch>& patches() const { return patches_; }
  const std::vector<FlatCell>& cells() const { return cells_; }
  /// Boxes of the cells, roundings included.
  const std::vector<Box>& boxes() const { return boxes_; }

  /// The surface's own parameters of a place in a patch.
  Vec2 parameters(int patch, const Vec2& local) const;

  /// Largest absolute coordinate of a control point, model units.
  double scale() const { return scale_; }
  /// Bound on the rounding of a point that `jet_at` gives, relative to the largest coordinate.
  double evaluation_error() const { return evaluation_error_; }
  /// Largest number of control points of a patch.
  int largest_net() const { return largest_net_; }

 private:
  void add_patch(int surface, int row, int column);

  std::vector<BezierSurface> surfaces_;
  std::vector<PlacedPatch> patches_;
  std::vector<FlatCell> cells_;
  std::vector<Box> boxes_;
  std::vector<double> reaches_;
  double smallest_;
  std::size_t most_cells_;
  double scale_ = 0;
  double evaluation_error_ = 0;
  int largest_net_ = 0;
};

}  // namespace blossom
