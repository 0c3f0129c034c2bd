// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/rays/line_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/math/roundoff.h"
#include "core/rays/limits.h"

namespace blossom {
namespace {

// Of a region: a slack beyond that takes in what its neighbours have.
constexpr double kMaxSlack = 0.25;
// Newton's method squares its error, so a step of this size ends at rounding.
constexpr double kLastStep = 1e-8;
constexpr int kNewtonSteps = 12;
// An area of the parallelogram of derivatives this far below that of the cell has no direction.
constexpr double kSingular = 1e-9;

}  // namespace

// A root within rounding of the border belongs to the region, and one within tolerance.
double LineSearch::clamped_slack(double tolerance, double rounding) {
  return std::clamp(std::max(tolerance, 4 * rounding), kRootSlack, kMaxSlack);
}

LineSearch::LineSearch(const FlatCells& cells, double tolerance)
    : cells_(cells), tolerance_(tolerance) {
  nets_.resize(static_cast<std::size_t>((kPlaces + 3) * 2 * cells.largest_net()));
  stack_.reserve(static_cast<std::size_t>(kPlaces));
}

void LineSearch::aim(const Ray& ray) {
  ray_ = ray;
  square_ = dot(ray.direction, ray.direction);
  direction_scale_ = max_norm(ray.direction);
}

void LineSearch::examine(const FlatCell& cell, std::vector<RayHit>& hits) {
  cell_ = &cell;
  if (cell.regular) {
    const Guess first = guess(cell);
    if (first.excluded) return;
    patch_ = placed().patch;
    anchor_ = point_at(ray_, dot(cell.centre - ray_.origin, ray_.direction) / square_);
    if (first.contracts && settle(first.region, first.root, hits) != Verdict::Open) return;
  }
  patch_ = placed().patch;
  anchor_ = point_at(ray_, dot(cell.centre - ray_.origin, ray_.direction) / square_);
  search(hits);
}

// Seen along the line, on the plane (centre, N), a point of the cell has the coordinates
//   G(x) = D (r - (N . r / N . d) d),   r = S(x) - origin,
// which differ from x - root by no more than spread + |D . d / N . d| tilt. A line in the plane of
// the cell gives infinite or no numbers; then nothing follows from them.
LineSearch::Guess LineSearch::guess(const FlatCell& cell) const {
  Guess result;
  result.region.u = cell.u;
  result.region.v = cell.v;
  const Vec3 r = cell.centre - ray_.origin;
  const double per_normal = 1 / dot(cell.normal, ray_.direction);
  const double t = dot(cell.normal, r) * per_normal;
  const Vec3 q = r - t * ray_.direction;
  const double error = cells_.evaluation_error() * cells_.scale() +
                       8 * kUnitRoundoff * (max_norm(ray_.origin) + std::abs(t) * direction_scale_);
  const double reach = cells_.patches()[static_cast<std::size_t>(cell.patch)].reach;
  Vec2 value;
  bool exact = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const int k = static_cast<int>(i);
    const double lean = std::abs(dot(cell.dual[i], ray_.direction) * per_normal);
    for (std::size_t j = 0; j < 2; ++j)
      result.region.spread[i][j] = cell.spread[i][j] + lean * cell.tilt[j];
    value[k] = dot(cell.dual[i], q);
    result.region.rounding[k] = 4 * error * (cell.dual_length[i] + lean);
    result.region.slack[k] = clamped_slack(reach * cell.dual_length[i], result.region.rounding[k]);
    const double bound = 0.5 * (1 + result.region.spread[i][0] + result.region.spread[i][1]) +
                         result.region.rounding[k] + result.region.slack[k];
    result.excluded = result.excluded || std::abs(value[k]) > bound;
    exact = exact && result.region.rounding[k] < kPlaceable;
  }
  result.root = {at(cell.u, 0.5 - value[0]), at(cell.v, 0.5 - value[1])};
  result.contracts = exact && is_contraction(result.region.spread);
  return result;
}

// The one root that a region can have: found by Newton's method, or proven not to be there.
LineSearch::Verdict LineSearch::settle(const Region& region, const Vec2& start,
                                       std::vector<RayHit>& hits) {
  const Newton root = newton(region, start);
  const std::array<Interval, 2> sides{region.u, region.v};
  Vec2 nearest = root.converged ? root.local : start, outside;
  bool inside = root.converged;
  for (int k = 0; k < 2; ++k) {
    const Interval& side = sides[static_cast<std::size_t>(k)];
    const double x = (nearest[k] - side.from) / length(side) - 0.5;
    inside = inside && std::abs(x) <= 0.5 + region.slack[k];
    if (std::abs(x) < 0.5) continue;
    outside[k] = x < 0 ? -1 : 1;
    nearest[k] = x < 0 ? side.from : side.to;
  }
  if (inside) {
    add_hit(root, hits);
    return Verdict::Root;
  }
  if (leads_outside(region.spread, offset_at(region, nearest), region.rounding, outside))
    return Verdict::Empty;
  return Verdict::Open;
}

// How far a point is from the root, to first order, in parameters of the region.
Vec2 LineSearch::offset_at(const Region& region, const Vec2& local) const {
  if (region.net == nullptr) {
    const Vec3 r = jet_at(*patch_, local[0], local[1], 1).point - anchor_;
    const double t = dot(cell_->normal, r) / dot(cell_->normal, ray_.direction);
    const Vec3 q = r - t * ray_.direction;
    return {dot(cell_->dual[0], q), dot(cell_->dual[1], q)};
  }
  return product(region.inverse, values_at({rows_, columns_, 2}, region.net,
                                           (local[0] - region.u.from) / length(region.u),
                                           (local[1] - region.v.from) / length(region.v)));
}

LineSearch::Newton LineSearch::newton(const Region& region, const Vec2& start) const {
  Newton result;
  result.local = start;
  const Vec2 size{length(region.u), length(region.v)};
  const Vec2 centre{at(region.u, 0.5), at(region.v, 0.5)};
  const Vec3& d = ray_.direction;
  for (int step = 0; step < kNewtonSteps; ++step) {
    for (int k = 0; k < 2; ++k)
      if (!(std::abs(result.local[k] - centre[k]) <= 1.5 * size[k])) return result;
    result.jet = jet_at(*patch_, result.local[0], result.local[1], 1);
    const PatchJet& jet = result.jet;
    const Vec3 r = anchor_ - jet.point;
    const double per_area = 1 / dot(cross(jet.u, jet.v), d);
    const Vec2 move{dot(r, cross(jet.v, d)) * per_area, dot(r, cross(d, jet.u)) * per_area};
    result.local += move;
    if (std::abs(move[0]) <= std::max(kLastStep, region.rounding[0]) * size[0] &&
        std::abs(move[1]) <= std::max(kLastStep, region.rounding[1]) * size[1]) {
      result.point = jet.point + move[0] * jet.u + move[1] * jet.v;
      result.converged = true;
      return result;
    }
  }
  return result;
}

// False if the neighbour answers for it.
bool LineSearch::add_hit(const Newton& root, std::vector<RayHit>& hits) const {
  RayHit hit;
  hit.patch = cell_->patch;
  hit.surface = placed().surface;
  hit.point = root.point;
  hit.local = root.local;
  hit.parameter = dot(root.point - ray_.origin, ray_.direction) / square_;
  hit.first = hit.last = hit.parameter;
  // At a singular point the normal is that of the cell's middle.
  Vec3 area = cross(root.jet.u, root.jet.v);
  const double part = length(cell_->u) * length(cell_->v);
  if (norm(area) * part <= kSingular * cell_->reach[0] * cell_->reach[1]) area = cell_->normal;
  hit.normal = unit(area);
  hit.grazing = std::abs(dot(area, ray_.direction)) < kGrazing * norm(area) * std::sqrt(square_);
  const std::array<const Vec3*, 2> derivatives{&root.jet.u, &root.jet.v};
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(k);
    // A length along the surface; at a collapsed side all of it is one point.
    const double speed = norm(*derivatives[i]);
    const double from_border = std::min(hit.local[k], 1 - hit.local[k]);
    hit.border = hit.border || from_border <= kRootSlack || from_border * speed <= tolerance_;
    if (from_border >= 0) continue;
    const bool ends = hit.local[k] < 0 ? placed().ends_low[i] : placed().ends_high[i];
    const double beyond = -from_border * speed;
    if (from_border < -kRootSlack && beyond > (ends ? placed().reach : tolerance_)) return false;
    hit.beyond = std::max(hit.beyond, beyond);
    hit.local[k] = std::clamp(hit.local[k], 0.0, 1.0);
  }
  if (hit.beyond > 0) hit.point = jet_at(*patch_, hit.local[0], hit.local[1], 1).point;
  hit.uv = cells_.parameters(hit.patch, hit.local);
  hits.push_back(hit);
  return true;
}

}  // namespace blossom
