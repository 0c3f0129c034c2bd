// SPDX-License-Identifier: LGPL-2.1-or-later
// Stretches of a face's edges that are graphs over a coordinate of its chart, and what lies beside
// them: from there, parameter lines lead to the edge.

#pragma once

#include <optional>
#include <vector>

#include "core/math/interval.h"
#include "core/plane/planar_curves.h"
#include "core/topology/face_trims.h"

namespace blossom {

/// A stretch of an edge past a rectangle of the chart.
struct CoedgeStretch {
  Interval range;                    ///< of the edge's parameter
  int along = 0;                     ///< the chart coordinate that grows or falls all along it
  double inner = 0;                  ///< sign: the face is there by the other coordinate
  std::vector<PlanarBezier> pieces;  ///< in order
  PlanarBox box;                     ///< of the pieces
  double shortfall = 0;  ///< its end does not reach the rectangle's by so much, chart coordinates
};

/// The parameter of an edge's point that is nearest to another point of the chart, or as near as it
/// but for little.
double foot_on(const Coedge& edge, const Vec2& target);

/// The stretch of an edge nearest to a rectangle that goes past all of it, as far as the edge does;
/// nothing if the edge is far or turns back there.
std::optional<CoedgeStretch> stretch_past(const Coedge& edge, const PlanarBox& box);

/// Whether all of the face in a rectangle is proven to lie on the stretch's inner side. The rest of
/// the edge has to keep out of the rectangle, other edges of the face out of it or to that side.
bool lies_beside(const FaceTrims& trims, const Coedge& edge, const CoedgeStretch& stretch,
                 const PlanarBox& box);

}  // namespace blossom
