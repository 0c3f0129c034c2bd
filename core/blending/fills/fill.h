// SPDX-License-Identifier: LGPL-2.1-or-later
// Filling an n-sided hole with patches that meet their neighbours with common tangent planes, or
// curvatures, to rounding.
//
// The hole's sides are the sides of a regular polygon (fill_layout.h). On each of them the fill
// takes over the border curve f, the derivative f_n across it and, for G2, f_nn. What the neighbour
// C(s, t) has there, t = 0 along the border, is fitted to the polygon by changing its parameters:
//
//   f_n  = a C_t + b C_s + r C
//   f_nn = a^2 C_tt + 2 a b C_ts + b^2 C_ss + 2 r (a C_t + b C_s) + alpha C_t + beta C_s + gamma C
//
// with polynomials a, b, r of s, in homogeneous coordinates; r, gamma serve rational neighbours. At
// a corner the tangents of the two sides give a, b, r, which is possible if their tangent planes
// agree. Then one linear map gives all control points (fill_operator.h).
//
// Which layout: at a corner where one patch meets two neighbours, these have to agree in the second
// fundamental form's II(e1, e2) of the sides' directions; neighbours that are only G1 to each other
// need not. One inner edge from the corner makes G1 possible always, two make G2 possible if the
// second fundamental forms agree. So
//
//   G1:  star if the twists agree, else ring
//   G2:  star if that meets all conditions to rounding, else deep ring; where the second
//        fundamental forms disagree, G1 by the deep ring with the G2 conditions in the energy
//
// A result that misses its conditions is refused, not given out: see FillProblem.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/tolerances.h"
#include "core/blending/fills/fill_measure.h"
#include "core/blending/fills/fill_side.h"

namespace blossom {

struct FillOptions {
  /// Corners that are farther apart than `point` do not join. Model units.
  Tolerances tolerances = {};

  /// The largest angle between normals that counts as G1, of the neighbours at a corner and of the
  /// result. Radians.
  double angle = 1e-6;

  /// The largest difference of curvatures that counts as G2, relative to the largest curvature of
  /// the fill and its neighbours.
  double curvature = 1e-6;

  /// The layout to take; chosen by the data if not given.
  std::optional<FillLayout> layout = {};
};

/// Why there is no fill. `place` of the result is the side or corner that is meant.
enum class FillProblem {
  None,
  Gap,             ///< two sides do not join
  DegenerateSide,  ///< a side has no length, or no tangent at an end, or no tangent plane there
  FlatCorner,      ///< two sides run on, or back, in one direction
  ReflexCorner,    ///< the neighbour of a side lies on the hole's own side of it
  TangentPlanes,   ///< the neighbours' tangent planes disagree at a corner
  Degree,          ///< the data have a degree too high for the fill's patches
  Weights,         ///< a weight of the result is not positive
  Conditions,      ///< the layout asked for cannot meet the data
};

/// "none", "gap", "degenerate-side", ..: the words of the report.
const char* to_string(FillProblem problem);

struct Fill {
  FillProblem problem = FillProblem::None;
  int place = -1;       ///< number of the side or corner, from 0; corner k begins side k
  std::string message;  ///< one sentence with the figures; empty if there is no problem

  FillLayout layout = FillLayout::Star;
  int degree = 0;
  std::vector<RationalBezierPatch> patches;  ///< sector after sector; empty if there is a problem
  bool rational = false;

  FillFigures figures;
  double residual = 0;      ///< of the conditions, relative to the size of the hole
  double least_weight = 1;  ///< over the control points

  /// What was reached: G2 only if it was asked for somewhere.
  FillContinuity reached = FillContinuity::G0;
};

/// Fills a hole.
///
/// sides     3 to 12, one after the other round the hole; degrees of at most kMaxFillDegree
/// returns   the fill, or what stands against it
/// throws    InvalidInput if the number of sides is wrong, a row is empty or not finite, a weight
///           is not positive, or a side asks for G1 without `across`, for G2 without `bend`
/// accuracy  borders are those of the sides to a few roundings, up to a shift of corners by at most
///           half of the gap; conditions hold to about 1e-14 of the size of the hole, as `residual`
///           says
///
/// Source: Hahn 1989, for the star.
Fill fill(const std::vector<FillSide>& sides, const FillOptions& options = {});

}  // namespace blossom
