// SPDX-License-Identifier: LGPL-2.1-or-later
// What an intersection of two surfaces is: curves, points, and how far all that is proven.

#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/tolerances.h"
#include "core/forms/conic.h"
#include "core/forms/spline.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

/// A point common to both surfaces. Parameters are the surfaces' own.
struct SurfacePoint {
  Vec3 point;
  Vec2 uv_a;
  Vec2 uv_b;
};

/// Bounds on the distances along a curve at equal parameters, model units.
struct Deviation {
  double a = 0;        ///< 3D curve (its conic, if any) to its chart curve's image on surface a
  double b = 0;        ///< likewise on b
  double between = 0;  ///< between the two images
  bool proven = true;  ///< false: on some piece of the curve, only the largest of samples
  double conic = 0;    ///< 3D spline to the conic, if there is one
};

/// The tolerance of an edge that a curve becomes, model units.
double edge_tolerance(const Deviation& deviation);

/// Where a curve ends.
enum class CurveEnd {
  Closed,   ///< nowhere: the curve is a loop
  BorderA,  ///< on the border of surface a (perhaps of b too)
  BorderB,  ///< on the border of surface b only
  Place,    ///< at one of the listed places
  Trim,     ///< on a trimming curve of a face
};

/// Its parameter is arc length, or that of the line or conic which it is.
struct IntersectionCurve {
  Spline curve;     ///< in space
  Spline2 chart_a;  ///< in the parameters of a; same knots as `curve`
  Spline2 chart_b;
  std::optional<Conic> conic{};           ///< the curve in space, if it is a line or a conic
  std::vector<SurfacePoint> samples;      ///< in order; on both surfaces to rounding
  std::vector<double> sample_parameters;  ///< increasing; where about they lie on `curve`
  std::array<CurveEnd, 2> ends{};
  bool closed = false;  ///< the first sample is repeated at the end
  bool tangential = false;
  double length = 0;       ///< model units
  double least_angle = 0;  ///< between the normals along the curve, radians
  Deviation deviation;
};

enum class PlaceKind { Touch, Node, Cusp, Pole, Tangential, Overlap, Open };

/// "touch", "node", ... as in the JSON report.
const char* to_string(PlaceKind kind);

/// A place in which the surfaces stay within tolerance of each other, or which stayed open.
struct Place {
  PlaceKind kind = PlaceKind::Open;
  Vec3 box_low;  ///< axis-parallel box, model units
  Vec3 box_high;
  double gap_low = 0;  ///< distance of the surfaces in the place, model units
  double gap_high = 0;
  std::array<Interval, 4> parameters{};  ///< ranges of u, v on a and u, v on b
};

/// Makes a place hold a point, or ranges of parameters.
/// gap       distance of the surfaces there, model units
void widen(Place& place, const SurfacePoint& x, double gap);
void widen(Place& place, const std::array<Interval, 4>& parameters);

/// What was examined and how it ended; the numbers behind the status.
struct Certificate {
  long excluded = 0;             ///< cell pairs proven not to meet
  long certified = 0;            ///< cell pairs proven to hold nothing but regular arcs
  long critical = 0;             ///< cell pairs that stayed undecided
  long cells_bezier = 0;         ///< cells whose nets came from the Bezier form
  long cells_monomial = 0;       ///< cells whose nets came from the monomial form
  int depth = 0;                 ///< deepest bisection of a patch
  long identified = 0;           ///< pairs of surfaces, of edges, or of a point and what it lies
                                 ///< on, that are one by `one_within`
  double identified_within = 0;  ///< the largest bound on the distance of such a pair, model units
  bool limited = false;          ///< the options' budget or time, memory or the user ended it
  double rounding_bound = 0;     ///< largest rounding margin added to a net, model units
  double least_angle = 0;        ///< least angle between normals on the curves, radians
  std::vector<std::string> reasons;  ///< why the status is not complete
  bool beside_node = false;          ///< a branch ends on the border of a region in which several
                                     ///< meet, or nearly: one of the reasons
};

/// Notes that what is within a distance counts as one.
void identify(Certificate& certificate, double within);

/// A connected region that both surfaces have in common.
struct Overlap {
  /// Its boundary, the region to the left as seen from the tip of a's normal; it repeats its first
  /// point. A region with holes, or a band round a closed direction, has several loops, joined as
  /// `joined_loops` does; one round a pole a loop that goes round a's parameters, with nothing at
  /// the pole. Where whole closed surfaces coincide there is none.
  std::vector<SurfacePoint> boundary;
  double gap_high = 0;  ///< largest distance of the surfaces in it, model units
};

/// Closed loops one after the other, and back over their first points to the first one of all, so
/// that the steps from loop to loop cancel out in areas.
std::vector<SurfacePoint> joined_loops(const std::vector<std::vector<SurfacePoint>>& loops);

struct SurfaceIntersection {
  Status status = Status::Complete;
  std::vector<IntersectionCurve> curves;
  std::vector<SurfacePoint> points;  ///< isolated contacts
  std::vector<SurfacePoint> nodes;   ///< where branches cross
  std::vector<Overlap> overlaps;     ///< also listed in `places`
  std::vector<Place> places;
  Certificate certificate;
};

}  // namespace blossom
