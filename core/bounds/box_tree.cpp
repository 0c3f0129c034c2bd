// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/bounds/box_tree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "core/base/parallel.h"

namespace blossom {
namespace {

constexpr int kAlone = 1024;  // so few boxes are one thread's work

}  // namespace

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

// The boxes in the order of the leaves, and their centres, doubled, by axis.
struct BoxTree::Building {
  const std::vector<Box>& boxes;
  std::vector<int> order;
  std::array<std::vector<double>, 3> centres;
};

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  Building of{boxes, std::vector<int>(boxes.size()), {}};
  std::iota(of.order.begin(), of.order.end(), 0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int k = static_cast<int>(axis);
    for (const Box& box : boxes) of.centres[axis].push_back(box.low[k] + box.high[k]);
  }
  nodes_.resize(2 * boxes.size() - 1);
  build(of, 0, 0, static_cast<int>(boxes.size()));
}

// The halves of n leaves have 2 n - 1 nodes together with the node above them; the left ones follow
// it, then the right ones.
void BoxTree::build(Building& of, int index, int first, int last) {
  Node& node = nodes_[static_cast<std::size_t>(index)];
  for (int i = first; i < last; ++i)
    node.box =
        joined(node.box, of.boxes[static_cast<std::size_t>(of.order[static_cast<std::size_t>(i)])]);
  if (last - first == 1) {
    node.item = of.order[static_cast<std::size_t>(first)];
    return;
  }
  const Vec3 size = node.box.high - node.box.low;
  const std::size_t axis = size[0] >= size[1] && size[0] >= size[2] ? 0
                           : size[1] >= size[2]                     ? 1
                                                                    : 2;
  const int middle = first + (last - first) / 2;
  const double* const centre = of.centres[axis].data();
  std::nth_element(of.order.begin() + first, of.order.begin() + middle, of.order.begin() + last,
                   [centre](int i, int j) { return centre[i] < centre[j]; });
  node.left = index + 1;
  node.right = index + 2 * (middle - first);
  const auto build_half = [&](std::size_t half) {
    half == 0 ? build(of, node.left, first, middle) : build(of, node.right, middle, last);
  };
  if (last - first > kAlone) {
    parallel_for(2, 1, build_half);
  } else {
    build_half(0);
    build_half(1);
  }
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

void BoxTree::for_each_pair(const std::function<void(int, int)>& found) const {
  if (!nodes_.empty()) pair_below(0, found);
}

// Pairs of the left half, of the right one, and of a box of each.
void BoxTree::pair_below(int index, const std::function<void(int, int)>& found) const {
  const Node& node = this->node(index);
  if (node.item >= 0) return;
  const auto pair_part = [&](std::size_t part) {
    if (part == 0) descend(*this, node.left, *this, node.right, found);
    if (part == 1) pair_below(node.left, found);
    if (part == 2) pair_below(node.right, found);
  };
  if (node.right - index > kAlone) {  // the left half has half as many boxes
    parallel_for(3, 1, pair_part);
  } else {
    for (std::size_t part = 0; part < 3; ++part) pair_part(part);
  }
}

}  // namespace blossom
