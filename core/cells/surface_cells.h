// SPDX-License-Identifier: LGPL-2.1-or-later
// The cells of a whole surface.

#pragma once

#include <memory>
#include <vector>

#include "core/cells/cell_tree.h"
#include "core/forms/surface.h"
#include "core/math/interval.h"
#include "core/results/options.h"

namespace blossom {

/// A surface as cell trees of its patches, made when first asked for.
class SurfaceCells {
 public:
  /// part   what counts of the surface; empty: everything
  SurfaceCells(const BezierSurface& surface, const Vec3& origin, CellForm form, double cut,
               PartTest part = {});

  CellTree& tree(int patch);

  /// Makes the trees of patches, each named once, that are not there yet, by all threads.
  void make_trees(const std::vector<int>& patches);

  /// Gives the memory of all cells back; the trees' patches stay.
  void drop_cells();

  int patches() const { return static_cast<int>(trees_.size()); }
  const BezierSurface& surface() const { return surface_; }
  const Vec3& origin() const { return origin_; }  ///< of the trees
  int span_u(int patch) const { return patch / surface_.patches.columns(); }
  int span_v(int patch) const { return patch % surface_.patches.columns(); }
  Interval knots_u(int patch) const;
  Interval knots_v(int patch) const;

  /// True if a rectangle of a patch, in its own [0, 1]^2, lies outside of what counts of the
  /// surface, as far as the caller's test knows; likewise inside.
  bool outside(int patch, const Interval& u, const Interval& v) const;
  bool inside(int patch, const Interval& u, const Interval& v) const;

  /// Cells made so far, and their control points in memory.
  long cells() const;
  long stored_points() const;
  bool monomial() const;

 private:
  PartSide part_of(int patch, const Interval& u, const Interval& v) const;
  std::unique_ptr<CellTree> made_tree(int patch) const;

  const BezierSurface& surface_;
  Vec3 origin_;
  CellForm form_;
  double cut_;
  PartTest part_;
  std::vector<std::unique_ptr<CellTree>> trees_;
  std::vector<int> made_;  // patches whose tree is there
};

/// A pair of cells that a search begins with.
struct StartPair {
  int patch_a = 0;
  int cell_a = 0;
  int patch_b = 0;
  int cell_b = 0;
};

}  // namespace blossom
