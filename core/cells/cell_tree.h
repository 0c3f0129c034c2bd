// SPDX-License-Identifier: LGPL-2.1-or-later
// The cells of one patch: a binary tree of sub-patches, made when asked for and kept.
//
// A cell carries its control points (from `core/subdivision`, nothing else), a box, a fat plane
// and bounds of its derivatives. All pairs that a cell takes part in share them. Every bound
// contains the rounding of the net it was made from.

#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "core/forms/patch.h"
#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/results/options.h"
#include "core/subdivision/cell_nets.h"

namespace blossom {

/// Bounds of a vector that varies over a cell: middle +- radius in each coordinate.
struct VectorBounds {
  Vec3 middle;
  Vec3 radius;
};

/// All points p of the cell satisfy low <= normal . p <= high.
struct FatPlane {
  Vec3 normal;  ///< unit, or zero when the cell is too degenerate to have one
  double low = 0;
  double high = 0;
};

struct Cell {
  Interval u, v;                    ///< place in the patch's [0, 1]^2
  int depth = 0;                    ///< halvings since the whole patch
  int child = -1;                   ///< index of the lower half, the upper one follows; -1: none
  bool split_u = true;              ///< the direction of its halving
  PartSide part = PartSide::Mixed;  ///< how it lies to the part of the patch that counts
  const double* homogeneous = nullptr;   ///< Bezier net, 3 or 4 planes
  const double* coefficients = nullptr;  ///< monomial form of the same, when that is the source
  const double* hull = nullptr;          ///< control points in space, 3 planes
  double margin = 0;                     ///< rounding of a hull coordinate, model units
  Vec3 low, high;                        ///< box of the hull, margin included
  FatPlane plane;
  VectorBounds du, dv;                   ///< derivatives by the cell's own [0, 1] parameters
  std::array<VectorBounds, 3> second{};  ///< differences uu, uv, vv of the hull as computed
  double bend = 0;                       ///< how far it is from flat and affine, model units
  double extent = 0;                     ///< diagonal of the box
};

class CellTree {
 public:
  /// patch     its points are taken relative to `origin`, to keep digits far from zero
  /// cut       where cells are halved, in (0, 1); off 1/2, since singular points like dyadic lines
  /// part      what counts of the patch, by its own [0, 1]^2; empty: everything
  CellTree(const RationalBezierPatch& patch, bool rational, const Vec3& origin, CellForm form,
           double cut, PartTest part = {});

  /// The cells of a piece of the patch in Bezier form, halved in the middle; outside of [0, 1] it
  /// is extended. Their bounds hold for the patch as it was given.
  CellTree piece(const Interval& u, const Interval& v) const;

  /// The whole patch is number 0. Cells stay where they are when others are made.
  const Cell& operator[](int index) const {
    if (index == 0) return root_;
    const auto place = static_cast<std::size_t>(index - 1);
    return (*halves_[place / kTogether])[place % kTogether];
  }

  /// Index of the lower half of a cell, made if it is not there.
  int split(int index);

  /// Asks for the direction in which a cell is halved; too late if it is.
  void prefer(int index, bool along_u) {
    Cell& cell = cell_at(index);
    if (cell.child < 0) cell.split_u = along_u;
  }

  /// Gives the memory of all cells back, that of number 0, too; what is known of the patch stays.
  void drop_cells();

  bool monomial() const { return monomial_; }
  int size() const { return size_; }
  const NetShape& shape() const { return shape_; }

  /// Bound on the rounding of a coordinate of a piece of `patch()` in space, that of its move to
  /// the origin included; infinite if a weight of the piece is not positive.
  double piece_rounding(const RationalBezierPatch& piece, const Interval& u,
                        const Interval& v) const;

  /// The patch, relative to the origin.
  const RationalBezierPatch& patch() const { return patch_; }

  /// Bound on the rounding of a coordinate of `patch()` in space, before any halving.
  double given_rounding() const { return given_rounding_; }

  /// Largest absolute coordinate of its control points in space, model units.
  double scale() const { return hull_scale_; }

  /// The largest weight of the patch over the smallest.
  double weight_spread() const { return weight_spread_; }

 private:
  CellTree(const RationalBezierPatch& patch, bool rational, const Vec3& origin, CellForm form,
           double cut, PartTest part, double given_rounding);
  static constexpr std::size_t kTogether = 8;  // halves of cells, in one piece of memory

  Cell& cell_at(int index) { return const_cast<Cell&>(std::as_const(*this)[index]); }
  double* allocate(int count);
  void choose_form(CellForm form, const double* net);
  void halve_net(const Cell& cell, const std::array<double*, 2>& nets) const;
  void set_net(Cell& cell, double* net);
  void finish(Cell& cell);
  double rounding_of(const Cell& cell) const;
  void make_hull(Cell& cell);
  void bound_polynomial_derivatives(Cell& cell) const;
  void bound_rational_derivatives(Cell& cell) const;
  void choose_direction(Cell& cell) const;

  RationalBezierPatch patch_;
  NetShape shape_;
  bool rational_;
  PartTest part_;
  bool monomial_ = false;
  double cut_;
  double given_rounding_;
  double net_scale_ = 0;          // largest absolute value of the net
  double hull_scale_ = 0;         // largest absolute coordinate of a control point in space
  double coefficient_scale_ = 0;  // largest sum of absolute coefficients over the planes
  double least_weight_ = 1;
  double weight_spread_ = 1;
  Cell root_;
  std::vector<std::unique_ptr<std::array<Cell, kTogether>>> halves_;
  int size_ = 1;
  std::vector<std::unique_ptr<double[]>> blocks_;
  int free_in_block_ = 0;
  int block_;  // doubles of the next block; the first holds the whole patch, then they grow
};

}  // namespace blossom
