// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/ball_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "core/blending/balls/detail/ball_equations.h"
#include "core/blending/balls/detail/ball_tracer.h"
#include "core/blending/balls/offset_surface.h"
#include "core/surface_intersection.h"

namespace blossom {
namespace {

// Relative to the parts' extents: both are solutions to rounding.
constexpr double kSamePoint = 1e-8;
constexpr int kFootSteps = 20;

// The way between charts relative to the extents; in closed directions that to the nearest image.
Vec4 way_between(const BallSystem& system, const Vec4& from, const Vec4& to) {
  Vec4 way;
  for (int k = 0; k < 4; ++k) {
    const BezierSurface& s = *system.supports()[static_cast<std::size_t>(k / 2)].surface;
    const std::vector<double>& knots = k % 2 == 0 ? s.u_knots : s.v_knots;
    way[k] = to[k] - from[k];
    if (k % 2 == 0 ? s.closed_u : s.closed_v)
      way[k] = std::remainder(way[k], knots.back() - knots.front());
    way[k] /= system.extents()[k];
  }
  return way;
}

// The charts of a ball, or their rates.
Vec4 joined(const Vec2& a, const Vec2& b) { return {a[0], a[1], b[0], b[1]}; }

// True if the track passes the solution x: by the foot on the track in charts, from the nearest
// node.
bool is_on(const BallSystem& system, const BallTrack& track, const Vec4& x) {
  const auto nearer = [&](const BallTrack::Node& a, const BallTrack::Node& b) {
    return norm(way_between(system, a.chart, x)) < norm(way_between(system, b.chart, x));
  };
  double s = std::min_element(track.nodes().begin(), track.nodes().end(), nearer)->parameter;
  for (int step = 0; step < kFootSteps; ++step) {
    const BallPoint ball = track.at(s);
    const auto& [a, b] = ball.contacts;
    const Vec4 way = way_between(system, joined(a.chart, b.chart), x);
    if (norm(way) < kSamePoint) return true;
    Vec4 rate = joined(a.chart_rate, b.chart_rate);
    for (int k = 0; k < 4; ++k) rate[k] /= system.extents()[k];
    const double next =
        std::clamp(s + dot(way, rate) / dot(rate, rate), track.domain().from, track.domain().to);
    if (next == s) return false;
    s = next;
  }
  return false;
}

// A point in the middle of a curve.
const SurfacePoint& middle_of(const IntersectionCurve& curve) {
  return curve.samples[curve.samples.size() / 2];
}

}  // namespace

BallSpines ball_spines(const BallSupport& a, const BallSupport& b, double radius,
                       const BallSpineOptions& options) {
  validate(a, "a");
  validate(b, "b");
  validate_radius(radius);
  OffsetSurface offset_a =
                    offset_surface(*a.surface, a.part, a.side * radius, options.fit_tolerance),
                offset_b =
                    offset_surface(*b.surface, b.part, b.side * radius, options.fit_tolerance);
  // The search is for the curves of the fits themselves: it answers for those.
  offset_a.surface.error = offset_b.surface.error = 0;
  SurfaceIntersection found = intersect(offset_a.surface, offset_b.surface, options.intersection);
  BallSpines result;
  result.status = found.status;
  result.offset_errors = {offset_a.error, offset_b.error};
  result.offset_slope_errors = {offset_a.slope_error, offset_b.slope_error};
  result.certificate = std::move(found.certificate);
  result.places = std::move(found.places);
  const auto system = std::make_shared<const BallSystem>(
      std::array{a, b}, RadiusLaw::constant(radius), std::function<MovingPlane(double)>{});
  for (const IntersectionCurve& curve : found.curves) {
    const SurfacePoint& middle = middle_of(curve);
    const auto x =
        system->nearest({middle.uv_a[0], middle.uv_a[1], middle.uv_b[0], middle.uv_b[1]});
    const auto known = [&](const BallSpine& spine) { return is_on(*system, spine.track, *x); };
    if (x && std::any_of(result.spines.begin(), result.spines.end(), known)) continue;
    auto track = x ? traced(system, *x, 0) : std::nullopt;
    if (track) {
      result.spines.push_back(with_stretches(std::move(*track)));
    } else {
      result.lost.push_back(middle);
      result.status = weaker(result.status, Status::Tolerance);
    }
  }
  return result;
}

int nearest_spine(const BallSpines& spines, const Vec3& point) {
  int best = -1;
  double least = 1e300;
  for (std::size_t i = 0; i < spines.spines.size(); ++i)
    for (const BallTrack::Node& node : spines.spines[i].track.nodes()) {
      const BallPoint ball = spines.spines[i].track.at(node.parameter);
      for (const BallContact& contact : ball.contacts) {
        const double off = distance(contact.point, point);
        if (off < least) least = off, best = static_cast<int>(i);
      }
    }
  return best;
}

}  // namespace blossom
