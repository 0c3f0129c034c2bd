// SPDX-License-Identifier: LGPL-2.1-or-later
// The borders of a chamfer: in each plane across the edge, a point of each face at a given distance
// from it.
//
//   (S - E) . E' = 0,   |S - E| = d      by Newton's method in the chart of each face
//   (S - P) . m = 0                      for the second one, if an angle at the first, P, is given

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "core/forms/spline.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// A point of a border.
struct BorderPoint {
  Vec3 point;  ///< model units
  Vec2 uv;     ///< in the parameters of the face's surface
};

/// An edge that is cut off. Sides: the face to the left of the forward edge, the one to the right.
struct Chamfering {
  const BodyEdges& body;
  int edge;
  bool concave;
  ChamferProfile profile;
  Handle(Geom_Curve) curve{};
  Interval domain{};
  std::array<Handle(Geom_Surface), 2> surfaces{};

  /// Both points of the plane across the edge at a parameter, which may be past its ends; nothing
  /// where a face has none.
  std::optional<std::array<BorderPoint, 2>> at_edge(double x) const;

  /// throws   FilletRefused, with the place on the edge
  [[noreturn]] void refuse(const std::string& cause, double x) const;

  std::optional<BorderPoint> solved(std::size_t side, Vec2 uv, const Vec3& across,
                                    const std::function<std::pair<double, Vec3>(const Vec3&)>& f,
                                    const Vec3& origin) const;
};

/// Both borders by the edge's parameter, all with the same knots: pieces of degree 5 with common
/// tangents, but where a face or the edge has a crease.
struct FittedBorders {
  std::array<Spline, 2> rows;
  std::array<Spline2, 2> charts;
};

/// Pieces are halved until rows leave the borders, and the images of charts leave the rows, by no
/// more than 1e-8 model units.
///
/// range    where both borders are known
/// throws   FilletRefused where they are not, or are no curves that pieces come near to
///
/// Source: interpolation at Chebyshev's nodes, Trefethen 2013, "Approximation Theory and
/// Approximation Practice", chapter 2.
FittedBorders fitted_borders(const Chamfering& of, const Interval& range);

}  // namespace blossom::occt
