// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/face_borders.h"

#include <algorithm>
#include <cmath>

#include "core/base/not_zero.h"
#include "core/tessellation/limits.h"

namespace blossom {
namespace {

constexpr std::size_t kPolePoints = 8;  // along a border that is a point in space
constexpr double kStraight = 1e-9;      // relative to the side

double relative_height(const Vec2& a, const Vec2& middle, const Vec2& b) {
  const Vec2 d = b - a;
  return std::abs(cross(d, middle - a)) / std::max(dot(d, d), kNotZero);
}

}  // namespace

FacePolygon::FacePolygon(const ModelFace& face, const std::vector<EdgePolyline>& polylines) {
  for (std::size_t k = 0; k < face.chart.borders.size(); ++k) take(face, k, polylines);
  if (points.empty()) return;
  low = high = points.front();
  for (const Vec2& p : points)
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
}

int FacePolygon::place_of(const Vec2& uv, const PolylinePoint& origin) {
  const auto [found, is_new] = places_.try_emplace({uv[0], uv[1]}, static_cast<int>(points.size()));
  if (is_new) {
    points.push_back(uv);
    origins.push_back(origin);
  }
  return found->second;
}

void FacePolygon::take(const ModelFace& face, std::size_t number,
                       const std::vector<EdgePolyline>& polylines) {
  const RegionBorder& border = face.chart.borders[number];
  const int edge = face.edges[number];
  const EdgePolyline& line = polylines[static_cast<std::size_t>(edge)];
  const bool is_point = line.segments() == 0;
  const std::size_t count = is_point ? kPolePoints : line.segments();
  const Interval own = border.curve.domain();
  const auto parameter = [&](double step) {  // of the border, at a place of the polyline
    if (is_point) return at(own, step / static_cast<double>(count));
    const std::vector<double>& t = line.parameters();
    const auto k = std::min(static_cast<std::size_t>(step), count - 1);
    const double there = at({t[k], t[k + 1]}, step - static_cast<double>(k));
    const Interval of_edge{t.front(), t.back()};
    return own == of_edge ? there : at(own, (there - of_edge.from) / length(of_edge));
  };
  const auto corner = [&](int k) { return face.chart.corners[static_cast<std::size_t>(k)]; };
  const auto origin = [&](std::size_t k) { return PolylinePoint{edge, is_point ? 0 : k}; };
  Vec2 before = corner(border.from);
  int last = place_of(before, origin(border.reversed ? count : 0));
  // A point in space whose ends are one corner goes round nothing.
  if (is_point && corner(border.to) == before) return;
  for (std::size_t k = 1; k <= count; ++k) {
    const std::size_t here = border.reversed ? count - k : k;  // of the polyline
    const Vec2 uv = k == count ? corner(border.to)
                               : point_at(border.curve, parameter(static_cast<double>(here)));
    const int place = place_of(uv, origin(here));
    const std::size_t segment = border.reversed ? here : here - 1;
    const Vec2 middle = point_at(border.curve, parameter(static_cast<double>(segment) + 0.5));
    if (place != last)
      sides.push_back({last,
                       place,
                       {is_point ? -1 : edge, segment},
                       relative_height(before, middle, uv) < kStraight});
    before = uv;
    last = place;
  }
}

std::vector<EdgeSegment> FacePolygon::too_far(const ChartSurface& surface, double deviation) const {
  std::vector<EdgeSegment> found;
  for (const PolygonSide& side : sides) {
    if (side.segment.edge < 0) continue;
    const Vec2& a = points[static_cast<std::size_t>(side.from)];
    const Vec2& b = points[static_cast<std::size_t>(side.to)];
    const Vec2 d = absolute(b - a);
    if (d[0] <= kSmallestPart * (high[0] - low[0]) && d[1] <= kSmallestPart * (high[1] - low[1]))
      continue;
    if (surface.facet_distance({a, b, b}, surface.frame_at(a).normal) > deviation)
      found.push_back(side.segment);
  }
  return found;
}

}  // namespace blossom
