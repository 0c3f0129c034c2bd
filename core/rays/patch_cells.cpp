// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/rays/patch_cells.h"

#include "core/cells/limits.h"

namespace blossom {

// Halved off the middle: poles and symmetries of models lie on dyadic lines.
PatchCells::PatchCells(const RationalBezierPatch& patch, bool rational, const Options& options)
    : patch_(patch),
      options_(options),
      nets_(patch, rational, Vec3{}, CellForm::Bezier, kOffMiddle) {
  options_.deepest = std::min(options_.deepest, kDeepest);
  root_.box = box_of(0);
}

Box PatchCells::box_of(int cell) const {
  return widened({nets_[cell].low, nets_[cell].high}, options_.reach);
}

// The nets are given back as soon as all cells are there.
void PatchCells::look_at(Node& node) {
  const std::lock_guard<std::mutex> lock(growing_);
  if (node.state.load(std::memory_order_relaxed) != State::New) return;
  const Cell& cell = nets_[node.cell];
  node.flat = flat_cell(cell, patch_);
  node.flat.patch = options_.patch;
  const bool settled =
      is_flat(node.flat) || cell.depth >= options_.deepest || cell.extent <= options_.smallest;
  if (!settled) {
    const int low = nets_.split(node.cell);
    node.halves = std::make_unique<std::array<Node, 2>>();
    for (int i = 0; i < 2; ++i) {
      Node& half = (*node.halves)[static_cast<std::size_t>(i)];
      half.cell = low + i;
      half.box = box_of(half.cell);
    }
    new_nodes_ += 2;
  }
  if (--new_nodes_ == 0) nets_.drop_cells();
  node.state.store(settled ? State::Flat : State::Halved, std::memory_order_release);
}

}  // namespace blossom
