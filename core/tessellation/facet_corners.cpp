// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/facet_corners.h"

#include <algorithm>
#include <cmath>

#include "core/tessellation/limits.h"

namespace blossom {

FacetCorners::FacetCorners(const ShapeModel& model, const std::vector<EdgePolyline>& polylines,
                           const ChartSurface& surface, const FacePolygon& polygon)
    : model_(model), polylines_(polylines), surface_(surface), polygon_(polygon) {}

void FacetCorners::take_polygon(std::size_t count) {
  corners_.resize(count);
  moved_.assign(count, 0);
  poles_.assign(count, -1);
  for (const PolygonSide& side : polygon_.sides) {
    if (side.segment.edge >= 0) continue;
    const Vec2 d = absolute(polygon_.points[index(side.to)] - polygon_.points[index(side.from)]);
    if (d[0] > 0 && d[1] > 0) continue;
    poles_[index(side.from)] = poles_[index(side.to)] = d[0] > 0 ? 0 : 1;
  }
  for (std::size_t i = 0; i < polygon_.points.size(); ++i) {
    const PointNormal frame = surface_.frame_at(polygon_.points[i]);
    corners_[i] = {polygon_.origins[i], polygon_.points[i], point_of(polygon_.origins[i]),
                   frame.normal};
    moved_[i] = distance(frame.point, corners_[i].point);
  }
}

void FacetCorners::add_inner(const Vec2& uv) {
  const PointNormal frame = surface_.frame_at(uv);
  corners_.push_back({{}, uv, frame.point, frame.normal});
  moved_.push_back(0);
  poles_.push_back(-1);
}

Vec3 FacetCorners::area_of(const FacetTriangle& facet) const {
  const auto point = [&](std::size_t k) { return corners_[index(facet[k])].point; };
  return cross(point(1) - point(0), point(2) - point(0));
}

Vec3 FacetCorners::normal_at(const FacetTriangle& facet) const {
  const Vec3 area = area_of(facet);
  Vec3 best;
  double most = -1;
  for (const int corner : facet) {
    const Vec3& n = corners_[index(corner)].normal;
    const double along = std::abs(dot(n, area));
    if (!(dot(n, n) > 0) || along <= most) continue;
    best = n;
    most = along;
  }
  return best;
}

std::array<Vec2, 3> FacetCorners::parameters_of(const FacetTriangle& facet) const {
  std::array<Vec2, 3> uv;
  for (std::size_t k = 0; k < 3; ++k) uv[k] = corners_[index(facet[k])].uv;
  for (std::size_t k = 0; k < 3; ++k) {
    const int pole = poles_[index(facet[k])];
    if (pole < 0) continue;
    const int along = pole == 0 ? 0 : 1;
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    if (poles_[index(facet[a])] >= 0 || poles_[index(facet[b])] >= 0) continue;
    uv[k][along] = 0.5 * (uv[a][along] + uv[b][along]);
  }
  return uv;
}

bool FacetCorners::is_small(const FacetTriangle& facet) const {
  const Vec2& a = corners_[index(facet[0])].uv;
  for (const int corner : facet)
    for (int k = 0; k < 2; ++k)
      if (std::abs(corners_[index(corner)].uv[k] - a[k]) >
          kSmallestPart * (polygon_.high[k] - polygon_.low[k]))
        return false;
  return true;
}

double FacetCorners::moved_of(const FacetTriangle& facet) const {
  double most = 0;
  for (const int corner : facet) most = std::max(most, moved_[index(corner)]);
  return most;
}

bool FacetCorners::is_flat(const FacetTriangle& facet) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const PolylinePoint& a = corners_[index(facet[k])].origin;
    const PolylinePoint& b = corners_[index(facet[(k + 1) % 3])].origin;
    if (a.edge < 0 || b.edge < 0) continue;
    if (vertex_of(a) >= 0 && vertex_of(a) == vertex_of(b)) return true;
    if (a.edge == b.edge && a.number == b.number) return true;
  }
  return false;
}

double FacetCorners::longest_side(const FacetTriangle& facet) const {
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k)
    most = std::max(
        most, distance(corners_[index(facet[k])].point, corners_[index(facet[(k + 1) % 3])].point));
  return most;
}

bool FacetCorners::is_folded(const FacetTriangle& facet) const {
  return dot(area_of(facet), normal_at(facet)) < 0;
}

CommonPoint FacetCorners::common_point(const PolylinePoint& origin) const {
  const int vertex = vertex_of(origin);
  return vertex >= 0 ? CommonPoint{-1, index(vertex)} : CommonPoint{origin.edge, origin.number};
}

Vec3 FacetCorners::point_of(const PolylinePoint& origin) const {
  const EdgePolyline& line = polylines_[index(origin.edge)];
  const ModelEdge& edge = model_.edges[index(origin.edge)];
  if (origin.number == 0) return model_.vertices[index(edge.from)];
  if (origin.number == line.segments()) return model_.vertices[index(edge.to)];
  return line.points()[origin.number];
}

int FacetCorners::vertex_of(const PolylinePoint& origin) const {
  const ModelEdge& edge = model_.edges[index(origin.edge)];
  if (origin.number == 0) return edge.from;
  return origin.number == polylines_[index(origin.edge)].segments() ? edge.to : -1;
}

}  // namespace blossom
