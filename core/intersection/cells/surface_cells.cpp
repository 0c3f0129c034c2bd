// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/cells/surface_cells.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"

namespace blossom {
namespace {

constexpr int kPatchesAlone = 1024;     // boxes of so few patches are one thread's work
constexpr std::size_t kTreeGrain = 16;  // trees that one thread makes in a row

Box hull_box(const RationalBezierPatch& patch) {
  Box box;
  for (const Vec4& p : patch.points.values()) {
    const Vec3 x = projected(p);
    box = joined(box, {x, x});
  }
  return box;
}

// With as much rounding as cells allow for themselves.
std::vector<Box> patch_boxes(const BezierSurface& surface) {
  constexpr double kRounding = 16 * 0x1p-53;
  std::vector<Box> boxes;
  boxes.reserve(surface.patches.values().size());
  for (const RationalBezierPatch& patch : surface.patches.values()) {
    const Box box = hull_box(patch);
    boxes.push_back(widened(box, kRounding * std::max(max_norm(box.low), max_norm(box.high))));
  }
  return boxes;
}

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

bool SurfaceCells::outside(int patch, double u, double v) const {
  return part_ && part_of(patch, {u, u}, {v, v}) == PartSide::Outside;
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

Box hull_box(const BezierSurface& surface) {
  Box box;
  for (const RationalBezierPatch& patch : surface.patches.values())
    box = joined(box, hull_box(patch));
  return box;
}

std::vector<std::array<int, 2>> meeting_patches(SurfaceCells& a, SurfaceCells& b) {
  const auto both = [&](std::size_t i) -> SurfaceCells& { return i == 0 ? a : b; };
  std::array<BoxTree, 2> boxes{BoxTree({}), BoxTree({})};
  parallel_for(2, a.patches() + b.patches() > kPatchesAlone ? 1 : 2,
               [&](std::size_t i) { boxes[i] = BoxTree(patch_boxes(both(i).surface())); });
  std::vector<std::array<int, 2>> pairs;
  boxes[0].for_each_meeting(boxes[1], [&](int i, int j) { pairs.push_back({i, j}); });
  std::array<std::vector<int>, 2> met;
  for (std::size_t side = 0; side < 2; ++side) {
    for (const auto& pair : pairs) met[side].push_back(pair[side]);
    std::sort(met[side].begin(), met[side].end());
    met[side].erase(std::unique(met[side].begin(), met[side].end()), met[side].end());
    parallel_for(met[side].size(), kTreeGrain,
                 [&](std::size_t k) { both(side).tree(met[side][k]); });
  }
  return pairs;
}

}  // namespace blossom
