// SPDX-License-Identifier: LGPL-2.1-or-later
// Many rays at once, by all threads.

#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "core/base/parallel.h"
#include "core/rays/ray.h"

namespace blossom {

/// Rays that a thread takes at a time, by one query that keeps its memory from one to the next. A
/// choice: some hundred microseconds of work.
inline constexpr std::size_t kRaysInBatch = 256;

/// What `ask(query, ray)` finds for each ray; a query is made of what is asked for each batch.
template <class Query, class Asked, class Ask>
auto for_all_rays(const Asked& asked, std::span<const Ray> rays, const Ask& ask) {
  using Hit = std::remove_const_t<
      typename std::invoke_result_t<const Ask&, Query&, const Ray&>::element_type>;
  std::vector<std::vector<Hit>> results(rays.size());
  parallel_for((rays.size() + kRaysInBatch - 1) / kRaysInBatch, 1, [&](std::size_t batch) {
    Query query(asked);
    const std::size_t end = std::min(rays.size(), (batch + 1) * kRaysInBatch);
    for (std::size_t i = batch * kRaysInBatch; i < end; ++i) {
      const std::span<const Hit> hits = ask(query, rays[i]);
      results[i].assign(hits.begin(), hits.end());
    }
  });
  return results;
}

}  // namespace blossom
