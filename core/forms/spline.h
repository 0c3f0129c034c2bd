// SPDX-License-Identifier: LGPL-2.1-or-later
// B-spline curves, as the engine writes intersection curves back.

#pragma once

#include <vector>

#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

/// A clamped, not periodic, polynomial B-spline curve.
template <class Point>
struct SplineOf {
  int degree = 0;
  std::vector<double> knots;        ///< strictly increasing break points
  std::vector<int> multiplicities;  ///< one per knot; degree + 1 at both ends
  std::vector<Point> points;        ///< sum of multiplicities - degree - 1 control points

  Interval domain() const { return {knots.front(), knots.back()}; }
  friend bool operator==(const SplineOf&, const SplineOf&) = default;
};

using Spline = SplineOf<Vec3>;
using Spline2 = SplineOf<Vec2>;

/// The point of the spline at parameter `t`, clamped to the domain.
/// Source: de Boor's algorithm.
Vec3 point_at(const Spline& spline, double t);
Vec2 point_at(const Spline2& spline, double t);

/// The first derivative by the parameter.
Vec3 derivative_at(const Spline& spline, double t);
Vec2 derivative_at(const Spline2& spline, double t);

/// Of the largest parameter of a spline's domain: knots nearer to each other are rounding apart.
inline constexpr double kSameKnot = 0x1p-47;

/// True if an interval is longer than the rounding of a domain's parameters.
bool is_span(const Interval& part, const Interval& domain);

/// The part of a spline on an interval of its domain, with the same parameters. The p control
/// points next to a new end are blossoms at that end and the knots beside it, convex combinations
/// of the old ones; all others are kept bit for bit. Knots that are rounding apart from its ends
/// are left out.
/// throws   InvalidInput if the interval is empty or leaves the domain
/// Source: Ramshaw 1989, Proposition 9.1.
Spline restricted(const Spline& spline, const Interval& part);
Spline2 restricted(const Spline2& spline, const Interval& part);

/// `second` appended to `first`, its parameters moved on to follow. The ends must meet and the
/// degrees agree; the join is written as merely continuous, whatever it is.
/// throws   InvalidInput if the degrees differ
Spline joined(const Spline& first, const Spline& second);
Spline2 joined(const Spline2& first, const Spline2& second);

/// Of the largest coordinate of a spline: pieces whose control points differ by no more from those
/// of a join with continuous curvature have one. What Hermite's data are rounded by is below.
inline constexpr double kSmoothJoin = 0x1p-40;

/// A spline of Bezier pieces without the copies of knots that it does not need: where two pieces
/// have the same first and second derivative, to `kSmoothJoin`, their knot stands degree - 2 times.
/// Points move by no more than that. Splines that are not in such pieces, or of a degree below 3,
/// come back as they are.
/// Source: Ramshaw 1989, Proposition 9.1: the new control points are blossoms.
Spline without_idle_knots(const Spline& spline);
Spline2 without_idle_knots(const Spline2& spline);

}  // namespace blossom
