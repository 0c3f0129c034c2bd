// SPDX-License-Identifier: LGPL-2.1-or-later
// The trims of a face in its chart: loops of coedges, and what lies inside of them.
//
// Chart coordinates here are the surface's parameters times a power of two per direction, so
// that lengths in the chart are about lengths in space and one tolerance serves both.

#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/forms/spline.h"
#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/plane/planar_crossings.h"
#include "core/results/options.h"

namespace blossom {

/// A distance that counts as on a wire, where no other is given. Model units, about.
inline constexpr double kOnWire = 1e-7;

/// Relative to the box: parameters of natural borders are exact up to rounding.
inline constexpr double kNaturalError = 1e-9;

/// One use of an edge by a loop of a face.
struct Coedge {
  int edge = 0;  ///< number among the edges of the face, which those who made the trims know
  bool reversed = false;         ///< walked from last to first
  PlanarCurve curve;             ///< in the chart; the parameter is the edge's own
  std::vector<PlanarBox> boxes;  ///< of the curve's spans
  std::array<Vec2, 2> ends;      ///< of the curve: its first and its last control point
  /// Between ends of neighbouring spans that roundings set apart.
  std::vector<std::array<Vec2, 2>> joints;
  bool degenerated = false;  ///< one point in space, as at the pole of a sphere
  double tolerance = 0;      ///< of the edge, model units
  int start = -1;            ///< vertices where its walk along the loop starts and ends
  int end = -1;
  int from = 0;  ///< corners there
  int to = 0;
};

struct FaceVertex {
  Vec3 point;
  double tolerance = 0;  ///< model units
};

/// A point of a surface with its first derivatives.
struct SurfaceJet {
  Vec3 point;
  Vec3 du, dv;
};

/// The parameters of the surface below a face.
struct SurfaceChart {
  /// The surface at its own parameters, beyond its patches, too. Asked by several threads at once.
  std::function<SurfaceJet(const Vec2& uv)> jet;
  PlanarBox bounds;  ///< its own parameters; may be without end
  Vec2 period;       ///< its own; 0 for none
  Vec2 scale{1, 1};  ///< chart coordinates per parameter
};

struct FaceTrims {
  std::vector<std::vector<Coedge>> loops;  ///< the face lies on their left; in no order inside
  std::vector<Coedge> inner;         ///< of internal edges, which bound nothing; without corners
  std::vector<FaceVertex> vertices;  ///< which coedges name
  std::vector<Vec2> corners;  ///< where coedges meet; a vertex on a seam has one on each side
  double largest_gap = 0;     ///< between the ends of coedges that meet, chart coordinates
  Vec2 scale{1, 1};           ///< chart coordinates per parameter
  Vec2 period;                ///< of the surface, chart coordinates; 0 for none
  PlanarBox box;              ///< of all loops
  double overshoot = 0;       ///< how far the loops go past the surface's own bounds
  bool natural = false;       ///< one loop, round the border of the box
  std::function<SurfaceJet(const Vec2& uv)> jet;  ///< as SurfaceChart has it
};

/// The trims that loops are.
///
/// Which ends of coedges meet follows from their common vertex; where several meet in one vertex,
/// each end goes with the nearest start, so that a seam's two sides stay apart.
///
/// loops     with vertices, and curves in the surface's own parameters; one or more, none empty
/// returns   nothing if a loop is open
std::optional<FaceTrims> trims_of(const SurfaceChart& chart, std::vector<FaceVertex> vertices,
                                  std::vector<std::vector<Coedge>> loops,
                                  std::vector<Coedge> inner = {});

/// Holds all loops, whose curves are in the surface's own parameters.
PlanarBox box_of(const std::vector<std::vector<Coedge>>& loops);

/// Where the walk along a coedge starts or ends, chart coordinates.
Vec2 end_point(const Coedge& coedge, bool last);

/// The two chords that close the loop where a coedge does not end in its corners: from the corner
/// to where its walk starts, and from where it ends to the corner.
std::array<std::array<Vec2, 2>, 2> closing_chords(const FaceTrims& trims, const Coedge& coedge);

/// The chart curve of a cut in the chart coordinates of the trims.
PlanarCurve chart_curve(const FaceTrims& trims, const Spline2& chart);

/// Whether a loop encloses no more than the strips that its edges' tolerances cover along it.
/// least   of a tolerance, chart coordinates
bool is_covered(const FaceTrims& trims, const std::vector<Coedge>& loop, double least);

/// The moves by whole periods that bring a curve over the box of the trims; none if no move does.
std::vector<Vec2> period_shifts(const FaceTrims& trims, const PlanarCurve& curve);

/// Whether a point in chart coordinates lies inside; on a wire either answer.
bool is_inside(const FaceTrims& trims, const Vec2& point);

/// The same for a point by the surface's own parameters, of which whole periods do not matter.
bool is_inside_by_periods(const FaceTrims& trims, const Vec2& uv);

/// How a rectangle of the surface's own parameters lies to the trims. Inside and Outside are proven
/// by boxes of pieces of the wires, none of which meets it. A point is Mixed on a wire alone.
PartSide part_side(const FaceTrims& trims, const Interval& u, const Interval& v);

/// An edge may be as far from its wire as its tolerance says.
enum class Wires { AsTheyAre, WithTolerances };

/// The first coedge that may come within a margin of a rectangle, null if there is none. Wires are
/// halved that often to find out.
const Coedge* coedge_near(const FaceTrims& trims, const PlanarBox& box, double margin, int halvings,
                          Wires wires = Wires::WithTolerances);

/// The first coedge within kOnWire of a point in chart coordinates, null if there is none.
const Coedge* coedge_at(const FaceTrims& trims, const Vec2& point,
                        Wires wires = Wires::WithTolerances);

/// The place of a wire next to a point.
struct WirePlace {
  const Coedge* coedge = nullptr;
  double parameter = 0;  ///< of the edge
  double distance = 0;   ///< chart coordinates
};

/// The nearest place of all wires within `reach` and the tolerance of its edge; nothing off them.
/// uv        the surface's own parameters; whole periods do not matter
std::optional<WirePlace> wire_near(const FaceTrims& trims, const Vec2& uv, double reach);

/// A place on the border of a face.
struct TrimPlace {
  const Coedge* coedge = nullptr;
  int vertex = -1;  ///< at its ends
};

/// The vertex or else the edge of the face within tolerance of a point; nothing off all wires.
/// uv        the surface's own parameters; whole periods do not matter
std::optional<TrimPlace> border_at(const FaceTrims& trims, const Vec2& uv);

}  // namespace blossom
