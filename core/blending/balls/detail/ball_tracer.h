// SPDX-License-Identifier: LGPL-2.1-or-later
// Following a ball along two surfaces.

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/unbounded.h"
#include "core/blending/balls/ball_track.h"
#include "core/blending/balls/detail/ball_equations.h"

namespace blossom {

/// Where a driven ball's parameter has to stop, and where it has to have a node.
struct TrackStops {
  Interval range{-kUnbounded, kUnbounded};
  std::vector<double> knots{};  ///< increasing
};

/// The track through a solution, both ways until it ends.
///
/// x           a solution of the equations, inside of both parts
/// parameter   of the ball there; without meaning if the system is not driven
/// returns     nothing if the track has no length
///
/// Source: Dormand, Prince 1980, the Runge-Kutta pair of orders 5 and 4, each step followed by
/// Newton's method.
std::optional<BallTrack> traced(const std::shared_ptr<const BallSystem>& system, const Vec4& x,
                                double parameter, const TrackStops& stops = {});

}  // namespace blossom
