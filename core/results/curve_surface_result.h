// SPDX-License-Identifier: LGPL-2.1-or-later
// What an intersection of a curve and a surface is: points, common runs, and how far all that is
// proven.

#pragma once

#include <vector>

#include "core/results/curve_result.h"

namespace blossom {

/// A point common to curve and surface. Parameters are their own.
struct CurveSurfacePoint {
  Vec3 point;
  double t = 0;
  Vec2 uv;
  bool tangential = false;  ///< the curve touches the surface
  /// True if there is one common point within `box_t`, proven. False: a contact; its place is
  /// listed.
  bool proven = false;
  Interval box_t;  ///< parameters, increasing
};

/// A run of the curve within tolerance of the surface. Where it begins or ends, and where patches
/// join, a stretch no longer than a touch may belong to it of which `gap_high` and `proven` do not
/// tell: there they are a few tolerances apart at most.
struct CurveSurfaceOverlap {
  Interval t;           ///< increasing
  Vec2 uv_from, uv_to;  ///< at its ends
  double gap_high = 0;  ///< largest distance in it, model units
  bool proven = false;  ///< by comparing coefficients; else the gap is the largest at samples
};

struct CurveSurfaceIntersection {
  Status status = Status::Complete;
  std::vector<CurveSurfacePoint> points;  ///< by increasing t; each once
  std::vector<CurveSurfaceOverlap> overlaps;
  std::vector<CurvePlace> places;  ///< `b` is not used
  CurveCertificate certificate;    ///< the least angle is that between curve and tangent plane
};

}  // namespace blossom
