// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/cells/surface_cells.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"

namespace blossom {
namespace {

constexpr std::size_t kTreeGrain = 16;  // trees that one thread makes in a row

}  // namespace

SurfaceCells::SurfaceCells(const BezierSurface& surface, const Vec3& origin, CellForm form,
                           double cut, PartTest part)
    : surface_(surface), origin_(origin), form_(form), cut_(cut), part_(std::move(part)) {
  trees_.resize(surface.patches.values().size());
}

CellTree& SurfaceCells::tree(int patch) {
  auto& tree = trees_[static_cast<std::size_t>(patch)];
  if (tree) return *tree;
  PartTest part;
  if (part_)
    part = [this, patch](const Interval& u, const Interval& v) { return part_of(patch, u, v); };
  tree = std::make_unique<CellTree>(surface_.patches.values()[static_cast<std::size_t>(patch)],
                                    surface_.rational, origin_, form_, cut_, std::move(part));
  return *tree;
}

PartSide SurfaceCells::part_of(int patch, const Interval& u, const Interval& v) const {
  const auto own = [](ParameterLaw law, const Interval& span, const Interval& local) {
    return Interval{parameter_at(law, span, local.from), parameter_at(law, span, local.to)};
  };
  return part_(own(surface_.u_law, knots_u(patch), u), own(surface_.v_law, knots_v(patch), v));
}

bool SurfaceCells::outside(int patch, const Interval& u, const Interval& v) const {
  return part_ && part_of(patch, u, v) == PartSide::Outside;
}

bool SurfaceCells::inside(int patch, const Interval& u, const Interval& v) const {
  return !part_ || part_of(patch, u, v) == PartSide::Inside;
}

Interval SurfaceCells::knots_u(int patch) const {
  const auto i = static_cast<std::size_t>(span_u(patch));
  return {surface_.u_knots[i], surface_.u_knots[i + 1]};
}

Interval SurfaceCells::knots_v(int patch) const {
  const auto j = static_cast<std::size_t>(span_v(patch));
  return {surface_.v_knots[j], surface_.v_knots[j + 1]};
}

long SurfaceCells::cells() const {
  return std::accumulate(trees_.begin(), trees_.end(), 0L,
                         [](long sum, const auto& t) { return t ? sum + t->size() : sum; });
}

long SurfaceCells::stored_points() const {
  return std::accumulate(trees_.begin(), trees_.end(), 0L, [](long sum, const auto& t) {
    return t ? sum + static_cast<long>(t->size()) * t->shape().plane_size() : sum;
  });
}

bool SurfaceCells::monomial() const {
  return std::any_of(trees_.begin(), trees_.end(),
                     [](const auto& t) { return t && t->monomial(); });
}

void make_trees(SurfaceCells& a, SurfaceCells& b, const std::vector<StartPair>& pairs) {
  for (int StartPair::*const side : {&StartPair::patch_a, &StartPair::patch_b}) {
    SurfaceCells& cells = side == &StartPair::patch_a ? a : b;
    std::vector<int> patches;
    for (const StartPair& pair : pairs) patches.push_back(pair.*side);
    std::sort(patches.begin(), patches.end());
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    parallel_for(patches.size(), kTreeGrain, [&](std::size_t k) { cells.tree(patches[k]); });
  }
}

}  // namespace blossom
