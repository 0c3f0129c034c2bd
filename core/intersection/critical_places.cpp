// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/critical_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/forms/evaluation.h"

namespace blossom {
namespace {

constexpr std::size_t kManyPairs = 4000;  // above this, pairs are gathered over a grid
constexpr int kGridCells = 64;            // per axis
constexpr int kNewtonSteps = 20;
constexpr double kSettled = 1e-12;  // fraction of a patch

class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[find(i)] = find(j); }

 private:
  std::vector<std::size_t> parent_;
};

Box box_of(const CriticalPair& pair) { return {pair.low, pair.high}; }

void join_meeting(const std::vector<CriticalPair>& pairs, Sets& sets) {
  std::vector<Box> boxes;
  for (const CriticalPair& pair : pairs) boxes.push_back(box_of(pair));
  const BoxTree tree(boxes);
  tree.for_each_meeting(tree, [&](int i, int j) {
    if (i < j) sets.join(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  });
}

// Marks the grid cells that boxes cover and joins pairs in equal or neighbouring cells.
void join_over_grid(const std::vector<CriticalPair>& pairs, Sets& sets) {
  Box all;
  for (const CriticalPair& pair : pairs) all = joined(all, box_of(pair));
  const double step = std::max(diagonal(all) / kGridCells, 1e-300);
  std::map<std::array<int, 3>, std::size_t> first_in_cell;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::array<int, 3> from, to;
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      from[axis] = static_cast<int>((pairs[i].low[k] - all.low[k]) / step);
      to[axis] = static_cast<int>((pairs[i].high[k] - all.low[k]) / step) + 1;
    }
    for (int x = from[0]; x <= to[0]; ++x)
      for (int y = from[1]; y <= to[1]; ++y)
        for (int z = from[2]; z <= to[2]; ++z) {
          const auto [place, added] = first_in_cell.try_emplace({x, y, z}, i);
          if (!added) sets.join(i, place->second);
        }
  }
}

// Gaussian elimination with partial pivoting; false if singular.
bool solve4(std::array<std::array<double, 5>, 4>& m) {
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < 4; ++r)
      if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
    if (m[pivot][c] == 0) return false;
    std::swap(m[c], m[pivot]);
    for (std::size_t r = 0; r < 4; ++r) {
      if (r == c) continue;
      const double factor = m[r][c] / m[c][c];
      for (std::size_t k = c; k < 5; ++k) m[r][k] -= factor * m[c][k];
    }
  }
  for (std::size_t r = 0; r < 4; ++r) m[r][4] /= m[r][r];
  return true;
}

}  // namespace

std::vector<Clump> clumps_of(const std::vector<CriticalPair>& pairs) {
  Sets sets(pairs.size());
  if (pairs.size() > kManyPairs)
    join_over_grid(pairs, sets);
  else
    join_meeting(pairs, sets);
  std::map<std::size_t, std::size_t> place;
  std::vector<Clump> clumps;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [found, added] = place.try_emplace(sets.find(i), clumps.size());
    if (added) clumps.emplace_back();
    Clump& clump = clumps[found->second];
    clump.pairs.push_back(static_cast<int>(i));
    clump.box = joined(clump.box, box_of(pairs[i]));
    clump.thin = clump.thin && pairs[i].thin;
  }
  return clumps;
}

std::optional<Point4> collinear_normal_point(const RationalBezierPatch& a,
                                             const RationalBezierPatch& b, const Point4& start,
                                             const Box4& box) {
  Point4 x = start;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const PatchJet p = jet_at(a, x[0], x[1], 2), q = jet_at(b, x[2], x[3], 2);
    const Vec3 f = p.point - q.point, n = cross(q.u, q.v);
    const Vec3 ns = cross(q.uu, q.v) + cross(q.u, q.uv), nt = cross(q.uv, q.v) + cross(q.u, q.vv);
    std::array<std::array<double, 5>, 4> m{{
        {dot(p.u, q.u), dot(p.v, q.u), dot(f, q.uu) - dot(q.u, q.u), dot(f, q.uv) - dot(q.v, q.u),
         -dot(f, q.u)},
        {dot(p.u, q.v), dot(p.v, q.v), dot(f, q.uv) - dot(q.u, q.v), dot(f, q.vv) - dot(q.v, q.v),
         -dot(f, q.v)},
        {dot(p.uu, n), dot(p.uv, n), dot(p.u, ns), dot(p.u, nt), -dot(p.u, n)},
        {dot(p.uv, n), dot(p.vv, n), dot(p.v, ns), dot(p.v, nt), -dot(p.v, n)},
    }};
    if (!solve4(m)) return std::nullopt;
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] += m[i][4];
      const double width = length(box[i]);
      if (!(x[i] > box[i].from - width && x[i] < box[i].to + width)) return std::nullopt;
      largest = std::max(largest, std::abs(m[i][4]));
    }
    if (largest < kSettled) return x;
  }
  return std::nullopt;
}

}  // namespace blossom
