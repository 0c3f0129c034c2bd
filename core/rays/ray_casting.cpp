// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/rays/ray_casting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/errors.h"
#include "core/rays/patch_cells.h"
#include "core/rays/ray_batches.h"

namespace blossom {
namespace {

// Parameters of one root that two cells of a patch find differ by rounding only.
constexpr double kSameRoot = 1e-8;

void validate(const Ray& ray) {
  if (!is_finite(ray.origin)) throw InvalidInput("ray: the origin is not finite");
  if (!is_finite(ray.direction)) throw InvalidInput("ray: the direction is not finite");
  const double square = dot(ray.direction, ray.direction);
  if (!(square > 0) || !std::isfinite(1 / square) || !std::isfinite(square))
    throw InvalidInput("ray: the direction is zero, or too short or long for its square");
  if (!(ray.from <= ray.to)) throw InvalidInput("ray: its end must not be before its start");
}

double checked(const Tolerances& tolerances) {
  if (!(tolerances.point > 0) || !std::isfinite(tolerances.point))
    throw InvalidInput("RayCaster: the tolerance must be positive");
  return tolerances.point;
}

bool is_same(const RayHit& a, const RayHit& b, double tolerance) {
  const bool proven_a = a.status == Status::Complete, proven_b = b.status == Status::Complete;
  if (!proven_a && !proven_b) return true;  // their stretches touch
  // A stretch takes in the roots of its own surface, and edges of others that it meets.
  if (!proven_a || !proven_b) return a.surface == b.surface || (proven_a ? a : b).border;
  if (distance(a.point, b.point) > 2 * tolerance) return false;
  if (a.patch == b.patch && max_norm(a.local - b.local) <= kSameRoot) return true;
  return a.border && b.border;
}

bool is_certain(const RayHit& hit) { return hit.status == Status::Complete || hit.approximate; }

// A stretch is known by a proven root at its beginning, if there is one.
// near   parameters that differ by no more are one place
void join(RayHit& into, const RayHit& hit, double near) {
  const double first = std::min(into.first, hit.first), last = std::max(into.last, hit.last);
  const bool grazing = into.grazing || hit.grazing, border = into.border || hit.border;
  const Status status = weaker(into.status, hit.status);
  const bool approximate = status != Status::Complete && is_certain(into) && is_certain(hit);
  const int mark = std::max(into.mark, hit.mark);
  if (into.status != Status::Complete && hit.status == Status::Complete &&
      hit.parameter <= into.parameter + near)
    into = hit;
  into.first = first;
  into.last = last;
  into.grazing = grazing;
  into.border = border;
  into.status = status;
  into.approximate = approximate;
  into.mark = mark;
}

}  // namespace

void join_hits(std::vector<RayHit>& hits, double speed, double tolerance) {
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    return a.first != b.first ? a.first < b.first : a.parameter < b.parameter;
  });
  const double near = 2 * tolerance / speed;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    std::size_t same = kept;
    for (std::size_t k = kept; k-- > 0 && same == kept;)
      if (hits[k].last + near >= hits[i].first && is_same(hits[k], hits[i], tolerance)) same = k;
    if (same < kept)
      join(hits[same], hits[i], near);
    else
      hits[kept++] = hits[i];
  }
  hits.resize(kept);
  std::sort(hits.begin(), hits.end(),
            [](const RayHit& a, const RayHit& b) { return a.parameter < b.parameter; });
}

RayCaster::RayCaster(std::vector<BezierSurface> surfaces, const Tolerances& tolerances,
                     std::vector<double> reaches)
    : cells_(std::move(surfaces), checked(tolerances), std::move(reaches)),
      tree_(cells_.boxes()),
      tolerance_(tolerances.point) {}

std::vector<RayHit> RayCaster::all_hits(const Ray& ray) const {
  RayQuery query(*this);
  const std::span<const RayHit> hits = query.all_hits(ray);
  return {hits.begin(), hits.end()};
}

std::vector<RayHit> RayCaster::first_hits(const Ray& ray) const {
  RayQuery query(*this);
  const std::span<const RayHit> hits = query.first_hits(ray);
  return {hits.begin(), hits.end()};
}

std::vector<std::vector<RayHit>> RayCaster::all_hits(std::span<const Ray> rays) const {
  for (const Ray& ray : rays) validate(ray);
  return for_all_rays<RayQuery>(
      *this, rays, [](RayQuery& query, const Ray& ray) { return query.all_hits(ray); });
}

std::vector<std::vector<RayHit>> RayCaster::first_hits(std::span<const Ray> rays) const {
  for (const Ray& ray : rays) validate(ray);
  return for_all_rays<RayQuery>(
      *this, rays, [](RayQuery& query, const Ray& ray) { return query.first_hits(ray); });
}

RayQuery::RayQuery(const RayCaster& caster)
    : caster_(caster), search_(caster.cells_, caster.tolerance_) {}

// Of the hits found last, those within the ray that count.
void RayQuery::keep(std::size_t from, const Ray& ray, const HitFilter& accept) {
  const double slack = caster_.tolerance_ / norm(ray.direction);
  for (std::size_t i = from; i < hits_.size(); ++i) {
    RayHit& hit = hits_[i];
    if (hit.last < ray.from - slack || hit.first > ray.to + slack) continue;
    const BezierSurface& surface = caster_.cells_.surfaces()[static_cast<std::size_t>(hit.surface)];
    hit.approximate = surface.error > 0 && hit.status == Status::Complete;
    if (surface.error > 0) hit.status = weaker(hit.status, Status::Tolerance);
    if (accept && !accept(hit)) continue;
    hits_[from++] = hit;
  }
  hits_.resize(from);
}

void RayQuery::collect(const Ray& ray, const HitFilter& accept, bool first_only) {
  validate(ray);
  hits_.clear();
  search_.aim(ray);
  const double speed = norm(ray.direction);
  const double slack = 4 * caster_.tolerance_ / speed;
  double wanted = ray.to + slack;
  LineProbe probe{ray.origin, ray.direction, ray.from - slack, wanted};
  caster_.tree_.for_each_along(probe, [&](int patch, double) {
    probe.to = wanted;
    caster_.cells_.cells_of(patch).for_each_along(probe, [&](const FlatCell& cell) {
      const std::size_t before = hits_.size();
      search_.examine(cell, hits_);
      keep(before, ray, accept);
      for (std::size_t i = before; first_only && i < hits_.size(); ++i)
        if (hits_[i].status == Status::Complete)
          wanted = std::min(wanted, hits_[i].parameter + slack);
      return wanted;
    });
    return wanted;
  });
  join_hits(hits_, speed, caster_.tolerance_);
}

std::span<const RayHit> RayQuery::all_hits(const Ray& ray, const HitFilter& accept) {
  collect(ray, accept, false);
  return hits_;
}

std::span<const RayHit> RayQuery::first_hits(const Ray& ray, const HitFilter& accept) {
  collect(ray, accept, true);
  const auto proven = std::find_if(
      hits_.begin(), hits_.end(), [](const RayHit& hit) { return hit.status == Status::Complete; });
  if (proven != hits_.end()) hits_.erase(proven + 1, hits_.end());
  return hits_;
}

}  // namespace blossom
