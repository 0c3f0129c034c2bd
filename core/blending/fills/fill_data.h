// SPDX-License-Identifier: LGPL-2.1-or-later
// From the neighbours of a hole to functions on the sides of the polygon.
//
// Notation: side k has the direction e and the outward normal n of the same length in the plane of
// the polygon; theta is the angle from one side to the next, 2 pi / n. Primes are d/ds.

#pragma once

#include <vector>

#include "core/blending/fills/fill_operator.h"
#include "core/blending/fills/fill_side.h"

namespace blossom {

/// The functions f, f_n, f_nn on a side.
struct SideFunctions {
  Row value;
  Row normal;
  Row second;  ///< empty without second order

  /// The lowest degree of patches that hold them.
  int degree() const;
};

/// What the corners ask of the functions a, b, r and of the second derivatives.
enum class CornerDemand {
  TangentPlanes,  ///< of the ring at G1
  Twists,         ///< of the star at G1: one mixed derivative for both sides
  SecondJets,     ///< of G2: all second derivatives
  None,           ///< of G1 near G2: second derivatives are given, but nothing is changed for them
};

/// Second derivatives at a corner that disagree by no more, relative, agree: those of nets of
/// degree n carry about n^2 times the rounding of their points.
inline constexpr double kSameSeconds = 1e-11;

struct PolygonFunctions {
  std::vector<SideFunctions> sides;
  /// By how much the demand fails at the worst corner, relative to the second derivatives there.
  double mismatch = 0;
};

/// sides  prepared, with independent directions at the corners
PolygonFunctions polygon_functions(const std::vector<FillSide>& sides, CornerDemand demand);

/// The data of all sectors for an operator.
std::vector<Vec4> operator_data(const std::vector<SideFunctions>& sides, const FillOperator& made);

/// Sum of two rows; the lower degree is raised. An empty row is nothing.
Row sum(const Row& a, const Row& b);

}  // namespace blossom
