// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/chart_projector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/unbounded.h"
#include "core/math/periods.h"

namespace blossom {
namespace {

constexpr int kNewtonSteps = 4;      // from a foot that was searched for
constexpr int kMaxNewtonSteps = 16;  // from another place; fewer where they come no nearer
constexpr double kSeam = 1e-9;       // of the parameters' range: so near a seam is on it

}  // namespace

Vec2 chart_step(const SurfaceJet& at, const Vec3& step) {
  const Vec3 area = cross(at.du, at.dv);
  const double square = dot(area, area);
  if (!(square > 0)) return {};
  return {dot(cross(step, at.dv), area) / square, dot(cross(at.du, step), area) / square};
}

ChartProjector::ChartProjector(ProjectedSurface surface, double tolerance, PolledLimit* limit)
    : surface_(std::move(surface)), tolerance_(tolerance), limit_(limit) {}

Vec2 ChartProjector::foot(const Vec3& point, const std::optional<Vec2>& near) const {
  if (limit_ && limit_->reached()) throw LimitReached();
  const Vec2 uv = nearest(point, near);
  return near ? in_turn_of(*near, uv) : uv;
}

// Any of those that a period or a seam leaves to choose from.
Vec2 ChartProjector::nearest(const Vec3& point, const std::optional<Vec2>& near) const {
  if (surface_.exact) return surface_.search(point);
  // A point that the surface has within tolerance needs no search over all of it.
  const auto beside = near ? sharpened(point, bounded(*near), kMaxNewtonSteps) : Sharpened{};
  if (near && beside.gap <= tolerance_) return beside.uv;
  const int steps = surface_.rough ? kMaxNewtonSteps : kNewtonSteps;
  return sharpened(point, surface_.search(point), steps).uv;
}

// By whole periods, and from one side of a seam to the other.
Vec2 ChartProjector::in_turn_of(const Vec2& near, Vec2 uv) const {
  const Vec2 &low = surface_.low, &high = surface_.high;
  const Vec2 &period = surface_.period, &closed = surface_.closed;
  for (int k = 0; k < 2; ++k) {
    uv[k] = unwrapped(uv[k], near[k], period[k]);
    if (closed[k] == 0) continue;
    const double slack = kSeam * closed[k];
    if (uv[k] < low[k] + slack && near[k] > uv[k] + 0.5 * closed[k])
      uv[k] = high[k];
    else if (uv[k] > high[k] - slack && near[k] < uv[k] - 0.5 * closed[k])
      uv[k] = low[k];
  }
  return uv;
}

// By Newton's method as long as it comes no further away.
ChartProjector::Sharpened ChartProjector::sharpened(const Vec3& point, Vec2 uv, int steps) const {
  SurfaceJet at = surface_.jet(uv);
  double gap = distance(at.point, point);
  for (int i = 0; i < steps; ++i) {
    const Vec2 next = bounded(uv + within_half_turns(chart_step(at, point - at.point)));
    const SurfaceJet there = surface_.jet(next);
    const double next_gap = distance(there.point, point);
    if (!(next_gap <= gap)) break;
    const bool settled = next_gap == gap || next == uv;
    uv = next;
    at = there;
    gap = next_gap;
    if (settled) break;
  }
  return {uv, gap};
}

double ChartProjector::gap(const Vec3& point, const Vec2& uv) const {
  return distance(point, surface_.jet(uv).point);
}

double ChartProjector::clearance(const Vec3& point, const Vec2& uv) const {
  const SurfaceJet at = surface_.jet(uv);
  double inside = kInfinity;
  for (int k = 0; k < 2; ++k)
    if (surface_.period[k] == 0)
      inside = std::min({inside, (uv[k] - surface_.low[k]) * norm(k == 0 ? at.du : at.dv),
                         (surface_.high[k] - uv[k]) * norm(k == 0 ? at.du : at.dv)});
  if (inside > 0) return inside;
  const Vec2 step = chart_step(at, point - at.point);
  return -norm(step[0] * at.du + step[1] * at.dv);
}

const SurfacePole* ChartProjector::pole_at(const Vec3& point) const {
  for (const SurfacePole& pole : surface_.poles)
    if (distance(pole.point, point) <= tolerance_) return &pole;
  return nullptr;
}

double ChartProjector::height(const Vec3& point) const {
  const SurfaceJet at = surface_.jet(foot(point, {}));
  return std::copysign(distance(point, at.point), dot(point - at.point, cross(at.du, at.dv)));
}

// Beside a pole a short step in space may be one of many turns.
Vec2 ChartProjector::within_half_turns(Vec2 step) const {
  for (int k = 0; k < 2; ++k)
    if (surface_.period[k] > 0)
      step[k] = std::clamp(step[k], -0.5 * surface_.period[k], 0.5 * surface_.period[k]);
  return step;
}

Vec2 ChartProjector::bounded(Vec2 uv) const {
  for (int k = 0; k < 2; ++k)
    if (surface_.period[k] == 0) uv[k] = std::clamp(uv[k], surface_.low[k], surface_.high[k]);
  return uv;
}

}  // namespace blossom
