// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/rays/flat_cells.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/cells/cell_tree.h"
#include "core/cells/limits.h"
#include "core/forms/evaluation.h"

namespace blossom {
namespace {

// A cell is flat when its derivatives stay this close to their middle, as a part of it.
constexpr double kFlat = 0.2;
// Halvings of a patch that is nowhere flat, as at a pole; searches go on from there.
constexpr int kDeepest = 12;
// Cells of one patch, however many patches there are; and of all patches that are curved alike.
constexpr std::size_t kMinCells = 16;
constexpr std::size_t kMaxCells = 1'000'000;
// A rounding of each of the few operations that make a bound.
constexpr double kSlack = 1 + 1e-12;

double absolute_product(const Vec3& a, const Vec3& b) {
  return kSlack * (std::abs(a[0]) * b[0] + std::abs(a[1]) * b[1] + std::abs(a[2]) * b[2]);
}

double bound_of_length(const VectorBounds& bounds) {
  Vec3 most;
  for (int k = 0; k < 3; ++k) most[k] = std::abs(bounds.middle[k]) + bounds.radius[k];
  return kSlack * norm(most);
}

FlatCell flat_cell(const Cell& cell, const RationalBezierPatch& patch) {
  FlatCell flat;
  flat.u = cell.u;
  flat.v = cell.v;
  flat.centre = jet_at(patch, at(cell.u, 0.5), at(cell.v, 0.5), 1).point;
  flat.reach = {bound_of_length(cell.du), bound_of_length(cell.dv)};
  const Vec3 area = cross(cell.du.middle, cell.dv.middle);
  const double square = dot(area, area);
  if (!(square > 0) || !std::isfinite(1 / square)) return flat;
  flat.normal = unit(area);
  flat.dual = {cross(cell.dv.middle, area) * (1 / square),
               cross(area, cell.du.middle) * (1 / square)};
  const std::array<const VectorBounds*, 2> derivatives{&cell.du, &cell.dv};
  for (std::size_t j = 0; j < 2; ++j) {
    flat.dual_length[j] = norm(flat.dual[j]);
    flat.tilt[j] = absolute_product(flat.normal, derivatives[j]->radius);
    for (std::size_t i = 0; i < 2; ++i)
      flat.spread[i][j] = absolute_product(flat.dual[i], derivatives[j]->radius);
  }
  flat.regular = is_contraction(flat.spread);
  return flat;
}

bool is_flat(const FlatCell& cell) {
  const double steepest = std::max(cell.dual_length[0], cell.dual_length[1]);
  return cell.regular && cell.spread[0][0] + cell.spread[0][1] <= kFlat &&
         cell.spread[1][0] + cell.spread[1][1] <= kFlat &&
         steepest * std::max(cell.tilt[0], cell.tilt[1]) <= kFlat;
}

}  // namespace

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
  most_cells_ = std::max(kMinCells, kMaxCells / count);
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    for (int row = 0; row < surfaces_[i].patches.rows(); ++row)
      for (int column = 0; column < surfaces_[i].patches.columns(); ++column)
        add_patch(static_cast<int>(i), row, column);
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
  for (const Vec4& p : patch.points.values())
    scale_ =
        std::max({scale_, std::abs(p[0] / p[3]), std::abs(p[1] / p[3]), std::abs(p[2] / p[3])});
  const int points = patch.points.rows() * patch.points.columns();
  largest_net_ = std::max(largest_net_, points);
  // Weights of degree n carry 3 n roundings, sums one each, the quotient one.
  const double roundings = 4.0 * (patch.degree_u() + patch.degree_v()) + 12;
  evaluation_error_ = std::max(evaluation_error_, 2 * roundings * 0x1p-53);

  // Halved off the middle: poles and symmetries of models lie on dyadic lines.
  CellTree tree(patch, owner.rational, Vec3{}, CellForm::Bezier, kOffMiddle);
  std::vector<int> open{0};
  for (std::size_t next = 0, found = 0; next < open.size(); ++next) {
    const Cell cell = tree[open[next]];
    FlatCell flat = flat_cell(cell, patch);
    const bool settled = is_flat(flat) || cell.depth >= kDeepest || cell.extent <= smallest_ ||
                         found + (open.size() - next) >= most_cells_;
    if (!settled) {
      const int low = tree.split(open[next]);
      open.insert(open.end(), {low, low + 1});
      continue;
    }
    ++found;
    flat.patch = static_cast<int>(patches_.size());
    cells_.push_back(flat);
    boxes_.push_back({cell.low, cell.high});
  }
  patches_.push_back(placed);
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
