// SPDX-License-Identifier: LGPL-2.1-or-later
// The trims of a face in its chart, and what of a chart curve lies inside of them.
//
// Chart coordinates here are the surface's parameters times a power of two per direction, so
// that lengths in the chart are about lengths in space and one tolerance serves both.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "core/forms/spline.h"
#include "core/math/interval.h"
#include "core/plane/planar_crossings.h"
#include "core/results/options.h"

namespace blossom::occt {

/// One use of an edge by a wire of a face.
struct Coedge {
  TopoDS_Edge edge;   ///< as the forward face uses it: reversed means walked from last to first
  PlanarCurve curve;  ///< its pcurve, chart coordinates; the parameter is the edge's own
  std::vector<PlanarBox> boxes;  ///< of the curve's spans
  bool degenerated = false;      ///< one point in space, as at the pole of a sphere
  double tolerance = 0;          ///< of the edge, model units
  int from = 0;                  ///< corners where its walk along the wire starts and ends
  int to = 0;

  bool reversed() const { return edge.Orientation() == TopAbs_REVERSED; }
};

struct FaceTrims {
  TopoDS_Face face;                        ///< turned forward: it lies on the left of its wires
  std::vector<std::vector<Coedge>> loops;  ///< one for each wire, in no particular order inside
  std::vector<Coedge> inner;               ///< internal edges, which bound nothing; without corners
  std::vector<Vec2> corners;  ///< where coedges meet; a vertex on a seam has one on each side
  double largest_gap = 0;     ///< between the ends of coedges that meet, chart coordinates
  Vec2 scale;                 ///< chart coordinates per parameter
  Vec2 period;                ///< of the surface, chart coordinates; 0 for none
  PlanarBox box;              ///< of all loops
  double overshoot = 0;       ///< how far the loops go past the surface's own bounds
  bool natural = false;       ///< one loop, round the border of the box
};

/// The trims of a face.
///
/// Which ends of coedges meet follows from their common vertex; where several meet in one vertex,
/// each end goes with the nearest start, so that a seam's two sides stay apart.
///
/// throws   BadModel if the face has no wire, a wire is open, or an edge has no pcurve on it
FaceTrims face_trims(const TopoDS_Face& face);

/// The chart curve of a cut in the chart coordinates of the trims.
PlanarCurve chart_curve(const FaceTrims& trims, const Spline2& chart);

/// The moves by whole periods that bring a curve over the box of the trims; none if no move does.
std::vector<Vec2> period_shifts(const FaceTrims& trims, const PlanarCurve& curve);

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
/// What does so longer than this runs along the wire.
double tangency_length(const FaceTrims& trims, double tolerance);

/// Clips a curve in chart coordinates, where it lies (no periods are added).
/// tolerance   distance that counts as meeting, chart coordinates
ClippedCurve clipped(const FaceTrims& trims, const PlanarCurve& curve, double tolerance);

/// Whether a point in chart coordinates lies inside; on a wire either answer.
bool is_inside(const FaceTrims& trims, const Vec2& point);

/// How a rectangle of the surface's own parameters lies to the trims. Inside and Outside are proven
/// by boxes of pieces of the wires, none of which meets it. A point is Mixed on a wire alone.
PartSide part_side(const FaceTrims& trims, const Interval& u, const Interval& v);

/// A place on a curve in the surface's own parameters.
struct ChartSample {
  double parameter = 0;
  Vec2 uv;
};

/// The parameters of a chart curve at which it lies inside the trims of the face or on a wire.
///
/// Periods of the surface are taken into account. A naturally bounded face answers at once.
///
/// chart     in the surface's own parameters
/// returns   intervals of the curve's parameter, increasing, disjoint; one without length where
///           the curve only touches a wire; none if all is outside
/// throws    BadModel as `face_trims`
std::vector<Interval> clip_to_trims(const TopoDS_Face& face, const Spline2& chart);

/// The same for many curves on one face.
/// tolerance   of touches: what goes past a wire by no more than this stays whole; model units
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

/// The vertex or else the edge of the face within tolerance of a point; null off all wires.
/// uv        the surface's own parameters; whole periods do not matter
TopoDS_Shape border_at(const FaceTrims& trims, const Vec2& uv);

}  // namespace blossom::occt
