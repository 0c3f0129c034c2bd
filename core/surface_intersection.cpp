// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surface_intersection.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/base/parallel.h"
#include "core/surfaces/assembly/surface_assembly.h"
#include "core/surfaces/retry/exchanged_order.h"
#include "core/surfaces/retry/finer_tolerance.h"
#include "core/surfaces/retry/near_origin.h"
#include "core/surfaces/retry/shorter_patches.h"

namespace blossom {
namespace {

using Clock = std::chrono::steady_clock;

// Parts of the budget: what long patches get at first, since contacts on them may spend all of it,
// and then shorter ones, so that enough is left for the long ones after all.
constexpr long kLongPatchPart = 16;
constexpr long kShortPatchPart = 4;
constexpr std::size_t kExtentBlock = 1024;  // patches whose sizes one thread adds up in a row

// What an attempt has left of the limits: of the time, and of the budget what the pairs decided
// have not taken. Nothing if there is none.
std::optional<IntersectionOptions> rest_of(IntersectionOptions options, Clock::time_point started,
                                           const Certificate& spent) {
  options.budget -= spent.excluded + spent.certified + spent.critical;
  if (options.time_limit > 0) {
    options.time_limit -= std::chrono::duration<double>(Clock::now() - started).count();
    if (!(options.time_limit > 0)) return std::nullopt;
  }
  if (options.budget <= 0) return std::nullopt;
  return options;
}

long part_of(long budget, long part) { return std::max(budget / part, 1L); }

struct Attempt {
  SurfaceIntersection found;
  std::optional<IntersectionOptions> rest;  // what it leaves for others
};

bool may_gain(const BoxedSurface& a, const BoxedSurface& b, const SurfaceIntersection& found,
              const IntersectionOptions& options) {
  return &a.surface != &b.surface &&
         should_retry_swapped(found, a.surface, b.surface, options.tolerances.point);
}

// In the order asked for; if that leaves something open, in the other one.
Attempt in_either_order(const BoxedSurface& a, const BoxedSurface& b,
                        const IntersectionOptions& options) {
  Clock::time_point started = Clock::now();
  SurfaceIntersection found = assembled(a, b, options);
  auto rest = rest_of(options, started, found.certificate);
  if (!rest || !may_gain(a, b, found, options)) return {std::move(found), rest};
  started = Clock::now();
  std::swap(rest->part_a, rest->part_b);
  SurfaceIntersection back = assembled(b, a, *rest);
  std::swap(rest->part_a, rest->part_b);
  rest = rest_of(*rest, started, back.certificate);
  if (is_gain(found, back)) found = exchanged(std::move(back), a.surface, b.surface);
  return {std::move(found), rest};
}

// What was left open, with shorter patches round it. Nothing if there are none, or if they do not
// settle it.
//
// rest   what other attempts have left; in the end what this one leaves, too
std::optional<SurfaceIntersection> in_shorter_patches(const BoxedSurface& a, const BoxedSurface& b,
                                                      const SurfaceIntersection& found,
                                                      std::optional<IntersectionOptions>& rest) {
  if (found.status != Status::Stopped || !rest) return std::nullopt;
  if (rest->cancelled && rest->cancelled()) return std::nullopt;
  const Clock::time_point started = Clock::now();
  const double tolerance = rest->tolerances.point;
  const auto short_a = with_shorter_patches(a.surface, OpenOn::First, found, tolerance);
  const auto short_b = with_shorter_patches(b.surface, OpenOn::Second, found, tolerance);
  if (!short_a && !short_b) return std::nullopt;
  const BezierSurface& of_a = short_a ? *short_a : a.surface;
  const BezierSurface& of_b = short_b ? *short_b : b.surface;
  IntersectionOptions part = *rest;
  part.budget = part_of(rest->budget, kShortPatchPart);
  SurfaceIntersection again =
      in_either_order({of_a, PatchBoxes(of_a, "a")}, {of_b, PatchBoxes(of_b, "b")}, part).found;
  rest = rest_of(*rest, started, again.certificate);
  if (again.status == Status::Stopped) return std::nullopt;
  return again;
}

// In either order, and if that leaves something open on long patches, on shorter ones. Contacts on
// long patches may take all of the budget, so that is spent on them only if shorter ones fail.
Attempt in_best_patches(const BoxedSurface& a, const BoxedSurface& b,
                        const IntersectionOptions& options) {
  const double most = longest_span(options.tolerances.point);
  const auto is_short = [&](const BoxedSurface& x) { return diagonal(x.boxes.all()) <= most; };
  if (&a.surface == &b.surface || (is_short(a) && is_short(b)))
    return in_either_order(a, b, options);
  const Clock::time_point started = Clock::now();
  IntersectionOptions sparing = options;
  sparing.budget = part_of(options.budget, kLongPatchPart);
  Attempt first = in_either_order(a, b, sparing);
  std::optional<IntersectionOptions> rest = rest_of(options, started, first.found.certificate);
  if (auto found = in_shorter_patches(a, b, first.found, rest)) return {std::move(*found), rest};
  const bool cancelled = options.cancelled && options.cancelled();
  if (!first.found.certificate.limited || !rest || cancelled) return {std::move(first.found), rest};
  return in_either_order(a, b, *rest);
}

// What stays open then, at the first finer tolerance that settles it.
SurfaceIntersection at_best_tolerance(const BoxedSurface& a, const BoxedSurface& b,
                                      const IntersectionOptions& options) {
  auto [found, rest] = in_best_patches(a, b, options);
  const double tolerance = options.tolerances.point;
  if (!may_gain(a, b, found, options) && !ends_beside_node(found)) return std::move(found);
  for (const double part : kFinerTolerances) {
    if (!rest) break;
    if (!may_be_settled(found, part * tolerance)) continue;
    const Clock::time_point started = Clock::now();
    rest->tolerances.point = part * tolerance;
    SurfaceIntersection finer = assembled(a, b, *rest);
    if (is_settled(found, finer, tolerance, part * tolerance)) return settled(std::move(finer));
    rest = rest_of(*rest, started, finer.certificate);
  }
  return std::move(found);
}

// Of a patch, squared model length.
double diagonals(const RationalBezierPatch& patch) {
  const Grid<Vec4>& points = patch.points;
  const int n = points.rows() - 1, m = points.columns() - 1;
  const Vec3 across = projected(points(n, m)) - projected(points(0, 0));
  const Vec3 back = projected(points(0, m)) - projected(points(n, 0));
  return dot(across, across) + dot(back, back);
}

// Squared model length; neither a turn in space nor degree elevation changes it. Summed by blocks
// of one size, so that the number of threads changes nothing.
double extent(const BezierSurface& surface) {
  const std::span<const RationalBezierPatch> patches = surface.patches.values();
  std::vector<double> sums((patches.size() + kExtentBlock - 1) / kExtentBlock);
  parallel_for(sums.size(), 1, [&](std::size_t k) {
    const std::size_t first = k * kExtentBlock;
    for (const auto& patch : patches.subspan(first, std::min(kExtentBlock, patches.size() - first)))
      sums[k] += diagonals(patch);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

// By control points: an order of surfaces that nothing else tells apart.
bool comes_before(const BezierSurface& a, const BezierSurface& b) {
  const auto points_before = [](const Vec4& p, const Vec4& q) {
    return p.coordinates < q.coordinates;
  };
  const auto patch_before = [&](const RationalBezierPatch& p, const RationalBezierPatch& q) {
    return std::ranges::lexicographical_compare(p.points.values(), q.points.values(),
                                                points_before);
  };
  return std::ranges::lexicographical_compare(a.patches.values(), b.patches.values(), patch_before);
}

// The cells that are searched for contacts are those of the first surface: no border or knot line
// of it cuts them, but those of the other one do. So the surface of more patches goes first, then
// the smaller one, whose borders lie on the other rather. It depends on the surfaces alone, so that
// the order asked for changes nothing.
bool goes_first(const BezierSurface& a, const BezierSurface& b) {
  const std::size_t count_a = a.patches.values().size(), count_b = b.patches.values().size();
  if (count_a != count_b) return count_a > count_b;
  const double extent_a = extent(a), extent_b = extent(b);
  return extent_a != extent_b ? extent_a < extent_b : comes_before(a, b);
}

SurfaceIntersection in_best_order(const BoxedSurface& a, const BoxedSurface& b,
                                  const IntersectionOptions& options) {
  if (&a.surface == &b.surface || !goes_first(b.surface, a.surface))
    return at_best_tolerance(a, b, options);
  IntersectionOptions exchanged_options = options;
  std::swap(exchanged_options.part_a, exchanged_options.part_b);
  return exchanged(at_best_tolerance(b, a, exchanged_options), a.surface, b.surface);
}

SurfaceIntersection near_origin(const BezierSurface& a, const BezierSurface& b, const Vec3& origin,
                                const IntersectionOptions& options) {
  const BezierSurface near_a = seen_from(origin, a);
  const BezierSurface other = &a == &b ? BezierSurface{} : seen_from(origin, b);
  const BezierSurface& near_b = &a == &b ? near_a : other;
  return moved_back(origin,
                    in_best_order({near_a, PatchBoxes(near_a)}, {near_b, PatchBoxes(near_b)},
                                  seen_from(origin, options)));
}

}  // namespace

SurfaceIntersection intersect(const BezierSurface& a, const BezierSurface& b,
                              const IntersectionOptions& options) {
  if (!(options.tolerances.point > 0) || !std::isfinite(options.tolerances.point))
    throw InvalidInput("intersect: the point tolerance must be positive and finite");
  if (options.threads < 0) throw InvalidInput("intersect: the number of threads is negative");
  SurfaceIntersection result;
  with_threads(options.threads, [&] {
    const BoxedSurface boxed_a{a, PatchBoxes(a, "a")}, boxed_b{b, PatchBoxes(b, "b")};
    const Vec3 origin =
        far_origin(joined(boxed_a.boxes.all(), boxed_b.boxes.all()), options.tolerances.point);
    result = origin == Vec3{} ? in_best_order(boxed_a, boxed_b, options)
                              : near_origin(a, b, origin, options);
  });
  return result;
}

}  // namespace blossom
