// SPDX-License-Identifier: LGPL-2.1-or-later
// How smoothly faces meet along edges, counted and as JSON; see plugin/cli/schemas/continuity-1.md.

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/occt/blending/continuity.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// What an edge between faces is called: apart, sharp (G0), G1, G2.
inline constexpr std::array kClassWords{"apart", "G0", "G1", "G2"};

/// Of an edge that was measured.
const char* class_word(const occt::EdgeContinuity& edge);

struct ContinuityAnswer {
  ContinuityTolerances tolerances{};
  std::string require{};  ///< "G0", "G1", "G2", or empty
  std::vector<occt::EdgeContinuity> edges{};

  std::size_t count(std::string_view word) const;
  std::size_t count(occt::EdgeRole kind) const;
  std::size_t proven() const;

  /// Edges that should have been measured and could not be.
  std::vector<const occt::EdgeContinuity*> unmeasured() const;

  /// Numbers of edges between faces that are less smooth than required, or not known to be; G0 is
  /// required where nothing is said.
  std::vector<int> failing() const;
};

/// The edges of the chosen faces.
/// tick   called often; may throw to stop
ContinuityAnswer measured_continuity_of(const Input& input, const ContinuityTolerances& tolerances,
                                        const std::string& require,
                                        const std::function<void()>& tick);

/// The whole object, schema "blossom.continuity/1".
Json continuity_report(const Input& input, const ContinuityAnswer& answer);

}  // namespace blossom::reports
