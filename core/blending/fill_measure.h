// SPDX-License-Identifier: LGPL-2.1-or-later
// How smoothly two surfaces meet at a common point, and how a fill meets its sides.

#pragma once

#include <vector>

#include "core/blending/fill.h"
#include "core/blending/fill_layout.h"
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

/// Measures all inner edges and sides of a fill and enters the figures.
/// sides  with the parameters of the fill, model units
void measure(Fill& made, const std::vector<FillSide>& sides, const PolygonLayout& layout);

}  // namespace blossom
