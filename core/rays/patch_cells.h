// SPDX-License-Identifier: LGPL-2.1-or-later
// The cells of one patch as a tree of boxes that grows where lines come near.
//
// A cell is looked at when a line first meets its box: then it is flat enough, or halved. So one
// line through a long pipe cuts a few cells, and many lines cut all of them once.

#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>

#include "core/base/unbounded.h"
#include "core/bounds/box_tree.h"
#include "core/cells/cell_tree.h"
#include "core/rays/flat_cell.h"

namespace blossom {

class PatchCells {
 public:
  struct Options {
    int patch = 0;        ///< what the cells say that they are of
    double reach = 0;     ///< how far beyond its borders the patch counts, model units
    double smallest = 0;  ///< a cell of this size is not halved, model units
    int deepest = 0;      ///< halvings, at most `kDeepest`
  };
  static constexpr int kDeepest = 30;

  /// patch  lives as long as this
  PatchCells(const RationalBezierPatch& patch, bool rational, const Options& options);

  /// Calls `visit(cell)` for the cells whose boxes a line meets, nearer halves first. Any number of
  /// threads may call.
  /// visit  returns the parameter up to which cells are still wanted
  template <class Visit>
  void for_each_along(LineProbe probe, Visit visit);

 private:
  enum class State : unsigned char { New, Flat, Halved };

  // What is below `state` is there when it says so, and changes no more.
  struct Node {
    Box box;
    int cell = 0;  // in the tree of nets
    std::atomic<State> state{State::New};
    FlatCell flat;
    std::unique_ptr<std::array<Node, 2>> halves;
  };

  void look_at(Node& node);
  Box box_of(int cell) const;

  const RationalBezierPatch& patch_;
  Options options_;
  std::mutex growing_;
  CellTree nets_;
  int new_nodes_ = 1;
  Node root_;
};

template <class Visit>
void PatchCells::for_each_along(LineProbe probe, Visit visit) {
  struct Waiting {
    Node* node;
    double at;
  };
  std::array<Waiting, kDeepest + 2> stack;
  std::size_t top = 0;
  const auto wait = [&](Node& node, double at) {
    if (at <= probe.to && at < kInfinity) stack[top++] = {&node, at};
  };
  wait(root_, probe.entry(root_.box));
  while (top > 0) {
    const Waiting next = stack[--top];
    if (next.at > probe.to) continue;
    Node& node = *next.node;
    if (node.state.load(std::memory_order_acquire) == State::New) look_at(node);
    if (node.state.load(std::memory_order_acquire) == State::Flat) {
      probe.to = std::min(probe.to, visit(std::as_const(node.flat)));
      continue;
    }
    auto& [low, high] = *node.halves;
    const double at_low = probe.entry(low.box), at_high = probe.entry(high.box);
    if (at_low <= at_high) {
      wait(high, at_high);
      wait(low, at_low);
    } else {
      wait(low, at_low);
      wait(high, at_high);
    }
  }
}

}  // namespace blossom
