// SPDX-License-Identifier: LGPL-2.1-or-later
// The faces at an edge as what a ball rolls on.

#pragma once

#include <array>
#include <optional>

#include "adapters/occt/blending/body_edges.h"
#include "core/blending/balls/ball_track.h"
#include "core/forms/surface.h"

namespace blossom::occt {

/// One of the faces: its surface beyond the trims, as far as there is more of it, and past natural
/// borders as its outer patches go on. Or an edge on which the ball leans, with the angle about it.
struct RolledSupport {
  BezierSurface surface;
  Vec2 at_edge;  ///< a point of the edge, in the surface's parameters
  Vec2 start;    ///< where a ball touches about
  int side = 1;  ///< of du x dv, on which the ball is
  bool is_edge = false;

  /// Refers to the surface.
  BallSupport whole() const {
    return is_edge ? edge_support(surface) : whole_support(surface, side);
  }
};

struct RolledSupports {
  std::array<RolledSupport, 2> of;  ///< to the left of the forward edge, to the right
  double width = 0;                 ///< of contacts from the edge, of its tangent planes
  Vec3 middle;                      ///< of the edge, or the point asked for
};

/// at       parameter of the edge about which the ball is; nothing: its middle
/// throws   BadModel if a face cannot be converted
RolledSupports rolled_supports(const BodyEdges& body, int edge, bool concave, double radius,
                               const std::optional<double>& at = std::nullopt);

/// A ball that touches two faces.
struct BallPlace {
  std::array<int, 2> faces{};
  std::array<Vec2, 2> charts;  ///< of the contacts, in the parameters of the faces' surfaces
  Vec3 centre;
  Vec3 along;            ///< the way it goes, unit; the first face is to the left of it
  bool as_loop = false;  ///< whether a way that comes back to it is wanted whole
  /// The edges on which it leans in place of touching the faces, or 0. The face then is that behind
  /// the edge.
  std::array<int, 2> held{};
  std::array<double, 2> held_at{};  ///< parameters of these edges, about where it does
};

/// The same for two faces that need not have an edge in common; `middle` is the ball's centre.
RolledSupports supports_at(const BodyEdges& body, const BallPlace& place, bool concave,
                           double radius);

}  // namespace blossom::occt
