// SPDX-License-Identifier: LGPL-2.1-or-later
// F and J in a part of a pair of cells, and where in it F may vanish.
//
// Places are given by z in [-1/2, 1/2]^4, the cells' own parameters from their middles.

#pragma once

#include <array>

#include "core/cells/cell_bend.h"
#include "core/cells/cell_pair.h"

namespace blossom {

/// A box in the pair: middle +- radius in each parameter.
struct PairPart {
  std::array<double, 4> middle{};
  std::array<double, 4> radius{0.5, 0.5, 0.5, 0.5};
};

/// A vector that is known within an error, by coordinate.
struct BoundedVector {
  Vec3 value;
  Vec3 error;
};

/// F and the columns of J at a place, as computed.
struct PairJet {
  std::array<double, 4> place;
  Vec3 gap;
  std::array<Vec3, 4> columns;
};

/// What it is made from is used as long as this object is.
class PairModel {
 public:
  PairModel(const CellTree& tree_a, const Cell& a, const CellTree& tree_b, const Cell& b);

  PairJet jet(const std::array<double, 4>& place) const;

  /// F, rounding included.
  BoundedVector gap(const std::array<double, 4>& place) const;

  /// True if F vanishes nowhere in the pair since, to second order, the one surface lies above the
  /// other by more than `least`, model units, where they are over each other. Tells more than
  /// planes do where both bend alike.
  bool are_disjoint(double least) const;

  /// The columns of J over a part of the pair, from what is known at some place near it.
  JacobianBounds jacobian(const PairJet& jet, const PairPart& part) const;

  /// Their means on the straight ways from the jet's place, which is in the pair, to all of the
  /// part: J is as far from the jet's as the second derivatives lead it in half of the way.
  JacobianBounds mean_jacobian(const PairJet& jet, const PairPart& part) const;

  const Vec3& rounding() const { return rounding_; }

  /// Of the cells.
  const SecondDerivatives& second_a() const { return second_a_; }
  const SecondDerivatives& second_b() const { return second_b_; }

  /// Parameters in the patches' own [0, 1].
  std::array<double, 4> parameters(const std::array<double, 4>& place) const;

 private:
  // With so much of the change on the way to the part.
  JacobianBounds jacobian_within(const PairJet& jet, const PairPart& part, double share) const;

  const CellTree &tree_a_, &tree_b_;
  const Cell &a_, &b_;
  std::array<Interval, 4> box_;
  JacobianBounds whole_;                   // over the pair
  SecondDerivatives second_a_, second_b_;  // over the cells
  std::array<Vec3, 3> most_a_, most_b_;    // largest uu, uv, vv of them
  Vec3 rounding_;                          // of F
  std::array<Vec3, 4> slope_rounding_;     // of the columns of J
};

/// Narrows a part to where F may vanish in it. With C the inverse of the middle of a minor of J and
/// E its spread, every root at z is in p - C (F(p) + J_k (z_k - p_k)) +- E |z - p| (Krawczyk 1969),
/// where column k of J is the one that the minor leaves out.
///
/// minor, column   of J's means on the straight ways from p to the part; bounds over both will do
/// place           p, in the part but for what the minor leaves out
/// gap             F(p)
/// returns         false if F vanishes nowhere in the part
bool narrow(PairPart& part, const Minor& minor, int left_out, const VectorBounds& column,
            const std::array<double, 4>& place, const BoundedVector& gap);

}  // namespace blossom
