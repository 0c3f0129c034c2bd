// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/cell_part.h"

namespace blossom {
namespace {

constexpr int kHalvings = 5;

bool is_known(const KnownCurves& known, const CellTree& tree, const Cell& cell, const Box& box,
              int halvings) {
  const Box own{cell.low, cell.high};
  if (!meet(own, box) || known.hold_common(own, box)) return true;
  if (halvings == 0) return false;
  const bool halve_u = norm(cell.du.middle) >= norm(cell.dv.middle);
  const Interval whole{0, 1}, low{0, 0.5}, high{0.5, 1};
  const auto half = [&](const Interval& side) {
    return is_known(known, tree,
                    part_of(tree, cell, halve_u ? side : whole, halve_u ? whole : side), box,
                    halvings - 1);
  };
  return half(low) && half(high);
}

}  // namespace

Cell part_of(const CellTree& tree, const Cell& cell, const Interval& u, const Interval& v) {
  Cell part = cell;
  part.u = {at(cell.u, u.from), at(cell.u, u.to)};
  part.v = {at(cell.v, v.from), at(cell.v, v.to)};
  const CellTree cells = tree.piece(part.u, part.v);
  part.low = cells[0].low;
  part.high = cells[0].high;
  part.du = cells[0].du;
  part.dv = cells[0].dv;
  return part;
}

bool is_known(const KnownCurves& known, const CellTree& tree, const Cell& cell, const Box& box) {
  return !known.empty() && is_known(known, tree, cell, box, kHalvings);
}

}  // namespace blossom
