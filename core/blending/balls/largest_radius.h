// SPDX-License-Identifier: LGPL-2.1-or-later
// The largest radius with which a ball rolls along an edge of two surfaces, and what stops it.

#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/blending/balls/ball_track.h"

namespace blossom {

enum class RadiusLimit {
  None,       ///< none up to the largest radius asked for
  Curvature,  ///< the ball has a radius of curvature of a surface at the contact
  Border,     ///< a contact reaches a border of its face
  Facing,     ///< the ball's diameter is the distance of two walls
  Other,      ///< none of these, the surfaces touch, say; the radius is good to 1e-3 of it
};

const char* to_string(RadiusLimit limit);

/// A border of a face as the contacts see it: a function of the chart that is positive inside, with
/// a zero of the first order. The borders where the edge ends are none of them.
struct ContactBorder {
  int support = 0;  ///< 0 or 1
  std::function<double(const Vec2&)> inside;
};

struct LargestRadius {
  RadiusLimit limit = RadiusLimit::None;
  double radius = 0;  ///< model units
  int support = -1;   ///< whose curvature or border; -1: of both
  int border = -1;    ///< index of the border
  Vec3 centre;        ///< of the ball there
  std::array<Vec2, 2> charts{};
  double parameter = 0;  ///< of the track at a radius just below
};

/// The largest radius.
///
/// start     charts of the edge's middle on both surfaces; the ball is followed from there
/// most      radii above this are not asked for, model units
/// returns   the least radius at which, growing from `least`, the track from the edge's one end to
///           the other stops being valid: bracketed by halving, to which a smaller gap in radii is
///           invisible; nothing if there is no valid track at `least`
/// throws    InvalidInput as `track_through`, or if `least` is not below `most`
///
/// The limit is the solution of five equations in the charts and r: the ball touches both, and a
/// determinant (curvature) or a border's function is 0 and least along the spine, or 0 at an end of
/// it, or both normals are opposite (facing).
std::optional<LargestRadius> largest_radius(const BallSupport& a, const BallSupport& b,
                                            const std::array<Vec2, 2>& start, double least,
                                            double most,
                                            const std::vector<ContactBorder>& borders = {});

}  // namespace blossom
