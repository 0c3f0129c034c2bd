// SPDX-License-Identifier: LGPL-2.1-or-later
// The strip that a rolling ball leaves: a surface between its two contact curves.
//
// The envelope of the balls touches each of them along its characteristic circle
//
//   c* = c - r r' c' / |c'|^2,   r* = r sqrt(1 - r'^2 / |c'|^2),   in the plane across c',
//
// on which both contacts lie; a constant radius has c* = c, r* = r. With e_i = (p_i - c*) / r* the
// arc between the contacts is the rational quadratic with the points and weights
//
//   p_1, 1;   M = c* + r* (e_1 + e_2) / (1 + e_1.e_2), w = sqrt((1 + e_1.e_2) / 2);   p_2, 1
//
// so sections of the strip are arcs, and only the rows p_1, w M, w, p_2 along the spine are fitted,
// together with the contacts in both charts.

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/blending/balls/ball_track.h"
#include "core/forms/elementary.h"
#include "core/forms/spline.h"
#include "core/forms/surface.h"

namespace blossom {

enum class SectionKind {
  Circle,         ///< the ball's
  Conic,          ///< the conic with the same ends and tangents; `rho` as in the options
  Curvature,      ///< degree 5, with the curvatures of both surfaces across the contacts; no edges
  CurvatureRate,  ///< degree 7, also with the rates at which these change across the contacts
  Chamfer,        ///< the chord
};

/// Whether sections have the curvatures of the surfaces.
constexpr bool takes_curvature(SectionKind kind) {
  return kind == SectionKind::Curvature || kind == SectionKind::CurvatureRate;
}

struct BallStripOptions {
  SectionKind section = SectionKind::Circle;
  double rho = 0.5;  ///< of a conic, in (0, 1): shoulder = (1 - rho) chord's middle + rho M

  double gap = 1e-8;    ///< wanted, of contact rows and charts and of sections, model units
  double angle = 2e-7;  ///< wanted, between the strip's and the surfaces' normals, radians
  int most_spans = 400;
};

/// How well the strip meets one of its supports.
struct StripContactCurve {
  /// The contact in the parameters of the support's surface, continuous over seams, (u, 0) on an
  /// edge; knots and multiplicities are those of the strip.
  Spline2 chart;
  Spline row;  ///< the strip's border, the same knots: v = 0 or v = 1

  double gap = 0;      ///< largest distance of the row from the chart's image, model units
  bool proven = true;  ///< false: `gap` is the largest of samples only
  /// Largest of samples, radians; on an edge between the strip's normals and the ball's.
  double normal_angle = 0;
};

/// The strip as a piece of a cylinder, cone, sphere or torus. Angles are radians, right-handed
/// about the axis from the direction x; the contact curves are the borders of the piece.
struct AnalyticStrip {
  Elementary surface;  ///< of a cylinder and a cone the axis points along the spine
  Vec3 x;              ///< unit, across the axis

  /// Along the spine. Cylinder: heights over `centre`. Cone: heights over the apex along the axis.
  /// Torus: angles about the axis.
  Interval along;
  /// From contact 1 to contact 2. Cylinder and cone: angles about the axis. Torus: angles about the
  /// tube from the outward direction towards the axis. May run backwards.
  Interval across;
};

struct BallStrip {
  /// u along the spine, by the track's parameter; v in [0, 1] from contact 1 to contact 2. Circles
  /// are of degree 2 in v, and of degree 4 where some section is larger than 120 degrees.
  BezierSurface surface;

  /// The same surface's homogeneous rows along u as one spline: degree 5, control points of row j
  /// in column j.
  std::vector<double> knots;
  std::vector<int> multiplicities;
  Grid<Vec4> poles;

  std::array<StripContactCurve, 2> contacts;
  double section_error = 0;  ///< largest distance from the true arc at samples, model units
  bool closed = false;       ///< the end is the start, with a common tangent plane
  std::optional<AnalyticStrip> analytic{};
};

/// The strip along a part of a track.
///
/// range     inside of the track's domain; there the stretch has to be valid
/// returns   gap, angles and section error as wanted, or less good with what was reached, when
///           `most_spans` is not enough
/// throws    InvalidInput if the range is empty or leaves the domain, rho is not in (0, 1),
///           continuous curvature is asked for on an edge, or the balls have no envelope:
///           |r'| >= |c'|, named with its parameter
BallStrip ball_strip(const BallTrack& track, const Interval& range,
                     const BallStripOptions& options = {});

/// Strips along one track, one after the other: each begins with the spans of the one before it as
/// far as its range has them, so a strip that grows is not sampled and halved anew.
class StripMaker {
 public:
  /// track   has to outlive this
  explicit StripMaker(const BallTrack& track, const BallStripOptions& options = {});
  ~StripMaker();
  StripMaker(const StripMaker&) = delete;
  StripMaker& operator=(const StripMaker&) = delete;

  /// As `ball_strip`, but for other knots.
  BallStrip strip(const Interval& range);

 private:
  struct Known;

  const BallTrack& track_;
  BallStripOptions options_;
  std::unique_ptr<Known> known_;
};

}  // namespace blossom
