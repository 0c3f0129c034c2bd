// SPDX-License-Identifier: LGPL-2.1-or-later
// A bounding volume hierarchy over boxes, and the pairs of boxes of two of them that meet.

#pragma once

#include <functional>
#include <vector>

#include "core/math/vec.h"

namespace blossom {

/// An axis-parallel box. The empty box has low > high.
struct Box {
  Vec3 low{1e300, 1e300, 1e300};
  Vec3 high{-1e300, -1e300, -1e300};
};

/// True if the boxes have a point in common; borders count.
bool meet(const Box& a, const Box& b);

/// The smallest box that holds both.
Box joined(const Box& a, const Box& b);

/// Length of the diagonal, model units.
double diagonal(const Box& box);

class BoxTree {
 public:
  /// Splits the boxes' centres at their median along the longest axis, down to one box a leaf.
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls `found(i, j)` for every box i of this and j of the other that meet.
  void for_each_meeting(const BoxTree& other, const std::function<void(int, int)>& found) const;

  /// Box of all.
  Box box() const { return nodes_.empty() ? Box{} : nodes_.front().box; }

 private:
  struct Node {
    Box box;
    int left = -1;  // index of a node, or -1
    int right = -1;
    int item = -1;  // the box of a leaf
  };

  int build(const std::vector<Box>& boxes, std::vector<int>& order, int first, int last);
  static void descend(const BoxTree& a, int i, const BoxTree& b, int j,
                      const std::function<void(int, int)>& found);

  std::vector<Node> nodes_;
};

}  // namespace blossom
