// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/rays/flat_cells.h"

#include <algorithm>
#include <bit>
#include <mutex>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/math/roundoff.h"
#include "core/rays/patch_cells.h"

namespace blossom {
namespace {

// Halvings of a patch that is nowhere flat, as at a pole; searches go on from there. Fewer where
// there are many patches, so that their cells stay below `kMaxCells` in all, but `kLeastDepth`.
// Choices.
constexpr int kMostDepth = 12;
constexpr int kLeastDepth = 4;
constexpr std::size_t kMaxCells = std::size_t{1} << 22;
// Of a control point's quotient, as a part of the largest coordinate.
constexpr double kBoxRounding = 0x1p-52;

int deepest_of(std::size_t patches) {
  const int depth =
      static_cast<int>(std::bit_width(kMaxCells / std::max<std::size_t>(patches, 1))) - 1;
  return std::clamp(depth, kLeastDepth, kMostDepth);
}

Box box_of(const RationalBezierPatch& patch) {
  Box box;
  for (const Vec4& p : patch.points.values()) {
    const Vec3 point{p[0] / p[3], p[1] / p[3], p[2] / p[3]};
    box = joined(box, {point, point});
  }
  return box;
}

}  // namespace

struct FlatCells::Made {
  std::once_flag once;
  std::unique_ptr<PatchCells> cells;
};

FlatCells::~FlatCells() = default;
FlatCells::FlatCells(FlatCells&&) noexcept = default;

FlatCells::FlatCells(std::vector<BezierSurface> surfaces, double smallest,
                     std::vector<double> reaches)
    : surfaces_(std::move(surfaces)), reaches_(std::move(reaches)), smallest_(smallest) {
  if (surfaces_.empty()) throw InvalidInput("FlatCells: there is no surface");
  if (reaches_.empty()) reaches_.assign(surfaces_.size(), smallest);
  if (reaches_.size() != surfaces_.size())
    throw InvalidInput("FlatCells: " + std::to_string(surfaces_.size()) + " surfaces, but " +
                       std::to_string(reaches_.size()) + " reaches");
  std::size_t count = 0;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    validate(surfaces_[i], ("number " + std::to_string(i)).c_str());
    count += surfaces_[i].patches.values().size();
  }
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    for (int row = 0; row < surfaces_[i].patches.rows(); ++row)
      for (int column = 0; column < surfaces_[i].patches.columns(); ++column)
        add_patch(static_cast<int>(i), row, column);
  deepest_ = deepest_of(count);
  made_ = std::make_unique<Made[]>(count);
}

void FlatCells::add_patch(int surface, int row, int column) {
  const BezierSurface& owner = surfaces_[static_cast<std::size_t>(surface)];
  const RationalBezierPatch& patch = owner.patches(row, column);
  PlacedPatch placed;
  placed.patch = &patch;
  placed.surface = surface;
  placed.row = row;
  placed.column = column;
  placed.ends_low = {!owner.closed_u && row == 0, !owner.closed_v && column == 0};
  placed.ends_high = {!owner.closed_u && row + 1 == owner.patches.rows(),
                      !owner.closed_v && column + 1 == owner.patches.columns()};
  placed.reach = reaches_[static_cast<std::size_t>(surface)];
  const auto weights =
      std::minmax_element(patch.points.values().begin(), patch.points.values().end(),
                          [](const Vec4& a, const Vec4& b) { return a[3] < b[3]; });
  placed.least_weight = (*weights.first)[3];
  placed.largest_weight = (*weights.second)[3];
  const int points = patch.points.rows() * patch.points.columns();
  largest_net_ = std::max(largest_net_, points);
  // Weights of degree n carry 3 n roundings, sums one each, the quotient one.
  const double roundings = 4.0 * (patch.degree_u() + patch.degree_v()) + 12;
  evaluation_error_ = std::max(evaluation_error_, 2 * roundings * kUnitRoundoff);
  const Box box = box_of(patch);
  const double largest = std::max(max_norm(box.low), max_norm(box.high));
  scale_ = std::max(scale_, largest);
  boxes_.push_back(widened(box, placed.reach + kBoxRounding * largest));
  patches_.push_back(placed);
}

PatchCells& FlatCells::cells_of(int patch) const {
  const auto index = static_cast<std::size_t>(patch);
  Made& made = made_[index];
  std::call_once(made.once, [&] {
    const PlacedPatch& placed = patches_[index];
    const bool rational = surfaces_[static_cast<std::size_t>(placed.surface)].rational;
    made.cells = std::make_unique<PatchCells>(
        *placed.patch, rational, PatchCells::Options{patch, placed.reach, smallest_, deepest_});
  });
  return *made.cells;
}

Vec2 FlatCells::parameters(int patch, const Vec2& local) const {
  const PlacedPatch& placed = patches_[static_cast<std::size_t>(patch)];
  const BezierSurface& surface = surfaces_[static_cast<std::size_t>(placed.surface)];
  const auto row = static_cast<std::size_t>(placed.row);
  const auto column = static_cast<std::size_t>(placed.column);
  return {parameter_at(surface.u_law, {surface.u_knots[row], surface.u_knots[row + 1]}, local[0]),
          parameter_at(surface.v_law, {surface.v_knots[column], surface.v_knots[column + 1]},
                       local[1])};
}

}  // namespace blossom
