// SPDX-License-Identifier: LGPL-2.1-or-later
// The JSON report of a check; see plugin/cli/schemas/check-1.md.

#pragma once

#include <algorithm>
#include <cstddef>

#include "adapters/occt/soundness.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// Figures of a face, or of all that was looked at.
struct LargestGaps {
  double tolerance = 0;
  double gap = 0;
  double same_parameter = 0;
  double vertex_gap = 0;
  int free = 0;
  int crowded = 0;

  void add(const occt::EdgeSoundness& edge) {
    tolerance = std::max(tolerance, edge.tolerance);
    gap = std::max(gap, edge.gap);
    same_parameter = std::max(same_parameter, edge.same_parameter);
    vertex_gap = std::max(vertex_gap, edge.vertex_gap);
    free += edge.free ? 1 : 0;
    crowded += edge.crowded ? 1 : 0;
  }
};

/// Of all edges, and of those of a face.
LargestGaps largest_of(const occt::Soundness& found);
LargestGaps largest_of(const occt::Soundness& found, const occt::FaceSoundness& face);

std::size_t problem_count(const occt::Soundness& found);

/// "sound" or "not sound".
const char* verdict_of(const occt::Soundness& found);

/// The whole object, schema "blossom.check/1".
Json soundness_report(const Input& input, const occt::Soundness& found);

}  // namespace blossom::reports
