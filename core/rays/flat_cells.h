// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces made ready for lines: their patches, and the flat cells of each where lines come near.

#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/bounds/box_tree.h"
#include "core/forms/surface.h"
#include "core/math/vec.h"

namespace blossom {

class PatchCells;

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
  /// Patches are cut where lines come near, until their cells are flat enough for one step of
  /// Newton's method to be good, or no larger than `smallest`.
  /// surfaces  validated, the result keeps them
  /// smallest  model units
  /// reaches   one for each surface: how far beyond its borders it still counts, as where edges
  ///           close gaps between faces; model units; empty stands for `smallest`
  /// throws    InvalidInput if there is no surface, one is not well formed, or the numbers of
  ///           surfaces and reaches differ
  FlatCells(std::vector<BezierSurface> surfaces, double smallest, std::vector<double> reaches);

  ~FlatCells();
  FlatCells(FlatCells&&) noexcept;
  FlatCells(const FlatCells&) = delete;  // patches are found by address
  FlatCells& operator=(const FlatCells&) = delete;

  const std::vector<BezierSurface>& surfaces() const { return surfaces_; }
  const std::vector<PlacedPatch>& patches() const { return patches_; }
  /// Boxes of the patches, roundings included, as far out as they still count.
  const std::vector<Box>& boxes() const { return boxes_; }
  /// The cells of a patch. Any number of threads may ask.
  PatchCells& cells_of(int patch) const;

  /// The surface's own parameters of a place in a patch.
  Vec2 parameters(int patch, const Vec2& local) const;

  /// Largest absolute coordinate of a control point, model units.
  double scale() const { return scale_; }
  /// Bound on the rounding of a point that `jet_at` gives, relative to the largest coordinate.
  double evaluation_error() const { return evaluation_error_; }
  /// Largest number of control points of a patch.
  int largest_net() const { return largest_net_; }

 private:
  struct Made;

  void add_patch(int surface, int row, int column);

  std::vector<BezierSurface> surfaces_;
  std::vector<PlacedPatch> patches_;
  std::vector<Box> boxes_;
  std::unique_ptr<Made[]> made_;
  std::vector<double> reaches_;
  double smallest_;
  int deepest_ = 0;
  double scale_ = 0;
  double evaluation_error_ = 0;
  int largest_net_ = 0;
};

}  // namespace blossom
