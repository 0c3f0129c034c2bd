// SPDX-License-Identifier: LGPL-2.1-or-later
// What the strips of a run of edges are like: radii, sections, distances.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "adapters/occt/fillet.h"

namespace blossom::occt {

/// Whether two edges have one radius, or one law.
bool is_same(const EdgeRadius& a, const EdgeRadius& b);

class RunProfiles {
 public:
  /// throws   FilletRefused if edges have different radii, or those of a closed run do not come
  /// back
  RunProfiles(const BodyEdges& body, const EdgeRun& run, const FilletOptions& options);

  /// The strip of an edge of the run.
  /// throws   FilletRefused
  RolledStrip strip(const BodyEdges& body, std::size_t place) const;

  /// The strip of a chamfer, or of radii by a law, beside an edge of the run, on other faces than
  /// its own.
  /// throws   FilletRefused
  RolledStrip guided(const BodyEdges& body, std::size_t place, const GuidedPlace& at) const;

  /// The profile of strips beside all edges, if it is one.
  std::optional<StripProfile> everywhere() const;

 private:
  ChamferProfile chamfer_at(std::size_t place) const;

  const EdgeRun& run_;
  const FilletOptions& options_;
  std::vector<StripProfile> of_;  // by place
  ChamferProfile chamfer_;        // to the left and right of the run
};

}  // namespace blossom::occt
