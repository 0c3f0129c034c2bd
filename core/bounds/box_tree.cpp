// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/bounds/box_tree.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace blossom {

bool meet(const Box& a, const Box& b) {
  for (int k = 0; k < 3; ++k)
    if (a.low[k] > b.high[k] || b.low[k] > a.high[k]) return false;
  return true;
}

Box joined(const Box& a, const Box& b) {
  Box both;
  for (int k = 0; k < 3; ++k) {
    both.low[k] = std::min(a.low[k], b.low[k]);
    both.high[k] = std::max(a.high[k], b.high[k]);
  }
  return both;
}

double diagonal(const Box& box) {
  return box.low[0] > box.high[0] ? 0 : distance(box.low, box.high);
}

Box widened(const Box& box, double by) {
  const Vec3 move{by, by, by};
  return {box.low - move, box.high + move};
}

double squared_distance(const Box& a, const Box& b) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max({0.0, a.low[k] - b.high[k], b.low[k] - a.high[k]});
    sum += gap * gap;
  }
  return sum;
}

double squared_distance(const Box& box, const Vec3& point) {
  return squared_distance(box, Box{point, point});
}

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  if (!boxes.empty()) build(boxes, order, 0, static_cast<int>(boxes.size()));
}

int BoxTree::build(const std::vector<Box>& boxes, std::vector<int>& order, int first, int last) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back({});
  Box box;
  for (int i = first; i < last; ++i)
    box = joined(box, boxes[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])]);
  Node node{box, -1, -1, -1};
  if (last - first == 1) {
    node.item = order[static_cast<std::size_t>(first)];
  } else {
    const Vec3 size = box.high - box.low;
    const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    const int middle = first + (last - first) / 2;
    const auto centre = [&](int i) {
      const Box& b = boxes[static_cast<std::size_t>(i)];
      return b.low[axis] + b.high[axis];
    };
    std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last,
                     [&](int i, int j) { return centre(i) < centre(j); });
    node.left = build(boxes, order, first, middle);
    node.right = build(boxes, order, middle, last);
  }
  nodes_[static_cast<std::size_t>(index)] = node;
  return index;
}

void BoxTree::descend(const BoxTree& a, int i, const BoxTree& b, int j,
                      const std::function<void(int, int)>& found) {
  const Node& p = a.nodes_[static_cast<std::size_t>(i)];
  const Node& q = b.nodes_[static_cast<std::size_t>(j)];
  if (!meet(p.box, q.box)) return;
  if (p.item >= 0 && q.item >= 0) {
    found(p.item, q.item);
  } else if (q.item >= 0 || (p.item < 0 && diagonal(p.box) >= diagonal(q.box))) {
    descend(a, p.left, b, j, found);
    descend(a, p.right, b, j, found);
  } else {
    descend(a, i, b, q.left, found);
    descend(a, i, b, q.right, found);
  }
}

void BoxTree::for_each_meeting(const BoxTree& other,
                               const std::function<void(int, int)>& found) const {
  if (!nodes_.empty() && !other.nodes_.empty()) descend(*this, 0, other, 0, found);
}

}  // namespace blossom
