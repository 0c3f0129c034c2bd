// SPDX-License-Identifier: LGPL-2.1-or-later
// The corners of a face's facets, and what follows of facets from their corners alone.

#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <vector>

#include "core/math/index.h"
#include "core/math/vec.h"
#include "core/tessellation/chart_surface.h"
#include "core/tessellation/edge_polyline.h"
#include "core/tessellation/face_borders.h"
#include "core/tessellation/shape_model.h"

namespace blossom {

/// Corners of a face have parameters and a normal of their own there: a vertex on a seam is two
/// corners, a pole several.
struct FaceCorner {
  PolylinePoint origin;  ///< no edge for a point inside of the face
  Vec2 uv;               ///< the surface's own parameters
  Vec3 point;
  Vec3 normal;  ///< unit, along S_u x S_v; zero where that vanishes
};

/// A point of edges, the same for all their faces: a vertex, by its number alone, or a point inside
/// of an edge.
struct CommonPoint {
  int edge = -1;
  std::size_t number = 0;

  friend auto operator<=>(const CommonPoint&, const CommonPoint&) = default;
};

/// A facet by the numbers of its corners.
using FacetTriangle = std::array<int, 3>;

class FacetCorners {
 public:
  /// What is given is referred to.
  FacetCorners(const ShapeModel& model, const std::vector<EdgePolyline>& polylines,
               const ChartSurface& surface, const FacePolygon& polygon);

  /// The corners of the polygon, by its numbers, and after them such that are nowhere.
  void take_polygon(std::size_t count);

  /// A corner inside of the face, with the next number.
  void add_inner(const Vec2& uv);

  std::size_t size() const { return corners_.size(); }
  const FaceCorner& operator[](int corner) const { return corners_[index(corner)]; }
  const Vec2& uv(int corner) const { return corners_[index(corner)].uv; }

  /// Twice the facet's area, along its normal.
  Vec3 area_of(const FacetTriangle& facet) const;

  /// The surface's normal at the corner that the facet is most across to, however the surface turns
  /// under it.
  Vec3 normal_at(const FacetTriangle& facet) const;

  /// All points of a border at a pole are the same: the best one is beside the other corners.
  std::array<Vec2, 3> parameters_of(const FacetTriangle& facet) const;

  /// Whether it is divided no further, see kSmallestPart.
  bool is_small(const FacetTriangle& facet) const;

  /// How far corners are off the surface, at most.
  double moved_of(const FacetTriangle& facet) const;

  /// Whether a border goes on there that is a point in space.
  bool is_at_pole(int corner) const { return poles_[index(corner)] >= 0; }

  /// Whether two corners are one point in space.
  bool is_flat(const FacetTriangle& facet) const;

  /// In space.
  double longest_side(const FacetTriangle& facet) const;

  /// Whether it is turned from the surface's normal by more than a right angle.
  bool is_folded(const FacetTriangle& facet) const;

  /// The point of edges that a corner on them is.
  CommonPoint common_point(const PolylinePoint& origin) const;

 private:
  Vec3 point_of(const PolylinePoint& origin) const;
  int vertex_of(const PolylinePoint& origin) const;

  const ShapeModel& model_;
  const std::vector<EdgePolyline>& polylines_;
  const ChartSurface& surface_;
  const FacePolygon& polygon_;
  std::vector<FaceCorner> corners_;
  std::vector<double> moved_;  // of each corner: from the surface
  std::vector<int> poles_;     // of each corner: the parameter along the pole it is at, or -1
};

}  // namespace blossom
