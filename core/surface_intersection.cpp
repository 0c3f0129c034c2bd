// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surface_intersection.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/errors.h"
#include "core/base/parallel.h"
#include "core/exchanged_order.h"
#include "core/surface_assembly.h"

namespace blossom {
namespace {

// In the order asked for, and, if that leaves something open, in the other one with the rest of the
// time, and of the budget what the pairs decided have left of it.
SurfaceIntersection in_better_order(const BezierSurface& a, const BezierSurface& b,
                                    const IntersectionOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  SurfaceIntersection found = assembled(a, b, options);
  if (&a == &b || !may_gain_by_exchange(found)) return found;
  IntersectionOptions other = options;
  std::swap(other.part_a, other.part_b);
  const Certificate& first = found.certificate;
  other.budget -= first.excluded + first.certified + first.critical;
  if (other.budget <= 0) return found;
  if (options.time_limit > 0) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started;
    other.time_limit -= spent.count();
    if (!(other.time_limit > 0)) return found;
  }
  SurfaceIntersection back = assembled(b, a, other);
  return is_gain(found, back) ? exchanged(std::move(back), a) : found;
}

}  // namespace

SurfaceIntersection intersect(const BezierSurface& a, const BezierSurface& b,
                              const IntersectionOptions& options) {
  validate(a, "a");
  validate(b, "b");
  if (!(options.tolerances.point > 0) || !std::isfinite(options.tolerances.point))
    throw InvalidInput("intersect: the point tolerance must be positive and finite");
  if (options.threads < 0) throw InvalidInput("intersect: the number of threads is negative");
  SurfaceIntersection result;
  with_threads(options.threads, [&] { result = in_better_order(a, b, options); });
  return result;
}

}  // namespace blossom
