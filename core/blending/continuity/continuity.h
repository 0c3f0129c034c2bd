// SPDX-License-Identifier: LGPL-2.1-or-later
// How smoothly two faces meet along their common edge.
//
// Three figures, none of which depends on parameters, on the order of the faces or on their
// orientation:
//
//   gap         distance of the two images of the edge, model units
//   angle       between the normals, radians: 0 where one face continues the other, pi where it
//               folds back on it
//   curvature   |A - B| / max(|A|, |B|, flat), dimensionless; A and B are the shape operators in
//               the frame of the edge, | | the largest absolute eigenvalue
//
// Where the normals agree along an edge, the shape operators agree but for the normal curvature
// across it, so |A - B| is the difference of these.
//
// They are measured for any two surfaces, and bounded where both images of the edge are Bezier
// curves with the same parameter.

#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/unbounded.h"
#include "core/blending/surface_side.h"
#include "core/forms/curve_spans.h"
#include "core/forms/evaluation.h"
#include "core/forms/surface.h"
#include "core/math/vec.h"

namespace blossom {

/// One face beside an edge, at one parameter of the edge.
struct EdgeSide {
  PatchJet jet;      ///< of the surface where the edge's image is, with second derivatives
  Vec2 along;        ///< derivative of the image by the edge's parameter, in the jet's parameters
  bool left = true;  ///< the face lies to the left of it, as seen against S_u x S_v
};

/// A face beside an edge, by the edge's parameter.
using EdgeSides = std::function<EdgeSide(double)>;

/// The largest value found and where.
struct LargestFound {
  double value = 0;
  double parameter = 0;  ///< of the edge
  Vec3 point{};          ///< on the first face
};

struct MeasuredContinuity {
  LargestFound gap;         ///< model units
  LargestFound angle;       ///< radians
  LargestFound difference;  ///< |A - B|, 1 / model unit
  LargestFound curvature;   ///< relative
  int samples = 0;          ///< places looked at before the refinement at the largest
  int singular = 0;         ///< of these, where a surface has no tangent plane; only gaps are there
};

/// The figures of two faces along an edge: the largest at samples inside of all spans, refined
/// between the neighbours of the largest. Values at the breaks are limits from inside of spans.
/// A point is compared with the nearest one of the other border, found by Newton's method from the
/// same parameter.
///
/// breaks   at least two increasing parameters of the edge; surfaces and images are smooth between
/// flat     curvature that counts as none, 1 / model unit, > 0
/// returns  lower bounds of the true maxima
/// throws   InvalidInput if breaks do not increase or flat is not positive
MeasuredContinuity measured_continuity(const EdgeSides& a, const EdgeSides& b,
                                       std::span<const double> breaks, double flat);

/// Homogeneous control points of a face beside an edge, over one span of it:
///   X(t) image of the edge, Y(t) and Z(t) first and second derivative into the face.
/// X / w is the image, and Y, Z are derivatives of the homogeneous form.
struct BorderSpan {
  Interval place;    ///< in the edge's parameter, increasing
  double angle = 0;  ///< of an arc that the edge's parameter is proportional to; 0: to t itself
  std::vector<Vec4> edge;
  std::vector<Vec4> across;
  std::vector<Vec4> bend;
  /// Bounds on errors of the control points, by coordinate.
  Vec4 error{}, across_error{}, bend_error{};
};
using BorderSpans = std::vector<BorderSpan>;

/// A surface beside one of its sides, with the edge's parameter running over [0, 1] in the
/// direction of the surface's own, or against it. Errors are those of kRoundings roundings of the
/// surface's points.
/// throws   InvalidInput if the surface is not well formed
BorderSpans border_spans(const BezierSurface& surface, SurfaceSide side, bool backward);

/// A plane to the left of a curve in it, as seen against its unit normal; likewise.
/// throws   InvalidInput if the curve is not well formed
BorderSpans plane_border(const CurveSpans& curve, const Vec3& normal, bool backward);

/// What control points that come from splines and arcs are off at most, in units of 2^-53 of the
/// largest coordinate: a knot insertion or a cosine, a product with the weight, a placement.
inline constexpr double kRoundings = 4;

/// The face beside the edge by these spans, over [0, 1]; parameters at breaks belong to the span
/// behind. Exact on the face's own side where it ends at a knot.
/// throws   InvalidInput if there is no span
EdgeSides edge_sides(BorderSpans spans);

/// Upper bounds; infinite where there is none, as where a surface has no tangent plane.
struct ContinuityBounds {
  double gap = kInfinity;
  double angle = kInfinity;
  double difference = kInfinity;
  double curvature = kInfinity;
};

/// The same figures bounded, at equal parameters of the edge. Pieces of it are halved until the
/// bounds are close to values inside, or of rounding size.
///
///   (1) no value at any parameter of the spans is larger, whatever the control points are within
///       their stated errors, all roundings included
///   (2) where one Bezier surface was cut in two, the bounds are a small multiple of rounding
///
/// returns  nothing if the parameters of the two borders do not correspond
/// throws   InvalidInput if flat is not positive
std::optional<ContinuityBounds> continuity_bounds(const BorderSpans& a, const BorderSpans& b,
                                                  double flat);

/// What two faces are to each other.
enum class Smoothness {
  None,  ///< apart
  G0,    ///< they meet
  G1,    ///< with one tangent plane
  G2,    ///< and one curvature
};

/// "none", "G0", "G1" or "G2".
const char* to_string(Smoothness smoothness);

struct ContinuityTolerances {
  double gap = 1e-3;        ///< model units
  double angle = 1e-3;      ///< radians
  double curvature = 1e-2;  ///< relative
};

/// What the figures say within tolerances. A figure that is missing is not within them.
Smoothness smoothness(const MeasuredContinuity& found, const ContinuityTolerances& tolerances);

/// Whether bounds prove it; what fails to be smoother was found at a point, so needs no bound.
bool is_proven(Smoothness smoothness, const ContinuityBounds& bounds,
               const ContinuityTolerances& tolerances);

}  // namespace blossom
