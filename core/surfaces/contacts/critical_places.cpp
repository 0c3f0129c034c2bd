// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/critical_places.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/base/not_zero.h"

namespace blossom {
namespace {

constexpr std::size_t kManyPairs = 4000;  // above this, pairs are gathered over a grid
constexpr int kGridCells = 64;            // per axis

Box box_of(const CriticalPair& pair) { return {pair.low, pair.high}; }

void join_meeting(const std::vector<CriticalPair>& pairs, DisjointSets& sets) {
  std::vector<Box> boxes;
  for (const CriticalPair& pair : pairs) boxes.push_back(box_of(pair));
  const BoxTree tree(boxes);
  tree.for_each_meeting(tree, [&](int i, int j) {
    if (i < j) sets.join(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  });
}

// Marks the grid cells that boxes cover and joins pairs in equal or neighbouring cells. These are
// not smaller than boxes are in the cubic mean, so a box covers but a few of them on average.
void join_over_grid(const std::vector<CriticalPair>& pairs, DisjointSets& sets) {
  Box all;
  for (const CriticalPair& pair : pairs) all = joined(all, box_of(pair));
  const double whole = std::max(diagonal(all), kNotZero);
  double cubes = 0;
  for (const CriticalPair& pair : pairs) cubes += std::pow(diagonal(box_of(pair)) / whole, 3);
  const double mean = std::cbrt(cubes / static_cast<double>(pairs.size()));
  const double step = whole * std::max(1.0 / kGridCells, mean);
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

}  // namespace

std::vector<CriticalCluster> clusters_of(const std::vector<CriticalPair>& pairs) {
  DisjointSets sets(pairs.size());
  if (pairs.size() > kManyPairs)
    join_over_grid(pairs, sets);
  else
    join_meeting(pairs, sets);
  std::map<std::size_t, std::size_t> place;
  std::vector<CriticalCluster> clusters;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [found, added] = place.try_emplace(sets.find(i), clusters.size());
    if (added) clusters.emplace_back();
    CriticalCluster& cluster = clusters[found->second];
    cluster.pairs.push_back(static_cast<int>(i));
    cluster.box = joined(cluster.box, box_of(pairs[i]));
    cluster.within_tolerance = cluster.within_tolerance && pairs[i].within_tolerance;
    cluster.singular = cluster.singular || pairs[i].singular;
  }
  return clusters;
}

void join_singular(std::vector<CriticalCluster>& clusters, double tolerance) {
  // Most of the clusters are near nothing: an emptied one waits for the end of all passes.
  for (bool grown = true; grown;) {
    grown = false;
    for (CriticalCluster& to : clusters) {
      if (!to.singular || to.pairs.empty()) continue;
      for (CriticalCluster& from : clusters) {
        if (&from == &to || from.pairs.empty()) continue;
        if (!meet(widened(to.box, diagonal(to.box) + tolerance), from.box)) continue;
        to.pairs.insert(to.pairs.end(), from.pairs.begin(), from.pairs.end());
        to.box = joined(to.box, from.box);
        to.within_tolerance = to.within_tolerance && from.within_tolerance;
        from.pairs.clear();
        grown = true;
      }
    }
  }
  std::erase_if(clusters, [](const CriticalCluster& cluster) { return cluster.pairs.empty(); });
}

bool meets_border(const CriticalCluster& cluster, const std::vector<CriticalPair>& pairs) {
  return std::ranges::any_of(cluster.pairs, [&](int i) {
    const CriticalPair& pair = pairs[static_cast<std::size_t>(i)];
    return std::ranges::any_of(pair.box,
                               [](const Interval& t) { return t.from <= 0 || t.to >= 1; });
  });
}

bool holds_area(const CriticalCluster& cluster, const std::vector<CriticalPair>& pairs) {
  constexpr double kWidth = 1e-6;  // of a patch
  return std::ranges::any_of(cluster.pairs, [&](int i) {
    const CriticalPair& pair = pairs[static_cast<std::size_t>(i)];
    return pair.shared && length(pair.box[0]) > kWidth && length(pair.box[1]) > kWidth;
  });
}

}  // namespace blossom
