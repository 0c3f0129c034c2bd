// SPDX-License-Identifier: LGPL-2.1-or-later
// The sides of the unit square of a patch, their points, and those that are poles.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/cells/direction_cones.h"
#include "core/cells/surface_cells.h"
#include "core/forms/patch.h"

namespace blossom {

inline constexpr std::array kCorners{Vec2{0, 0}, Vec2{0, 1}, Vec2{1, 0}, Vec2{1, 1}};

/// A side of the square of a patch.
struct PatchSide {
  std::size_t across = 0;  ///< u or v is constant,
  bool high = false;       ///< at 1 rather than 0

  friend bool operator==(const PatchSide&, const PatchSide&) = default;

  double value() const { return high ? 1 : 0; }
  std::size_t along() const { return 1 - across; }
  std::array<Interval, 2> range() const {
    std::array<Interval, 2> range{Interval{0, 1}, Interval{0, 1}};
    range[across] = {value(), value()};
    return range;
  }
  Vec2 at(double t) const {
    Vec2 x;
    x[static_cast<int>(across)] = value();
    x[static_cast<int>(along())] = t;
    return x;
  }
};

/// A control point, homogeneous.
const Vec4& corner_point(const RationalBezierPatch& patch, const Vec2& corner);

/// The control points, homogeneous.
std::vector<Vec4> side_points(const RationalBezierPatch& patch, const PatchSide& side);

/// The sides of a patch on the border of its surface; where that is closed there is none.
std::vector<PatchSide> outer_sides(const SurfaceCells& cells, int patch);

PoleSide pole_side(const PatchSide& side);

/// A bound on the distance of the side's points from the pole, roundings included, if its control
/// points are no farther from it than `nearest`, model units.
std::optional<double> pole_gap(const RationalBezierPatch& patch, const PatchSide& side,
                               const Vec3& pole, double nearest);

/// The patch with the pole in all points of the side.
RationalBezierPatch with_pole(RationalBezierPatch patch, const PatchSide& side, const Vec3& pole);

}  // namespace blossom
