// SPDX-License-Identifier: LGPL-2.1-or-later
// Parts of cells that are not cells of the tree.

#pragma once

#include "core/cells/cell_tree.h"
#include "core/cells/known_curves.h"

namespace blossom {

/// A part of a cell, with a box and derivatives of its own; the rest is the cell's.
///
/// u, v   fractions of the cell
Cell part_of(const CellTree& tree, const Cell& cell, const Interval& u, const Interval& v);

/// True if what the cell has in common with a box is seen to lie beside known curves: along a curve
/// that runs askew the cell's box alone is too large to tell.
bool is_known(const KnownCurves& known, const CellTree& tree, const Cell& cell, const Box& box);

}  // namespace blossom
