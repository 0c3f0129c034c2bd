// SPDX-License-Identifier: LGPL-2.1-or-later
// Proof that a part of a surface does not meet itself, by the directions of its derivatives.
//
// Let p and q be parameters that a path joins on which neither u nor v turns back. Along it
//   S(q) - S(p) = a U +- b V,   a, b >= 0,
// where U lies in the convex cone of all S_u on the path and V in that of all S_v; a or b is 0 only
// if the path has no step in u or in v. If some projection to a plane shows the cones of +-U and
// +-V to be apart, then S(p) != S(q). Two cells that touch, in a side or a corner, have such a path
// for every two of their points. Only directions matter, so every cell may have its own scale of
// parameters, and kinks between cells do no harm.
//
// At a pole S_u vanishes. There S = P + r T(u, r) with r the distance of the parameter to the
// pole's; S_u = r T_u with r >= 0, so that T_u takes the place of S_u.
//
// Source: mean value theorem; for the projection to a plane compare Gale and Nikaido 1965.

#pragma once

#include <array>

#include "core/cells/cell_tree.h"
#include "core/forms/surface.h"

namespace blossom {

/// Unit vectors at right angles. The bounds below are boxes along these axes; the third one is the
/// direction along which derivatives vary most, so that it widens no other coordinate. Over a plane
/// to which heights are added it is the direction of the heights.
using Axes = std::array<Vec3, 3>;

/// The axes for a surface, from samples of its derivatives.
Axes axes_of(const BezierSurface& surface);

/// Bounds of S_u and S_v over a part of a surface, each up to positive factors; coordinates along
/// the axes.
struct DirectionCones {
  VectorBounds u;
  VectorBounds v;
};

/// A border of a patch that is one point.
enum class PoleSide { LowU, HighU, LowV, HighV };

/// Differences of the homogeneous net of a patch: its derivatives without the degrees. Directions
/// on small cells are taken from them, since differences of a cell's own points would be rounding.
struct SlopeNets {
  RationalBezierPatch points;  ///< of the patch itself
  RationalBezierPatch u;
  RationalBezierPatch v;
  bool rational = false;
  double scale = 0;  ///< largest absolute value in the net of the patch, and in its points in space
  double heaviest = 0;        ///< weight
  double given_rounding = 0;  ///< of a coordinate of the patch in space
};

/// given_rounding  of a coordinate of the patch in space, as it is
SlopeNets slope_nets(const RationalBezierPatch& patch, bool rational, double given_rounding);

/// Over a rectangle of a patch.
DirectionCones cones_of(const SlopeNets& nets, const Interval& u, const Interval& v,
                        const Axes& axes);

/// Over a rectangle with one side in a pole.
/// pole      its point, as the points of the net
DirectionCones cones_at_pole(const SlopeNets& nets, const Interval& u, const Interval& v,
                             PoleSide side, const Vec3& pole, const Axes& axes);

/// The smallest that hold both.
DirectionCones joined(const DirectionCones& a, const DirectionCones& b);

/// True if it is proven that no two points which a path as above joins have the same image.
/// Between points of one pole nothing is claimed.
bool is_injective(const DirectionCones& cones);

/// Where `is_injective_with_jump` holds and two points have one image, the part in u of a path that
/// joins them, and that in v, is no longer in space than so many times what it jumps by.
inline constexpr double kJumpReach = 2001;

/// As `is_injective`, for paths that jump once in space: the cones are apart by some angle, narrow,
/// and seen from aside they look long enough.
bool is_injective_with_jump(const DirectionCones& cones);

/// A rectangle of a patch with a side in a pole.
struct PolePart {
  const SlopeNets& nets;
  Interval u, v;
  PoleSide side;
};

/// True if two rectangles with sides in the same pole have nothing but the pole in common: a plane
/// through the pole is between them.
/// sine      of the angle between the plane and what leads from the pole to their points, at least
bool meet_in_pole_only(const PolePart& a, const PolePart& b, const Vec3& pole, double sine = 0);

}  // namespace blossom
