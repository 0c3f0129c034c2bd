// SPDX-License-Identifier: LGPL-2.1-or-later
// Cutting nets in bulk: all control points of many pieces at once.
//
// The control points of a piece are S_u P S_v^T. Done for one piece after the other, making the
// matrices costs as much as using them; done for many, matrices are shared or made side by side
// and every instruction works on a full vector. None of these functions allocates.
//
// Layouts, all coordinate planes first (structure of arrays):
//   net      NetShape::size() values, see `core/subdivision/cell_nets.h`
//   block    kLanes nets side by side: value k of net l at k * kLanes + l
//   sheet    the nets of a grid of cells in one array, see SheetShape
//
// A curve is a net with one row. A piece is the same bit for bit on every path from the same form
// (grid, block, pieces, one piece), and neighbours share their borders bit for bit; the polar
// pyramid promises neither. How to choose: `core/subdivision/README.md`.

#pragma once

#include <cstddef>
#include <span>

#include "core/math/interval.h"
#include "core/subdivision/bulk/bulk_bounds.h"
#include "core/subdivision/bulk/bulk_matrices.h"
#include "core/subdivision/bulk/bulk_storage.h"
#include "core/subdivision/bulk/simd_level.h"
#include "core/subdivision/cell_nets.h"

namespace blossom {

/// The nets of all cells of a grid: row (cell i, k), column (cell j, l) of plane p, rows padded to
/// whole lanes.
struct SheetShape {
  NetShape net;
  int cells_u = 0;
  int cells_v = 0;

  constexpr std::size_t stride() const {
    return static_cast<std::size_t>((cells_v * net.columns + kLanes - 1) / kLanes * kLanes);
  }
  constexpr std::size_t plane_size() const {
    return static_cast<std::size_t>(cells_u * net.rows) * stride();
  }
  constexpr std::size_t size() const { return plane_size() * static_cast<std::size_t>(net.planes); }

  /// Place of value (k, l) of plane p of cell (i, j).
  constexpr std::size_t at(int i, int j, int p, int k, int l) const {
    return static_cast<std::size_t>(p) * plane_size() +
           static_cast<std::size_t>(i * net.rows + k) * stride() +
           static_cast<std::size_t>(j * net.columns + l);
  }
};

/// Values in a block of nets.
constexpr std::size_t block_size(const NetShape& shape) {
  return static_cast<std::size_t>(shape.size()) * kLanes;
}

/// Ends of pieces, four lists of the same length: a multiple of kLanes, padded by the caller with
/// any finite values.
struct PieceEnds {
  std::span<const double> u_from, u_to, v_from, v_to;
};

/// All cells of a grid over one net.
///
/// net          shape.size() values in the form of the stacks, model units
/// u, v         matrices of the degrees shape.rows - 1 and shape.columns - 1, one form
/// sheet        receives SheetShape{shape, u.pieces(), v.pieces()}.size() values
/// throws       InvalidInput if a size, a degree or a form does not fit
/// accuracy     bulk_bezier_error or bulk_monomial_error
/// cost         a cell: rows^2 columns planes multiply-adds, and its share of a column's
///              columns^2 rows planes
///
/// Source: Vlachkova 2025, Theorem 2.
void subdivide_grid(const NetShape& shape, std::span<const double> net, const MatrixStack& u,
                    const MatrixStack& v, std::span<double> sheet,
                    SimdLevel level = best_simd_level());

/// The same grid over many nets of one shape.
///
/// nets         any number of blocks
/// sheets       receives a sheet of lanes for each block: in SheetShape's order, without padding
///              of rows, kLanes values at each place; cells_u cells_v block_size values
void subdivide_blocks(const NetShape& shape, std::span<const double> nets, const MatrixStack& u,
                      const MatrixStack& v, std::span<double> sheets,
                      SimdLevel level = best_simd_level());

/// Pieces with ends of their own, matrices made on the way.
///
/// nets         one net for all pieces, or a block of nets for every kLanes pieces
/// out          receives a block for every kLanes pieces
/// throws       InvalidInput if a size does not fit or an end is not finite
/// accuracy     bulk_bezier_error or bulk_monomial_error; times bezier_growth outside [0, 1]
void subdivide_pieces(NetForm form, const NetShape& shape, std::span<const double> nets,
                      const PieceEnds& ends, std::span<double> out,
                      SimdLevel level = best_simd_level());

/// The same from re-centred coefficients by the polar pyramid: no matrices, a fifth less work.
///
/// accuracy     bulk_pyramid_error times pyramid_growth in both directions
///
/// Source: Vlachkova 2025, Theorem 1, with 1 + b E = (1 + a E) + h E.
void subdivide_pieces_by_pyramid(const NetShape& shape, std::span<const double> coefficients,
                                 const PieceEnds& ends, std::span<double> out,
                                 SimdLevel level = best_simd_level());

/// The two forms of one net, for the choice of a path.
struct BothForms {
  std::span<const double> bezier;        ///< shape.size() values
  std::span<const double> coefficients;  ///< made from them by monomial_from_bezier
  NetSizes sizes;                        ///< net_sizes of them
};

/// Pieces with ends of their own, every kLanes of them by the fastest path that keeps all of them
/// within a tolerance: piece_path for the widest reach in u and in v.
///
/// tolerance    model units
/// throws       InvalidInput as above, or if the tolerance is negative or not a number
/// accuracy     the tolerance, or bulk_bezier_error where no path keeps it
void subdivide_pieces_within(double tolerance, const NetShape& shape, const BothForms& net,
                             const PieceEnds& ends, std::span<double> out,
                             SimdLevel level = best_simd_level());

/// One piece of one net, made for the single call.
///
/// out          receives shape.size() values
void subdivide_piece(NetForm form, const NetShape& shape, std::span<const double> net,
                     const Interval& u, const Interval& v, std::span<double> out,
                     SimdLevel level = best_simd_level());

/// Sizes of a net, for the choice of a path: its Bezier form and its re-centred coefficients made
/// from it by monomial_from_bezier.
NetSizes net_sizes(const NetShape& shape, std::span<const double> bezier,
                   std::span<const double> coefficients);

}  // namespace blossom
