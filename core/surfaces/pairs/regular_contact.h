// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts that are none: the surfaces cross there, though no pair of cells could be certified.
//
// Where a curve passes a point that is a corner of patches of both surfaces, or runs along a knot
// line close to one, every pair of cells has it on its border, and where the surfaces cross at a
// small angle rounding leaves open on which side. The cells beside the corner together settle it.
// Where a curve runs along a knot line, both its sides together do.

#pragma once

#include <span>

#include "core/cells/surface_cells.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// True if the zeros of F = A - B near these pairs of cells are proven to be arcs that run on to
/// other pairs, with no loop and no branching: two ends of arcs that lead there are one arc's, and
/// where there is no end, there is nothing.
///
///   One minor of J is regular for all matrices within common bounds of the derivatives over a
///   rectangle of each surface that holds all of the pairs inside it. Patches that meet there are
///   one continuous surface, so F is Lipschitz and Clarke's theorem takes the place of the implicit
///   function theorem.
///
/// pairs     indices into the critical pairs of `found`
/// returns   false, too, where the pairs reach a border of a surface, a seam, or what was not
///           searched
/// cost      one cell for each patch that meets the rectangles; at most a few
///
/// Source: Clarke 1976, On the inverse function theorem.
bool crosses_regularly(const PairSearchResult& found, std::span<const int> pairs, SurfaceCells& a,
                       SurfaceCells& b);

/// True if the zeros of F on both sides of the knot lines that an arc runs along, over the extent
/// of its pair of cells and near these lines, are proven to be one arc, on whichever side each
/// point is: for each value of one parameter there is at most one zero, as above.
///
/// arc       in a certified pair, whose own zeros are one arc for each value of a parameter, too
/// returns   false, too, where the arc runs along an outer border: there it may be on neither
///           side; or along what was not searched
/// cost      one cell for each patch that meets the rectangles; mostly two of one surface, one of
///           the other
bool runs_regularly(const FoundArc& arc, SurfaceCells& a, SurfaceCells& b);

}  // namespace blossom
