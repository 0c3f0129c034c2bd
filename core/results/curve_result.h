// SPDX-License-Identifier: LGPL-2.1-or-later
// What an intersection of two curves is: points, common runs, and how far all that is proven.

#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/results/result.h"

namespace blossom {

/// A point common to both curves. Parameters are the curves' own.
struct CurvePoint {
  Vec3 point;
  double a = 0;
  double b = 0;
  bool tangential = false;  ///< the curves touch: they have one direction here, to rounding
  /// True if the boxes below hold one common point and no other. In the plane, and for curves that
  /// share an end, that is a proof. In space it means that the curves are within rounding of each
  /// other in one place: no computation with rounded input can tell more. False: a contact; its
  /// place is listed.
  bool proven = false;
  Interval box_a;  ///< parameters, increasing
  Interval box_b;
};

/// A run along which the curves stay within tolerance of each other.
struct CurveOverlap {
  Interval a;           ///< increasing
  Interval b;           ///< the parameters of b at the ends of `a`; may decrease
  double gap_high = 0;  ///< largest distance of the curves in it, model units
  bool proven = false;  ///< by comparing coefficients; else the gap is the largest at samples
};

/// A place in which the curves stay within tolerance of each other without crossing for sure, or
/// which stayed open.
///
///   touch       a point of contact: directions agree, or an end, or a near miss in space
///   tangential  a point of contact at which the curves change sides, in the plane
///   cusp        of a curve that meets itself
///   overlap     a common run
///   open        not decided
struct CurvePlace {
  PlaceKind kind = PlaceKind::Open;
  Vec3 box_low;  ///< axis-parallel box, model units
  Vec3 box_high;
  double gap_low = 0;  ///< distance of the curves in the place, model units
  double gap_high = 0;
  Interval a;  ///< parameters, increasing
  Interval b;
};

/// What was examined and how it ended; the numbers behind the status.
struct CurveCertificate {
  long excluded = 0;                 ///< pairs of pieces proven to have no common point
  long certified = 0;                ///< pairs of pieces proven to hold the points found there only
  long contacts = 0;                 ///< pairs of pieces that stay within tolerance of each other
  int depth = 0;                     ///< deepest bisection of a span
  double rounding_bound = 0;         ///< largest rounding margin added to a net, model units
  double least_angle = 0;            ///< least angle at the proven points, radians; 0 without any
  std::vector<std::string> reasons;  ///< why the status is not complete
};

struct CurveIntersection {
  Status status = Status::Complete;
  std::vector<CurvePoint> points;  ///< by increasing parameter of a; each once
  std::vector<CurveOverlap> overlaps;
  std::vector<CurvePlace> places;
  CurveCertificate certificate;
};

}  // namespace blossom
