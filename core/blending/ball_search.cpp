// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/ball_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "core/blending/detail/ball_equations.h"
#include "core/blending/detail/ball_tracer.h"
#include "core/blending/offset_surface.h"
#include "core/surface_intersection.h"

namespace blossom {
namespace {

// Of the parts' extents: a curve of the fitted offsets and the track are the same there.
constexpr double kSameTrack = 1e-4;

// The distance of charts, relative to the extents; of closed directions that of the nearest images.
double chart_distance(const BallSystem& system, const Vec4& a, const Vec4& b) {
  double most = 0;
  for (int k = 0; k < 4; ++k) {
    const BezierSurface& s = *system.supports()[static_cast<std::size_t>(k / 2)].surface;
    const std::vector<double>& knots = k % 2 == 0 ? s.u_knots : s.v_knots;
    const double period = knots.back() - knots.front();
    double off = a[k] - b[k];
    if (k % 2 == 0 ? s.closed_u : s.closed_v) off = std::remainder(off, period);
    most = std::max(most, std::abs(off) / system.extents()[k]);
  }
  return most;
}

// True if the track passes the ball.
bool is_on(const BallSystem& system, const BallTrack& track, const Vec4& x, const Vec3& centre) {
  const BallPoint ball = track.at(track.nearest(centre));
  const Vec4 there{ball.contacts[0].chart[0], ball.contacts[0].chart[1], ball.contacts[1].chart[0],
                   ball.contacts[1].chart[1]};
  return chart_distance(system, there, x) < kSameTrack;
}

// The point in the middle of a curve, or beside it if that is on a border.
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
    const auto known = [&](const BallSpine& spine) {
      return is_on(*system, spine.track, *x, middle.point);
    };
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
