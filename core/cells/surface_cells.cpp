// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/surface_cells.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/base/parallel.h"

namespace blossom {
namespace {

constexpr std::size_t kTreeGrain = 16;  // trees that one thread makes or empties in a row

}  // namespace

SurfaceCells::SurfaceCells(const BezierSurface& surface, const Vec3& origin, CellForm form,
                           double cut, PartTest part)
    : surface_(surface), origin_(origin), form_(form), cut_(cut), part_(std::move(part)) {
  trees_.resize(surface.patches.values().size());
}

CellTree& SurfaceCells::tree(int patch) {
  auto& tree = trees_[static_cast<std::size_t>(patch)];
  if (!tree) {
    tree = made_tree(patch);
    made_.push_back(patch);
  }
  return *tree;
}

void SurfaceCells::make_trees(const std::vector<int>& patches) {
  std::vector<int> missing;
  for (const int patch : patches)
    if (!trees_[static_cast<std::size_t>(patch)]) missing.push_back(patch);
  parallel_for(missing.size(), kTreeGrain, [&](std::size_t k) {
    trees_[static_cast<std::size_t>(missing[k])] = made_tree(missing[k]);
  });
  made_.insert(made_.end(), missing.begin(), missing.end());
}

void SurfaceCells::drop_cells() {
  parallel_for(made_.size(), kTreeGrain,
               [&](std::size_t k) { trees_[static_cast<std::size_t>(made_[k])]->drop_cells(); });
}

std::unique_ptr<CellTree> SurfaceCells::made_tree(int patch) const {
  PartTest part;
  if (part_)
    part = [this, patch](const Interval& u, const Interval& v) { return part_of(patch, u, v); };
  return std::make_unique<CellTree>(surface_.patches.values()[static_cast<std::size_t>(patch)],
                                    surface_.rational, origin_, form_, cut_, std::move(part));
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
  long sum = 0;
  for (const int patch : made_) sum += trees_[static_cast<std::size_t>(patch)]->size();
  return sum;
}

long SurfaceCells::stored_points() const {
  long sum = 0;
  for (const int patch : made_) {
    const CellTree& tree = *trees_[static_cast<std::size_t>(patch)];
    sum += static_cast<long>(tree.size()) * tree.shape().plane_size();
  }
  return sum;
}

bool SurfaceCells::monomial() const {
  return std::ranges::any_of(
      made_, [&](int patch) { return trees_[static_cast<std::size_t>(patch)]->monomial(); });
}

}  // namespace blossom
