// SPDX-License-Identifier: LGPL-2.1-or-later
// What `check --continuity` found, counted and in words.

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/occt/blending/continuity.h"
#include "plugin/cli/commands/check_continuity.h"

namespace blossom::cli {

/// What an edge between faces is called: apart, sharp (G0), G1, G2.
inline constexpr std::array kClassWords{"apart", "G0", "G1", "G2"};

/// Of an edge that was measured.
const char* class_word(const occt::EdgeContinuity& edge);

struct ContinuityReport {
  const ContinuityCommand& command;
  std::vector<occt::EdgeContinuity> edges;

  std::size_t count(std::string_view word) const;
  std::size_t count(occt::EdgeRole kind) const;
  std::size_t proven() const;

  /// Edges that should have been measured and could not be.
  std::vector<const occt::EdgeContinuity*> unmeasured() const;

  /// Numbers of edges between faces that are less smooth than required, or not known to be; G0 is
  /// required where nothing is said.
  std::vector<int> failing() const;
};

/// The summary, and the table if it is asked for.
/// has_picture   then colours are explained
std::string continuity_text(const std::string& name, const ContinuityReport& report,
                            bool has_picture);

}  // namespace blossom::cli
