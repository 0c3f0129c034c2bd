// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/neighbours/along_shared_edges.h"

#include <algorithm>
#include <cstddef>

namespace blossom::occt {
namespace {

constexpr double kEdgeReach = 4;     // of a shared edge's tolerance: what is so near is the edge
constexpr double kEdgeStrip = 2e-3;  // of the faces' size: so near, smooth faces are one
constexpr int kFootSteps = 8;        // to the nearest point of a shared edge

// From the nearest chord between its samples on by Newton's method.
double distance_to(const IntersectionCurve& edge, const Vec3& p) {
  double least = 1e300, nearest = 0;
  for (std::size_t i = 0; i + 1 < edge.samples.size(); ++i) {
    const Vec3 from = edge.samples[i].point, step = edge.samples[i + 1].point - from;
    const double square = dot(step, step);
    const double t = square > 0 ? std::clamp(dot(p - from, step) / square, 0.0, 1.0) : 0.0;
    const double gap = distance(p, from + step * t);
    if (gap >= least) continue;
    least = gap;
    nearest = at(Interval{edge.sample_parameters[i], edge.sample_parameters[i + 1]}, t);
  }
  for (int i = 0; i < kFootSteps; ++i) {
    const Vec3 along = derivative_at(edge.curve, nearest);
    const double square = dot(along, along);
    if (square > 0)
      nearest = std::clamp(nearest + dot(p - point_at(edge.curve, nearest), along) / square,
                           edge.curve.knots.front(), edge.curve.knots.back());
  }
  return distance(p, point_at(edge.curve, nearest));
}

}  // namespace

KnownCurve known_curve(const SharedEdge& edge, double size) {
  KnownCurve known{{}, std::max(kEdgeReach * edge.tolerance, kEdgeStrip * size), 0};
  for (const SurfacePoint& x : edge.curve.samples) known.points.push_back(x.point);
  known.gap = edge.gap;
  return known;
}

void drop_along_edges(SurfaceIntersection& found, std::vector<Touch>& touches,
                      const std::vector<SharedEdge>& edges, double tolerance) {
  const auto along_edge = [&](const Vec3& p) {
    return std::any_of(edges.begin(), edges.end(), [&](const SharedEdge& edge) {
      return distance_to(edge.curve, p) <= kEdgeReach * std::max(edge.tolerance, tolerance);
    });
  };
  std::erase_if(found.curves, [&](const IntersectionCurve& curve) {
    return std::all_of(curve.samples.begin(), curve.samples.end(),
                       [&](const SurfacePoint& x) { return along_edge(x.point); });
  });
  std::erase_if(found.points, [&](const SurfacePoint& x) { return along_edge(x.point); });
  std::erase_if(touches, [&](const Touch& touch) { return along_edge(touch.at.point); });
}

}  // namespace blossom::occt
