// SPDX-License-Identifier: LGPL-2.1-or-later
// One of two sets whose distance is asked for, with trees of cells: made when a pair needs them.

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/cells/cell_tree.h"
#include "core/distance/distance_parts.h"

namespace blossom {

/// A cell of an item of a part; while there is no item, a node of the part's tree of boxes.
struct OperandPlace {
  int part = 0;
  int item = -1;
  int cell = 0;
};

/// The cells of an item, and how those that were asked about lie to the trims.
struct ItemTree {
  CellTree cells;
  std::vector<std::optional<TrimSide>> sides{std::nullopt};

  explicit ItemTree(const DistanceItem& item);

  /// Halves of a cell inside are inside.
  /// returns   the first half; the second follows it
  int split(int cell);
};

class OperandTrees {
 public:
  explicit OperandTrees(const DistanceParts& of)
      : parts(of), trees_(static_cast<std::size_t>(of.size())) {}

  const DistanceParts& parts;

  const DistanceItem& item(const OperandPlace& place) const {
    return parts.items(place.part)[static_cast<std::size_t>(place.item)];
  }
  const BoxTree::Node& node(const OperandPlace& place) const {
    return parts.item_tree(place.part).node(place.cell);
  }
  const Box& box(const OperandPlace& place) const {
    return place.item < 0 ? node(place).box : item(place).box;
  }

  /// Of a node that has one item alone, makes that item's first cell.
  void resolve(OperandPlace& place) const;

  ItemTree& tree(const OperandPlace& place);

  /// Whether a cell lies outside of the trims.
  /// always   else it is asked at every so many halvings, and false at others
  bool is_outside(const OperandPlace& place, bool always);
  /// at   local parameters of the item
  bool is_outside(const OperandPlace& place, const Vec2& at) const;

  DistanceEnd end(const OperandPlace& place, const Vec2& at, const Vec3& point) const {
    return parts.end(place.part, item(place), at, point);
  }

 private:
  std::vector<std::vector<std::unique_ptr<ItemTree>>> trees_;  // by part and item
};

}  // namespace blossom
