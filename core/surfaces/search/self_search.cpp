// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/search/self_search.h"

#include <algorithm>
#include <chrono>

#include "core/surfaces/branches/arc_chains.h"
#include "core/surfaces/search/self_pairs.h"

namespace blossom {
namespace {

constexpr double kMinSeconds = 1e-3;  // of a search that begins when the time is over

}  // namespace

PairSearchResult search_itself(SurfaceCells& cells, const Vec3& origin, double size,
                               const KnownCurves& known, const IntersectionOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  const SelfPairs pairs = self_pairs(cells, glued_borders(cells.surface()), origin, options);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started;
  IntersectionOptions left = options;
  if (options.time_limit > 0)
    left.time_limit = std::max(kMinSeconds, options.time_limit - spent.count());
  PairSearchResult found = search_pairs(cells, cells, pairs.apart, size, known, left);
  found.critical.insert(found.critical.end(), pairs.singular.begin(), pairs.singular.end());
  found.stopped = found.stopped || pairs.stopped;
  found.cancelled = found.cancelled || pairs.cancelled;
  Certificate& certificate = found.certificate;
  certificate.limited = certificate.limited || pairs.stopped;
  certificate.excluded += pairs.excluded;
  if (pairs.moved_into_plane) identify(certificate, *pairs.moved_into_plane);
  certificate.critical += static_cast<long>(pairs.singular.size());
  certificate.depth = std::max(certificate.depth, pairs.depth);
  for (const std::string& reason : pairs.reasons)
    if (std::find(certificate.reasons.begin(), certificate.reasons.end(), reason) ==
        certificate.reasons.end())
      certificate.reasons.push_back(reason);
  agree_on_sides(found, cells);
  return found;
}

}  // namespace blossom
