// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves in faces round the corners of strips.

#pragma once

#include <Geom2d_BezierCurve.hxx>
#include <Geom_Surface.hxx>

#include "core/math/vec.h"

namespace blossom::occt {

/// Where a path begins or ends: in a contact, which it goes on smoothly, or anywhere else.
struct PathEnd {
  Vec2 chart;
  /// Along the contact towards the corner, of unit length in space; 0 for any direction.
  Vec2 ahead{};
  /// The way to where the contact meets the other one, or the edge at the other end; 0 if it does
  /// not, or behind: between contacts then that to where their tangents meet. Model units.
  double leg = 0;
};

/// A path on a surface from one end to the other: a cubic in the chart that turns as evenly as a
/// circle does where both ends are alike.
Handle(Geom2d_BezierCurve)
    corner_path(const Handle(Geom_Surface) & surface, const PathEnd& from, const PathEnd& to);

}  // namespace blossom::occt
