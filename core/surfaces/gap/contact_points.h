// SPDX-License-Identifier: LGPL-2.1-or-later
// Single points on intersection curves and contacts, by Newton's method on the original patches.
//
// Unknown are the four local parameters (u, v, s, t). `plane` fixes one linear combination of
// them: plane . x stays what it is at the start.

#pragma once

#include <optional>

#include "core/cells/points.h"

namespace blossom {

/// A smaller distance of the surfaces may be rounding. Of the tolerance.
inline constexpr double kRoundingGap = 1.0 / 64;

/// How much more A bends than B in a direction (u, v) of A, along B's normal B_s x B_t, which is
/// not normalised: where the surfaces touch, the second derivative of their gap.
double bend_between(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x,
                    const Vec2& across);

/// The point of A(u, v) = B(s, t) + apart in a plane of the parameters.
///
/// returns   nothing if the steps do not settle or lead farther than `reach` (in each parameter)
std::optional<Point4> curve_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                  const Point4& start, const Point4& plane, double reach,
                                  const Vec3& apart = {});

/// The point of A = B where the tangent direction `across` of A, in (u, v), is tangent to B
/// too: where the curve turns back with respect to the other direction.
std::optional<Point4> fold_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                 const Point4& start, const Vec2& across, double reach);

/// The line on A along which it touches B, by what the distance to B does in the direction
/// `across`: it has no slope, or, where the surfaces also cross, no bend.
struct TouchLine {
  Vec2 across;         ///< in (u, v)
  bool cross = false;  ///< contact of odd order
};

/// The point in a plane of the parameters whose foot on B is (s, t) and which lies on the line.
std::optional<Point4> touch_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                  const Point4& start, const TouchLine& line, const Point4& plane,
                                  double reach);

/// The point with the same (u, v) whose foot on B is (s, t).
std::optional<Point4> foot_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                 const Point4& start, double reach);

/// The same for k = 0 or 1; for 2 and 3 the point with the same (s, t) whose foot on A is (u, v).
std::optional<Point4> point_on_iso_line(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                        const Point4& start, int k, double reach);

/// The point within both patches nearest to one beside them: what moves to a border of one patch
/// takes its foot on the other along, as far as `reach` (in each parameter).
Point4 moved_into(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x,
                  double reach);

/// The tangent of the line at a point of it, in the four parameters, not normalised.
Point4 touch_tangent(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x,
                     const TouchLine& line);

/// The point whose foot on B is (s, t) and where both normals are parallel.
///
/// Source: Kriezis, Patrikalakis and Wolter 1992, collinear normal points.
std::optional<Point4> collinear_normal_point(const RationalBezierPatch& a,
                                             const RationalBezierPatch& b, const Point4& start,
                                             double reach);

/// The distance from A to B along B's normal at a point, signed.
double signed_gap(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x);

/// A branch that comes to an end in a contact, in the parameters of one pair of patches.
struct ContactArm {
  Point4 start;  ///< of its last arc
  Point4 end;    ///< in the contact
};

/// True if the branch goes on from the arm's end to the goal, close to the straight line, as far as
/// points on the way tell.
bool leads_to(const RationalBezierPatch& a, const RationalBezierPatch& b, const ContactArm& arm,
              const Point4& goal);

/// The point in which two branches that end in a contact go over into each other: the given
/// centre if both lead there, else where the branch turns round or passes between them. If the
/// surfaces do not quite touch, the closest point lies beside the branch: the tip of a cusp that
/// is rounded off, for one.
Point4 meeting_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                     const std::array<ContactArm, 2>& arms, const Point4& centre);

}  // namespace blossom
