// SPDX-License-Identifier: LGPL-2.1-or-later
// Layouts of quads over a regular polygon, the domain of an n-sided fill.
//
// The polygon has its corners P_k on the unit circle, at the angles 2 pi k / n; side k runs from
// P_k to P_(k+1) and is halved by M_k. Every quad is the image of the unit square under a bilinear
// map. A layout is the same in each of the n sectors, so only the quads of sector 0 are listed.
//
//   star       n quads   P M c M'                        no inner edge at a corner of the polygon
//   ring      3n quads   two at each side, one at c      one inner edge there
//   deep ring 5n quads   three at each corner, two at c  two inner edges there
//
// How many inner edges leave a corner decides which data a layout can take (see fill.h).
//
// Notation: c centre; h = pi / n half the angle of a sector.

#pragma once

#include <array>
#include <vector>

#include "core/math/vec.h"

namespace blossom {

enum class FillLayout { Star, Ring, DeepRing };

/// "star", "ring" or "deep ring".
const char* to_string(FillLayout layout);

/// The fewest and most sides that a layout is made for: as many as systems in use ask for. With
/// two sides there is no polygon.
inline constexpr int kMinFillSides = 3;
inline constexpr int kMaxFillSides = 12;

/// A vertex of a layout: a role and the sector in which it plays it. The centre is in sector 0.
struct LayoutVertex {
  int role = 0;
  int sector = 0;
  friend bool operator==(const LayoutVertex&, const LayoutVertex&) = default;
};

/// Corners against the clock: the images of (0,0), (1,0), (1,1), (0,1).
struct LayoutQuad {
  std::array<LayoutVertex, 4> corners;
};

/// An edge of a quad: edge e runs from corner e to corner e + 1 and has the quad on its left.
struct QuadEdge {
  int quad = 0;    ///< in sector 0
  int edge = 0;    ///< 0..3
  int sector = 0;  ///< the quad is the one of this sector
};

/// An inner edge, seen from both of its quads; they run along it in opposite directions.
struct SharedQuadEdge {
  QuadEdge a;  ///< in sector 0
  QuadEdge b;
};

struct PolygonLayout {
  FillLayout kind = FillLayout::Star;
  int sides = 0;
  int centre = 0;                      ///< the role of the centre, the last one
  std::vector<Vec2> places;            ///< of each role in sector 0
  std::vector<LayoutQuad> quads;       ///< of sector 0
  std::array<QuadEdge, 2> borders;     ///< the halves of side 0: from P_0 to M_0, from M_0 to P_1
  std::vector<SharedQuadEdge> shared;  ///< one of each n inner edges that are turned copies
};

/// The layout over the polygon with `sides` sides. Inner vertices are the means of their
/// neighbours, so every quad is strictly convex (Tutte 1963).
/// throws    InvalidInput unless sides is within kMinFillSides..kMaxFillSides
PolygonLayout polygon_layout(FillLayout kind, int sides);

/// The angle between neighbouring sectors: 2 pi / n, radians.
double sector_angle(int sides);

/// The place of a vertex in the plane of the polygon.
Vec2 place_of(const PolygonLayout& layout, const LayoutVertex& vertex);

/// The corners of a quad of sector 0, turned so that `edge` runs from the first to the second.
std::array<Vec2, 4> corners_from(const PolygonLayout& layout, const QuadEdge& edge);

}  // namespace blossom
