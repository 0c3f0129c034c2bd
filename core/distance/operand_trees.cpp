// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/operand_trees.h"

#include <cstddef>

#include "core/cells/limits.h"

namespace blossom {
namespace {

constexpr int kHalvingsPerTrim = 6;  // of a cell: asking takes as long as these

}  // namespace

ItemTree::ItemTree(const DistanceItem& item)
    : cells(item.patch, item.rational, Vec3{}, CellForm::Bezier, kOffMiddle) {}

int ItemTree::split(int cell) {
  const int low = cells.split(cell);
  const auto size = static_cast<std::size_t>(cells.size());
  if (sides.size() < size) {
    const auto known = sides[static_cast<std::size_t>(cell)];
    sides.resize(size, known == TrimSide::Inside ? known : std::nullopt);
  }
  return low;
}

void OperandTrees::resolve(OperandPlace& place) const {
  if (place.item < 0 && node(place).item >= 0) place = {place.part, node(place).item, 0};
}

ItemTree& OperandTrees::tree(const OperandPlace& place) {
  auto& of_part = trees_[static_cast<std::size_t>(place.part)];
  if (of_part.empty()) of_part.resize(parts.items(place.part).size());
  auto& made = of_part[static_cast<std::size_t>(place.item)];
  if (!made) made = std::make_unique<ItemTree>(item(place));
  return *made;
}

bool OperandTrees::is_outside(const OperandPlace& place, bool always) {
  ItemTree& of = tree(place);
  auto& side = of.sides[static_cast<std::size_t>(place.cell)];
  const Cell& cell = of.cells[place.cell];
  if (!always && cell.depth % kHalvingsPerTrim != 0) return false;
  if (!side)
    side = parts.side(place.part, item(place), {cell.u.from, cell.v.from}, {cell.u.to, cell.v.to});
  return side == TrimSide::Outside;
}

bool OperandTrees::is_outside(const OperandPlace& place, const Vec2& at) const {
  return parts.side(place.part, item(place), at, at) == TrimSide::Outside;
}

}  // namespace blossom
