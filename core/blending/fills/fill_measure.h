// SPDX-License-Identifier: LGPL-2.1-or-later
// How smoothly two surfaces meet at a common point, and how a fill meets its sides.

#pragma once

#include <vector>

#include "core/blending/fills/fill_layout.h"
#include "core/blending/fills/fill_side.h"
#include "core/forms/evaluation.h"

namespace blossom {

/// At one common point.
struct MeetingOfJets {
  double gap = 0;                   ///< distance of the points, model units
  double normal_angle = 0;          ///< between S_u x S_v of both, radians, in [0, pi]
  double curvature_difference = 0;  ///< largest entry of the difference of the shape operators
  double curvature = 0;             ///< largest entry of both of them, 1 / model unit
};

/// second  whether second derivatives are known on both sides; else the curvatures stay 0
MeetingOfJets meeting_of(const PatchJet& a, const PatchJet& b, bool second);

/// How the fill meets a side, measured at 19 places of each half, those near corners included.
struct FillContact {
  double gap = 0;                   ///< model units
  double normal_angle = 0;          ///< radians, in [0, pi]; 0 without a neighbour
  double curvature_difference = 0;  ///< of the shape operators, 1 / model unit; 0 if not known
};

struct FillFigures {
  std::vector<FillContact> sides;
  FillContact inside;            ///< over all inner edges; their gap is 0
  double largest_curvature = 0;  ///< of fill and neighbours at these places, 1 / model unit
};

/// Measures all inner edges and sides of a fill.
/// patches  of all quads, sector after sector, model units
/// sides    with the parameters of the fill, likewise
FillFigures fill_figures(const std::vector<RationalBezierPatch>& patches,
                         const std::vector<FillSide>& sides, const PolygonLayout& layout);

}  // namespace blossom
