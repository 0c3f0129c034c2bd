// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/search/start_pairs.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/base/parallel.h"
#include "core/cells/cell_pair.h"

namespace blossom {
namespace {

constexpr std::size_t kBoxGrain = 128;  // that one thread compares in a row

void make_trees(SurfaceCells& cells, const std::vector<StartPair>& pairs, int StartPair::*patch) {
  std::vector<char> named(static_cast<std::size_t>(cells.patches()), 0);
  std::vector<int> patches;
  for (const StartPair& pair : pairs)
    if (!std::exchange(named[static_cast<std::size_t>(pair.*patch)], 1))
      patches.push_back(pair.*patch);
  cells.make_trees(patches);
}

}  // namespace

bool are_apart(const CellTree& tree_a, const Cell& a, const CellTree& tree_b, const Cell& b,
               double gap) {
  return a.part == PartSide::Outside || b.part == PartSide::Outside ||
         separated(a, b, tree_a.shape().plane_size(), tree_b.shape().plane_size(), gap);
}

NearPairs near_pairs(SurfaceCells& a, SurfaceCells& b, const std::vector<StartPair>& pairs,
                     double gap) {
  make_trees(a, pairs, &StartPair::patch_a);
  make_trees(b, pairs, &StartPair::patch_b);
  std::vector<char> apart(pairs.size());
  parallel_for(pairs.size(), kBoxGrain, [&](std::size_t i) {
    const CellTree &tree_a = a.tree(pairs[i].patch_a), &tree_b = b.tree(pairs[i].patch_b);
    apart[i] = are_apart(tree_a, tree_a[pairs[i].cell_a], tree_b, tree_b[pairs[i].cell_b], gap);
  });
  NearPairs near;
  Certificate& certificate = near.certificate;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!apart[i]) {
      near.pairs.push_back(pairs[i]);
      continue;
    }
    const Cell& cell_a = a.tree(pairs[i].patch_a)[pairs[i].cell_a];
    const Cell& cell_b = b.tree(pairs[i].patch_b)[pairs[i].cell_b];
    ++certificate.excluded;
    certificate.depth = std::max({certificate.depth, cell_a.depth, cell_b.depth});
    certificate.rounding_bound =
        std::max({certificate.rounding_bound, cell_a.margin, cell_b.margin});
  }
  return near;
}

}  // namespace blossom
