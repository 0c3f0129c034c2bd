// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/slow_crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/bounds/box_tree.h"
#include "core/cells/cell_pair.h"

namespace blossom {
namespace {

constexpr double kSlowReach = 3;  // roots of tolerance and size: a touch is told within so much
constexpr int kHalvings = 8;      // of a cell, four in each direction

Vec3 normal_of(const Cell& cell) { return cross(cell.du.middle, cell.dv.middle); }

// Seen along the normal of one of their planes, no point of one cell is near one of the other.
bool lie_aside(const Cell& a, const Cell& b, int points_a, int points_b, double gap) {
  const Vec3 n = b.plane.normal == Vec3{} ? a.plane.normal : b.plane.normal;
  for (const Vec3& side : {a.du.middle, a.dv.middle, b.du.middle, b.dv.middle}) {
    const Vec3 across = cross(n, side);
    if (norm(across) > 0 && separated_along(across, a, b, points_a, points_b, gap)) return true;
  }
  return false;
}

struct Part {
  Interval u{1, 0}, v{1, 0};
  Box hull;
};

// Gathers the cells of `tree` below one that are near the other cell.
void gather(CellTree& tree, int index, const Cell& other, int points_other, double gap,
            Part& part) {
  const Cell cell = tree[index];
  const int points = tree.shape().plane_size();
  if (separated(cell, other, points, points_other, gap) ||
      lie_aside(cell, other, points, points_other, gap))
    return;
  if (cell.depth < kHalvings) {
    const int child = tree.split(index);
    gather(tree, child, other, points_other, gap, part);
    gather(tree, child + 1, other, points_other, gap, part);
    return;
  }
  part.u = {std::min(part.u.from, cell.u.from), std::max(part.u.to, cell.u.to)};
  part.v = {std::min(part.v.from, cell.v.from), std::max(part.v.to, cell.v.to)};
  part.hull = joined(part.hull, {cell.low, cell.high});
}

std::optional<Part> part_near(const CellTree& tree, const Cell& cell, const CellTree& other_tree,
                              const Cell& other, double gap) {
  CellTree piece = tree.piece(cell.u, cell.v);
  Part part;
  gather(piece, 0, other, other_tree.shape().plane_size(), gap, part);
  if (part.u.from > part.u.to) return std::nullopt;
  part.u = {at(cell.u, part.u.from), at(cell.u, part.u.to)};
  part.v = {at(cell.v, part.v.from), at(cell.v, part.v.to)};
  return part;
}

}  // namespace

bool cross_slowly(const Cell& a, const Cell& b, double tolerance, double size) {
  const Vec3 na = normal_of(a), nb = normal_of(b);
  const double sine_lengths = norm(cross(na, nb)), lengths = norm(na) * norm(nb);
  return kSlowReach * std::sqrt(size) * sine_lengths < std::sqrt(tolerance) * lengths;
}

bool lie_over(const Cell& a, const Cell& b, int points_a, int points_b, double tolerance) {
  return within_slab(a, b, points_a, points_b, tolerance) &&
         !lie_aside(a, b, points_a, points_b, tolerance);
}

bool are_within(const Cell& a, const Cell& b, int points_a, int points_b, double tolerance) {
  return separated(a, b, points_a, points_b) && lie_over(a, b, points_a, points_b, tolerance);
}

void add_near_part(const std::array<int, 2>& patches, const CellTree& tree_a, const Cell& a,
                   const CellTree& tree_b, const Cell& b, double tolerance,
                   std::vector<CriticalPair>& parts) {
  const auto of_a = part_near(tree_a, a, tree_b, b, tolerance);
  const auto of_b = part_near(tree_b, b, tree_a, a, tolerance);
  if (!of_a || !of_b) return;
  CriticalPair pair{patches[0], patches[1], {of_a->u, of_a->v, of_b->u, of_b->v}, {}, {}, true};
  const Vec3 r{tolerance, tolerance, tolerance};
  pair.low = of_a->hull.low - r;
  pair.high = of_a->hull.high + r;
  for (int k = 0; k < 3; ++k) {
    pair.low[k] = std::max(pair.low[k], of_b->hull.low[k] - tolerance);
    pair.high[k] = std::min(pair.high[k], of_b->hull.high[k] + tolerance);
    if (pair.low[k] > pair.high[k]) return;
  }
  parts.push_back(pair);
}

}  // namespace blossom
