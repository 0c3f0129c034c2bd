// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips that are pieces of cylinders, cones and tori.

#pragma once

#include <optional>

#include "core/blending/balls/ball_strip.h"

namespace blossom {

/// What the strip of circular sections along a part of a track is, if the balls at kAnalyticSamples
/// of it say so to rounding: centres on a line or circle, contacts that are carried along by its
/// motion, and a radius that is constant, or linear along a line.
std::optional<AnalyticStrip> analytic_strip(const BallTrack& track, const Interval& range);

inline constexpr int kAnalyticSamples = 17;

}  // namespace blossom
