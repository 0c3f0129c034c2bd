// SPDX-License-Identifier: LGPL-2.1-or-later
// The borders of a chamfer: in each plane across the edge, a point of each face at a given distance
// from it.
//
//   (S - E) . E' = 0,   |S - E| = d      by Newton's method in the chart of each face
//   (S - P) . m = 0                      for the second one, if an angle at the first, P, is given
//
// Past its ends a spline edge is where the surfaces of its two faces cross: its own polynomials
// lead away from that within a few spans.

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
#include "adapters/occt/faces/surface_projector.h"
#include "core/forms/spline.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// Radians: the way past an end is looked for from there, which after a quarter of a turn is as
/// near to it as to the opposite side of a round face.
inline constexpr double kMaxTurn = 1;

inline constexpr const char* kNoBorderPoint =
    "a face has no point at the chamfer's distance from the edge";

/// A point of a border.
struct BorderPoint {
  Vec3 point;  ///< model units
  Vec2 uv;     ///< in the parameters of the face's surface
};

/// One face beside a point of an edge.
struct BesideEdge {
  Vec3 normal;   ///< outwards, unit
  Vec3 inwards;  ///< into the face, across the edge, unit
  Vec2 uv;       ///< in the parameters of the face's surface
};

/// A point of an edge, or of its way on past an end.
struct EdgePlace {
  Vec3 point;
  Vec3 along;  ///< unit
  std::array<BesideEdge, 2> sides;
};

/// An edge that is cut off. Sides: the face to the left of the forward edge, the one to the right.
struct Chamfering {
  const BodyEdges& body;
  int edge;
  bool concave;
  ChamferProfile profile;
  Handle(Geom_Curve) curve{};
  Interval domain{};
  /// Where borders have to be: of strips on other faces than the edge's a part of the domain.
  Interval sure{};
  std::array<int, 2> faces{};
  /// Parameters of a point near the border of another face than the edge's.
  std::array<std::optional<Vec2>, 2> near{};
  std::array<Handle(Geom_Surface), 2> surfaces{};
  std::array<std::optional<SurfaceProjector>, 2> feet{};  ///< of elementary surfaces

  /// The edge at a parameter; past an end of a spline as far beyond the plane across it as the
  /// speed there says. Nothing where the surfaces do not cross on, or the way there turns by a
  /// radian.
  std::optional<EdgePlace> place_at(double x) const;

  /// Both points of the plane across the edge at a parameter, which may be past its ends; nothing
  /// where a face has none.
  std::optional<std::array<BorderPoint, 2>> at_edge(double x) const;

  /// throws   FilletRefused, with the place on the edge
  [[noreturn]] void refuse(const std::string& cause, double x) const;

  std::optional<BorderPoint> solved(std::size_t side, Vec2 uv, const Vec3& across,
                                    const std::function<std::pair<double, Vec3>(const Vec3&)>& f,
                                    const Vec3& origin) const;

 private:
  EdgePlace on_edge(double x) const;
  std::optional<EdgePlace> past_end(const EdgePlace& end, double way) const;
  Vec2 step_to(std::size_t side, const Vec2& from, const Vec3& point) const;
};

/// Both borders by the edge's parameter, all with the same knots: pieces of degree 5 with common
/// tangents, but where a face or the edge has a crease.
struct FittedBorders {
  Interval range;  ///< what of the wanted one
  std::array<Spline, 2> rows;
  std::array<Spline2, 2> charts;
};

/// Pieces are halved until rows leave the borders, and the images of charts leave the rows, by no
/// more than 1e-8 model units. Past what is sure the range ends where borders do.
///
/// throws   FilletRefused where the edge has no borders, or none that pieces come near to
///
/// Source: interpolation at Chebyshev's nodes, Trefethen 2013, "Approximation Theory and
/// Approximation Practice", chapter 2.
FittedBorders fitted_borders(const Chamfering& of, const Interval& range);

}  // namespace blossom::occt
