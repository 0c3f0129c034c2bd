// SPDX-License-Identifier: LGPL-2.1-or-later
// A bounding volume hierarchy over boxes, and the pairs of boxes of two of them that meet.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "core/base/unbounded.h"
#include "core/math/vec.h"

namespace blossom {

/// An axis-parallel box. The empty box has low > high.
struct Box {
  Vec3 low{kUnbounded, kUnbounded, kUnbounded};
  Vec3 high{-kUnbounded, -kUnbounded, -kUnbounded};
};

/// True if the boxes have a point in common; borders count.
inline bool meet(const Box& a, const Box& b);

/// The smallest box that holds both.
inline Box joined(const Box& a, const Box& b);

/// Length of the diagonal, model units.
double diagonal(const Box& box);

/// The box with all its sides moved outwards.
Box widened(const Box& box, double by);

/// A piece of a line, from one parameter to another, prepared for many boxes.
struct LineProbe {
  Vec3 origin;
  Vec3 inverse;  ///< 1 / direction, by coordinate; infinite where that is 0
  double from = 0;
  double to = kInfinity;

  LineProbe(const Vec3& start, const Vec3& direction, double first, double last)
      : origin(start), from(first), to(last) {
    for (int k = 0; k < 3; ++k) inverse[k] = 1 / direction[k];
  }

  /// The parameter at which the line enters the box; infinite if it misses. Roundings are on the
  /// safe side: what meets the box is never said to miss it.
  double entry(const Box& box) const;
};

/// Where the lower end of a squared distance lies between two boxes; 0 if they meet.
double squared_distance(const Box& a, const Box& b);
inline double squared_distance(const Box& box, const Vec3& point);

class BoxTree {
 public:
  struct Node {
    Box box;
    int left = -1;  ///< index of a node, or -1
    int right = -1;
    int item = -1;  ///< the box of a leaf
  };

  /// Splits the boxes' centres at their median along the longest axis, down to one box a leaf.
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls `found(i, j)` for every box i of this and j of the other that meet.
  void for_each_meeting(const BoxTree& other, const std::function<void(int, int)>& found) const;

  /// Calls `found(i, j)` once for every two boxes of this that meet, in any order and by several
  /// threads at the same time.
  void for_each_pair(const std::function<void(int, int)>& found) const;

  /// Calls `visit(i, entry)` for the boxes that a line meets, nearer parts of the tree first.
  /// visit     returns the parameter up to which boxes are still wanted
  template <class Visit>
  void for_each_along(LineProbe probe, Visit visit) const;

  /// Calls `visit(i)` for the boxes nearer to a place than a bound, nearer parts first.
  /// place     a point or a box
  /// bound     square of the distance within which boxes are wanted
  /// visit     returns the new bound
  template <class Place, class Visit>
  void for_each_near(const Place& place, double bound, Visit visit) const;

  /// For walks in an order of their own; node 0 is the root.
  const Node& node(int index) const { return nodes_[static_cast<std::size_t>(index)]; }

  /// Box of all.
  Box box() const { return nodes_.empty() ? Box{} : nodes_.front().box; }

 private:
  /// Nodes that wait: halves of the boxes, so the tree is no deeper than this.
  static constexpr int kDeepest = 40;

  struct Building;
  void build(Building& of, int index, int first, int last);
  void pair_below(int index, const std::function<void(int, int)>& found) const;
  static void descend(const BoxTree& a, int i, const BoxTree& b, int j,
                      const std::function<void(int, int)>& found);

  /// Both walks: `measure(box)` orders the nodes, those above `bound` are left out.
  template <class Measure, class Visit>
  void walk(double bound, Measure measure, Visit visit) const;

  std::vector<Node> nodes_;
};

inline bool meet(const Box& a, const Box& b) {
  for (int k = 0; k < 3; ++k)
    if (a.low[k] > b.high[k] || b.low[k] > a.high[k]) return false;
  return true;
}

inline Box joined(const Box& a, const Box& b) {
  Box both;
  for (int k = 0; k < 3; ++k) {
    both.low[k] = b.low[k] < a.low[k] ? b.low[k] : a.low[k];
    both.high[k] = a.high[k] < b.high[k] ? b.high[k] : a.high[k];
  }
  return both;
}

inline double squared_distance(const Box& box, const Vec3& point) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max({0.0, box.low[k] - point[k], point[k] - box.high[k]});
    sum += gap * gap;
  }
  return sum;
}

inline double LineProbe::entry(const Box& box) const {
  double near = from, far = to;
  for (int k = 0; k < 3; ++k) {
    const bool backwards = inverse[k] < 0;
    const double low = ((backwards ? box.high[k] : box.low[k]) - origin[k]) * inverse[k];
    const double high = ((backwards ? box.low[k] : box.high[k]) - origin[k]) * inverse[k];
    // 0 times infinity, a line in a side of the box, is no number and bounds nothing.
    near = low > near ? low : near;
    far = high < far ? high : far;
  }
  // Each side's parameter has three roundings. A line outside and along a side leaves before all.
  const bool meets = near <= far || near - 0x1p-50 * (std::abs(near) + std::abs(far)) < far;
  return meets && far > -kInfinity ? near : kInfinity;
}

template <class Measure, class Visit>
void BoxTree::walk(double bound, Measure measure, Visit visit) const {
  struct Waiting {
    int node;
    double at;
  };
  std::array<Waiting, kDeepest> stack;
  if (nodes_.empty()) return;
  stack[0] = {0, measure(nodes_.front().box)};
  for (int top = stack[0].at < kInfinity ? 1 : 0; top > 0;) {
    const Waiting next = stack[static_cast<std::size_t>(--top)];
    if (next.at > bound) continue;
    const Node& node = nodes_[static_cast<std::size_t>(next.node)];
    if (node.item >= 0) {
      bound = visit(node.item, next.at);
      continue;
    }
    Waiting nearer{node.left, measure(nodes_[static_cast<std::size_t>(node.left)].box)};
    Waiting farther{node.right, measure(nodes_[static_cast<std::size_t>(node.right)].box)};
    if (farther.at < nearer.at) std::swap(nearer, farther);
    for (const Waiting& child : {farther, nearer})
      if (child.at <= bound && child.at < kInfinity) stack[static_cast<std::size_t>(top++)] = child;
  }
}

template <class Visit>
void BoxTree::for_each_along(LineProbe probe, Visit visit) const {
  walk(
      probe.to, [&probe](const Box& box) { return probe.entry(box); },
      [&](int item, double entry) {
        const double wanted = visit(item, entry);
        probe.to = std::min(probe.to, wanted);
        return wanted;
      });
}

template <class Place, class Visit>
void BoxTree::for_each_near(const Place& place, double bound, Visit visit) const {
  walk(
      bound, [&place](const Box& box) { return squared_distance(box, place); },
      [&](int item, double) { return visit(item); });
}

}  // namespace blossom
