// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/rays/flat_cell.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/cells/cell_tree.h"
#include "core/forms/evaluation.h"

namespace blossom {
namespace {

// A cell is flat when its derivatives stay this close to their middle, as a part of it.
constexpr double kFlat = 0.2;
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

}  // namespace

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

}  // namespace blossom
