// SPDX-License-Identifier: LGPL-2.1-or-later
// What of a chart curve lies inside the trims of a face.

#pragma once

#include <optional>
#include <vector>

#include "core/forms/spline.h"
#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/plane/planar_curves.h"
#include "core/topology/face_trims.h"

namespace blossom {

/// A curve's meeting with a wire.
struct TrimMeeting {
  double at = 0;  ///< parameter of the curve
  int loop = 0;   ///< place in FaceTrims::loops
  int coedge = 0;
  double edge_parameter = 0;
  Interval touch{};  ///< of a touch: between these parameters the two cross by what they are off
};

/// A run of the curve along a wire.
struct TrimRun {
  Interval at;
  int loop = 0;
  int coedge = 0;
  Interval edge_parameters;
};

/// What the wires make of a curve.
struct ClippedCurve {
  std::vector<TrimMeeting> meetings;  ///< by increasing parameter
  std::vector<TrimRun> runs;
  std::vector<Interval> inside;  ///< increasing; between meetings, runs along wires not among them
  bool complete = true;          ///< false when the search for meetings ran out of its budget
};

/// What touches a wire with a radius of curvature r keeps within a tolerance t for sqrt(8 r t).
/// What does so longer than this, as with twice the diagonal of the face for a radius, runs along
/// the wire.
double wire_touch_length(const FaceTrims& trims, double tolerance);

/// Whether a curve that keeps to the wires between two points, chart coordinates, leads from corner
/// to corner. It runs along edges then, however short they are, while what only touches a wire
/// leaves it past both points, or has an end of its own there.
bool covers_edges(const FaceTrims& trims, const Vec2& from, const Vec2& to);

/// Clips a curve in chart coordinates, where it lies (no periods are added).
/// tolerance   distance that counts as meeting, chart coordinates
ClippedCurve clipped(const FaceTrims& trims, const PlanarCurve& curve, double tolerance);

/// A place on a curve in the surface's own parameters.
struct ChartSample {
  double parameter = 0;
  Vec2 uv;
};

/// The parameters of a chart curve at which it lies inside the trims of the face or on a wire.
///
/// Periods of the surface are taken into account. A naturally bounded face answers at once.
///
/// chart       in the surface's own parameters
/// tolerance   of touches: what goes past a wire by no more than this stays whole; model units
/// returns     intervals of the curve's parameter, increasing, disjoint; one without length where
///             the curve only touches a wire; none if all is outside
std::vector<Interval> clip_to_trims(const FaceTrims& trims, const Spline2& chart,
                                    double tolerance = 0);

/// Whether a part of a chart curve, longer than a touch may be, keeps within tolerance of a wire,
/// so that it is not known whether it lies inside: the largest distance of samples on it from the
/// wires, model units; nothing if no part does. Never of a naturally bounded face.
///
/// chart     in the surface's own parameters; as near to the samples as it is fitted
/// samples   places of the true curve, with the chart curve's parameters
std::optional<double> distance_along_wires(const FaceTrims& trims, const Spline2& chart,
                                           const std::vector<ChartSample>& samples);

/// How far a point is from the nearest wire, model units; 0 inside if it is clear of all wires.
/// uv        the surface's own parameters
double distance_outwards(const FaceTrims& trims, const Vec2& uv);

}  // namespace blossom
