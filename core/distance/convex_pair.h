// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of cells over which the square of the distance is convex: its least value is known at once.
//
// Halving alone brings the bounds of a pair together with the square of the cells' size. Where all
// second derivatives of f = |A - B|^2 / 2 within the cells' bounds are positive definite, f lies
// above its tangent plane at any point of the pair. Where it is least in the pair that plane does
// not fall towards any other point of it, so its value is the bound, and nothing is left to halve.

#pragma once

#include "core/cells/cell_tree.h"
#include "core/distance/nearest_pair.h"

namespace blossom {

/// A cell with what it is a cell of. The patch is not relative to any origin.
struct CellOf {
  const Cell* cell = nullptr;
  NetShape shape;
  PatchOf form;
};

/// A bound below the distance of any two points of the cells, by the tangent plane of f where it is
/// least in them; model units, roundings included. 0 unless f is proven to be convex.
///
///   f(x) >= f(x0) + grad f(x0) . (x - x0)
///
/// at_a, at_b   where the search for x0 starts, parameters of the patches, inside of the cells
/// enough       a bound that need not be made any better, model units
/// rounding     of the distance of two points of the patches, model units
double convex_bound(const CellOf& a, const CellOf& b, const Vec2& at_a, const Vec2& at_b,
                    double enough, double rounding);

}  // namespace blossom
