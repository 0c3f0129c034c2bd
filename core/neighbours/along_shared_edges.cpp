// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/neighbours/along_shared_edges.h"

#include <algorithm>
#include <cstddef>

#include "core/base/unbounded.h"
#include "core/math/segment.h"
#include "core/neighbours/limits.h"

namespace blossom {
namespace {

constexpr double kEdgeReach = 4;  // of a shared edge's tolerance: what is so near is the edge
constexpr int kFootSteps = 8;     // to the nearest point of a shared edge

// From the nearest chord between its samples on by Newton's method.
double distance_to(const IntersectionCurve& edge, const Vec3& p) {
  double least = kUnbounded, nearest = 0;
  for (std::size_t i = 0; i + 1 < edge.samples.size(); ++i) {
    const Vec3 from = edge.samples[i].point, to = edge.samples[i + 1].point;
    const double t = nearest_part(p, from, to);
    const double gap = distance(p, from + t * (to - from));
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

double distance_to(const std::vector<SharedEdge>& edges, const Vec3& p) {
  double least = kUnbounded;
  for (const SharedEdge& edge : edges) least = std::min(least, distance_to(edge.curve, p));
  return least;
}

double loosest(const std::vector<SharedEdge>& edges, double tolerance) {
  for (const SharedEdge& edge : edges) tolerance = std::max(tolerance, edge.tolerance);
  return tolerance;
}

// Where the search could not tell what is beside a known curve, it lists the curve's box without
// parameters.
bool is_known_curve(const Place& place) {
  return place.kind == PlaceKind::Tangential && place.parameters == Place{}.parameters;
}

}  // namespace

KnownCurve known_curve(const SharedEdge& edge, double size) {
  KnownCurve known{{}, std::max(kEdgeReach * edge.tolerance, kEdgeStrip * size), 0};
  for (const SurfacePoint& x : edge.curve.samples) known.points.push_back(x.point);
  known.gap = edge.gap;
  return known;
}

bool keeps_to_edges(const Vec3& point, const std::vector<SharedEdge>& edges, double tolerance) {
  return std::ranges::any_of(edges, [&](const SharedEdge& edge) {
    return distance_to(edge.curve, point) <= kEdgeReach * std::max(edge.tolerance, tolerance);
  });
}

bool keeps_to_edges(const IntersectionCurve& curve, const std::vector<SharedEdge>& edges,
                    double tolerance) {
  return std::ranges::all_of(curve.samples, [&](const SurfacePoint& x) {
    return keeps_to_edges(x.point, edges, tolerance);
  });
}

void drop_along_edges(SurfaceIntersection& found, std::vector<Touch>& touches,
                      const std::vector<SharedEdge>& edges, double tolerance) {
  std::erase_if(found.curves, [&](const IntersectionCurve& curve) {
    return keeps_to_edges(curve, edges, tolerance);
  });
  std::erase_if(found.points,
                [&](const SurfacePoint& x) { return keeps_to_edges(x.point, edges, tolerance); });
  std::erase_if(touches, [&](const Touch& touch) {
    return keeps_to_edges(touch.at.point, edges, tolerance);
  });
}

void drop_places_along_edges(SurfaceIntersection& found, const std::vector<SharedEdge>& edges,
                             double tolerance) {
  const double reach = kEdgeReach * loosest(edges, tolerance);
  std::erase_if(found.places, [&](const Place& place) {
    if (is_known_curve(place)) return true;
    if (place.kind == PlaceKind::Open || place.kind == PlaceKind::Overlap) return false;
    const double half = 0.5 * distance(place.box_low, place.box_high);
    return half <= reach &&
           distance_to(edges, 0.5 * (place.box_low + place.box_high)) + half <= reach;
  });
}

}  // namespace blossom
