// SPDX-License-Identifier: LGPL-2.1-or-later
// The boxes of a surface's patches and of ever larger blocks of them.
//
// Patches lie in a grid already, so of large surfaces blocks of it are the hierarchy, which needs
// no sorting: it takes as long as looking at the control points once. Small ones take a tree.

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/bounds/box_tree.h"
#include "core/forms/surface.h"

namespace blossom {

/// Boxes in rows and columns, made by all threads. The first to touch their memory, which the
/// system clears then, is the thread that makes them: one alone would take a tenth of the time that
/// the boxes of 256 x 256 patches take.
class BoxGrid {
 public:
  /// grain    boxes that one thread makes in a row
  /// box_of   by number, row after row
  BoxGrid(int rows, int columns, std::size_t grain, const std::function<Box(std::size_t)>& box_of);

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  std::span<const Box> values() const { return {boxes_.get(), count_}; }
  const Box& operator()(int row, int column) const {
    return boxes_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

 private:
  struct Release {
    void operator()(Box* boxes) const { ::operator delete(boxes); }
  };

  int rows_, columns_;
  std::size_t count_;
  std::unique_ptr<Box[], Release> boxes_;
};

class PatchBoxes {
 public:
  /// Boxes of the control points, as they are; made by all threads.
  explicit PatchBoxes(const BezierSurface& surface);

  /// The same of a surface that is validated on the way, in one walk over its control points.
  ///
  /// throws   InvalidInput as `validate`
  PatchBoxes(const BezierSurface& surface, const char* name);

  /// Box of all control points.
  const Box& all() const { return levels_.back()(0, 0); }

  /// Pairs of patches of two surfaces, numbered row after row, whose boxes meet or are no farther
  /// apart than `gap`, model units. A surface that comes this close to another one is not missed
  /// for the rounding of cells (`margin` of a Cell).
  friend std::vector<std::array<int, 2>> meeting_patches(const PatchBoxes& a, const PatchBoxes& b,
                                                         double gap);

 private:
  std::span<const Box> patches() const { return levels_.front().values(); }
  void add_blocks();

  std::vector<BoxGrid> levels_;  // of patches, of blocks of those, and so on up to one box
};

std::vector<std::array<int, 2>> meeting_patches(const PatchBoxes& a, const PatchBoxes& b,
                                                double gap = 0);

}  // namespace blossom
