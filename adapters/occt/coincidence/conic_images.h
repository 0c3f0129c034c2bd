// SPDX-License-Identifier: LGPL-2.1-or-later
// Lines and conics that lie on two surfaces, cut into parts with smooth images in both charts.

#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <vector>

#include "adapters/occt/faces/surface_projector.h"
#include "core/forms/conic.h"
#include "core/forms/surface.h"
#include "core/results/result.h"

namespace blossom::occt {

inline constexpr double kTurn = 2 * std::numbers::pi;  ///< of an angle, radians

/// A surface with the middle of the rectangle of its parameters that counts: where it is periodic,
/// one period round the middle counts, and the rectangle has its seam there if it is all of it.
struct ChartSheet {
  const SurfaceProjector& feet;
  Vec2 middle;
  Vec2 period;  ///< 0 for none
};

ChartSheet sheet_of(const SurfaceProjector& feet, const BezierSurface& surface);

/// Parameters moved by whole periods next to the middle.
Vec2 in_sheet(const ChartSheet& sheet, Vec2 uv);

/// A conic that lies on two surfaces, cut at their seams, poles and nodes, as curves with charts.
/// One that is cut begins there: a circle is turned for that. An image comes to a pole in the
/// direction that the conic has there. Their deviations are sampled, not proven.
///
/// range     of the conic's parameter; of a closed one all of it from 0 on, or less from anywhere
/// nodes     parameters, increasing, at which it is cut, too
/// slack     how far from the surfaces counts as on them; model units
/// returns   nothing if a part has no image within the slack in a chart
std::optional<std::vector<IntersectionCurve>> conic_on_sheets(
    const Conic& conic, const Interval& range, const std::vector<double>& nodes,
    const std::array<const ChartSheet*, 2>& sheets, double slack);

}  // namespace blossom::occt
