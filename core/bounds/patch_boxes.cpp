// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/bounds/patch_boxes.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <type_traits>

#include "core/base/parallel.h"
#include "core/base/unbounded.h"
#include "core/forms/evaluation.h"
#include "core/math/four.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

constexpr int kBlock = 4;  // so many boxes a side have one above them
constexpr std::size_t kFewPatches = 1024;
constexpr std::size_t kPatchGrain = 256;          // patches, and
constexpr std::size_t kBlockGrain = 64;           // blocks that one thread bounds in a row
constexpr std::size_t kMinShared = 64;            // pairs of blocks, to share out
constexpr double kRounding = 16 * kUnitRoundoff;  // of the coordinates: as much as cells allow for

// All four coordinates at a time, the weights for nothing.
BLOSSOM_HOT Box polynomial_hull_box(std::span<const Vec4> points) {
  Four low{kInfinity, kInfinity, kInfinity, kInfinity}, high = -low;
  for (const Vec4& p : points) {
    Four x;
    std::memcpy(&x, &p, sizeof x);
    low = x < low ? x : low;
    high = high < x ? x : high;
  }
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

Box hull_box(const RationalBezierPatch& patch, bool rational) {
  if (!rational) return polynomial_hull_box(patch.points.values());
  Box box;
  for (const Vec4& p : patch.points.values()) {
    const Vec3 x = projected(p);
    box = joined(box, {x, x});
  }
  return box;
}

// Visits each patch, too, while it is in the cache.
template <class Visit>
BoxGrid patch_boxes(const BezierSurface& surface, Visit visit) {
  return {surface.patches.rows(), surface.patches.columns(), kPatchGrain, [&](std::size_t i) {
            const RationalBezierPatch& patch = surface.patches.values()[i];
            visit(patch);
            return hull_box(patch, surface.rational);
          }};
}

BoxGrid blocks_of(const BoxGrid& boxes) {
  const auto count = [](int n) { return (n + kBlock - 1) / kBlock; };
  const int rows = count(boxes.rows()), columns = count(boxes.columns());
  return {rows, columns, kBlockGrain, [&boxes, columns](std::size_t k) {
            const int row = kBlock * (static_cast<int>(k) / columns);
            const int column = kBlock * (static_cast<int>(k) % columns);
            Box box;
            for (int i = row; i < std::min(row + kBlock, boxes.rows()); ++i)
              for (int j = column; j < std::min(column + kBlock, boxes.columns()); ++j)
                box = joined(box, boxes(i, j));
            return box;
          }};
}

// Of a few boxes a tree is as quick, and its halves are nearly as thin as the boxes allow.
BoxTree tree_of(std::span<const Box> patches, double gap) {
  std::vector<Box> boxes;
  for (const Box& box : patches)
    boxes.push_back(
        widened(box, gap + kRounding * std::max(max_norm(box.low), max_norm(box.high))));
  return BoxTree(boxes);
}

// A box of some level.
struct Block {
  std::size_t level;
  int row;
  int column;
};

double longest_side(const Box& box) {
  return std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
}

using Pairs = std::vector<std::array<int, 2>>;

// Walks down two hierarchies; the longer box is divided first.
class Meeting {
 public:
  Meeting(const std::vector<BoxGrid>& a, const std::vector<BoxGrid>& b, double gap)
      : a_(a), b_(b), margin_(margin_of(a) + margin_of(b) + gap) {}

  // The order is that of a walk by one thread.
  Pairs run() const {
    const std::vector<BlockPair> blocks = meeting_blocks();
    std::vector<Pairs> found(blocks.size());
    parallel_for(blocks.size(), 1, [&](std::size_t k) { descend(blocks[k], found[k]); });
    Pairs all;
    for (const Pairs& part : found) all.insert(all.end(), part.begin(), part.end());
    return all;
  }

 private:
  struct BlockPair {
    Block p, q;
  };

  // Enough of them for all threads, if there are any more.
  std::vector<BlockPair> meeting_blocks() const {
    std::vector<BlockPair> blocks;
    const Block p{a_.size() - 1, 0, 0}, q{b_.size() - 1, 0, 0};
    if (meet(widened(box(a_, p), margin_), box(b_, q))) blocks.push_back({p, q});
    while (!blocks.empty() && blocks.size() < kMinShared &&
           !std::ranges::all_of(blocks, are_patches)) {
      std::vector<BlockPair> parts;
      for (const BlockPair& pair : blocks)
        are_patches(pair) ? parts.push_back(pair)
                          : divide(pair, [&](const BlockPair& part) { parts.push_back(part); });
      blocks = std::move(parts);
    }
    return blocks;
  }

  static bool are_patches(const BlockPair& pair) { return pair.p.level == 0 && pair.q.level == 0; }

  static const Box& box(const std::vector<BoxGrid>& levels, const Block& block) {
    return levels[block.level](block.row, block.column);
  }

  static double margin_of(const std::vector<BoxGrid>& levels) {
    const Box& all = levels.back()(0, 0);
    return kRounding * std::max(max_norm(all.low), max_norm(all.high));
  }

  // Of boxes that meet.
  void descend(const BlockPair& pair, Pairs& found) const {
    const auto& [p, q] = pair;
    if (are_patches(pair))
      found.push_back({p.row * a_[0].columns() + p.column, q.row * b_[0].columns() + q.column});
    else
      divide(pair, [&](const BlockPair& part) { descend(part, found); });
  }

  template <class Visit>
  void divide(const BlockPair& pair, Visit visit) const {
    const auto& [p, q] = pair;
    const Box &box_p = box(a_, p), &box_q = box(b_, q);
    if (q.level == 0 || (p.level > 0 && longest_side(box_p) >= longest_side(box_q)))
      for_each_part(a_, p, widened(box_q, margin_), [&](const Block& part) { visit({part, q}); });
    else
      for_each_part(b_, q, widened(box_p, margin_), [&](const Block& part) { visit({p, part}); });
  }

  // Those parts that meet a box.
  template <class Visit>
  static void for_each_part(const std::vector<BoxGrid>& levels, const Block& block, const Box& near,
                            Visit visit) {
    const BoxGrid& parts = levels[block.level - 1];
    const int row = kBlock * block.row, column = kBlock * block.column;
    for (int i = row; i < std::min(row + kBlock, parts.rows()); ++i)
      for (int j = column; j < std::min(column + kBlock, parts.columns()); ++j)
        if (meet(parts(i, j), near)) visit({block.level - 1, i, j});
  }

  const std::vector<BoxGrid>& a_;
  const std::vector<BoxGrid>& b_;
  const double margin_;
};

}  // namespace

static_assert(std::is_trivially_destructible_v<Box>);  // as a grid of them is given back unseen

BoxGrid::BoxGrid(int rows, int columns, std::size_t grain,
                 const std::function<Box(std::size_t)>& box_of)
    : rows_(rows),
      columns_(columns),
      count_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns)),
      boxes_(static_cast<Box*>(::operator new(count_ * sizeof(Box)))) {
  parallel_for(count_, grain,
               [&](std::size_t i) { std::construct_at(boxes_.get() + i, box_of(i)); });
}

PatchBoxes::PatchBoxes(const BezierSurface& surface) {
  levels_.push_back(patch_boxes(surface, [](const RationalBezierPatch&) {}));
  add_blocks();
}

PatchBoxes::PatchBoxes(const BezierSurface& surface, const char* name) {
  validate_frame(surface, name);
  std::atomic<bool> valid = true;
  levels_.push_back(patch_boxes(surface, [&](const RationalBezierPatch& patch) {
    if (!is_valid(patch)) valid.store(false, std::memory_order_relaxed);
  }));
  if (!valid) validate(surface, name);  // tells what is wrong
  add_blocks();
}

void PatchBoxes::add_blocks() {
  while (levels_.back().values().size() > 1) levels_.push_back(blocks_of(levels_.back()));
}

std::vector<std::array<int, 2>> meeting_patches(const PatchBoxes& a, const PatchBoxes& b,
                                                double gap) {
  if (std::max(a.patches().size(), b.patches().size()) > kFewPatches)
    return Meeting(a.levels_, b.levels_, gap).run();
  std::vector<std::array<int, 2>> pairs;
  tree_of(a.patches(), gap).for_each_meeting(tree_of(b.patches(), 0), [&](int i, int j) {
    pairs.push_back({i, j});
  });
  return pairs;
}

}  // namespace blossom
