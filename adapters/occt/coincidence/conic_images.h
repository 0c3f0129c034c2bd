// SPDX-License-Identifier: LGPL-2.1-or-later
// Lines, conics and crossings of pipes that lie on two surfaces, cut into parts with smooth images
// in both charts.

#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "adapters/occt/coincidence/chart_sheet.h"
#include "core/forms/conic.h"
#include "core/forms/meetings/pipe_joint.h"
#include "core/results/result.h"

namespace blossom::occt {

inline constexpr double kTurn = 2 * std::numbers::pi;  ///< of an angle, radians

/// Of the slack: so far may the image of a form be off, by samples of it. A choice: what is wider
/// than the tolerance is told by its deviation.
inline constexpr double kImageOff = 2;

/// A curve in space by a closed form.
using ClosedForm = std::variant<Conic, PipeCrossing>;

/// A curve that lies on two surfaces, cut at their seams, poles and nodes, as curves with charts.
/// One that is cut begins there: a circle is turned for that. An image comes to a pole in the
/// direction that the curve has there. Their deviations are sampled, not proven. What is no conic
/// gets arc length on average as parameter.
///
/// range     of the form's parameter; of a closed one all of it from 0 on, or less from anywhere
/// nodes     parameters, increasing, at which it is cut, too
/// slack     how far from the surfaces counts as on them; model units
/// returns   nothing if a part has no image within the slack in a chart
std::optional<std::vector<IntersectionCurve>> curves_on_sheets(
    const ClosedForm& form, const Interval& range, const std::vector<double>& nodes,
    const std::array<const ChartSheet*, 2>& sheets, double slack);

}  // namespace blossom::occt
