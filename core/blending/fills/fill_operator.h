// SPDX-License-Identifier: LGPL-2.1-or-later
// The linear map from the data of the sides to the control points of a fill.
//
// It is computed once for each layout, number of sides, degree and goal. The conditions A x = B z
// (fill_conditions.h) are the same in all n sectors, so a discrete Fourier transform over the
// sectors makes n independent systems of a sector's size. In each of them
//
//   x = T F z + G (z - D F z),     G r = least thin-plate energy among the solutions of A x = B r,
//
// where the columns of T are the polynomials of total degree up to 3 of that frequency, D their
// data and F the pseudo-inverse of D: what is a cubic is reproduced, and energy decides the rest.
// Under a turn by a sector's angle z^a conj(z)^b is multiplied by exp(i (a - b) 2 pi / n), so these
// functions of the complex coordinate z have one frequency each.
//
// If the data contradict each other there is no solution; `residual` tells.

#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/blending/fills/fill_conditions.h"

namespace blossom {

enum class FillGoal {
  First,            ///< G1
  Second,           ///< G2
  FirstNearSecond,  ///< G1, and as near to G2 as is possible then
};

/// Highest degree of a fill's patches: two above what bicubic neighbours with parameters that do
/// not fit each other need at G2. Also the highest that conditions of second order keep 1e-12 for.
inline constexpr int kMaxFillDegree = 13;

class FillOperator {
 public:
  /// degree  2..kMaxFillDegree
  /// throws  InvalidInput if sides or degree are out of range
  FillOperator(FillLayout layout, int sides, int degree, FillGoal goal);

  const PolygonLayout& layout() const { return layout_; }
  const FillPoints& points() const { return points_; }
  const FillData& data() const { return data_; }
  FillGoal goal() const { return goal_; }

  /// The control points of a fill: sector after sector, each in the order of FillPoints.
  /// data     n sectors of data().count() values
  std::vector<Vec4> control_points(std::span<const Vec4> data) const;

  /// Largest coordinate by which a condition of the goal fails; the second-order ones do not count
  /// at FirstNearSecond.
  double residual(std::span<const Vec4> control_points, std::span<const Vec4> data) const;

 private:
  PolygonLayout layout_;
  FillPoints points_;
  FillGoal goal_;
  FillData data_;
  std::vector<FillRow> rows_;
  Grid<double> weights_;  ///< inner points x (n sectors' data, that of the same sector first)
};

/// The operator, from the ones that were made before if it is there. Threads may call this at the
/// same time; each operator is made once.
std::shared_ptr<const FillOperator> fill_operator(FillLayout layout, int sides, int degree,
                                                  FillGoal goal);

}  // namespace blossom
