// SPDX-License-Identifier: LGPL-2.1-or-later
// Why a fillet cannot be made: data for reports, and a sentence.

#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/math/vec.h"

namespace blossom::occt {

enum class FilletFault {
  Edge,          ///< it cannot have a fillet: open, crowded, smooth, a seam, a point, of mixed kind
  NoBall,        ///< no ball of that radius touches both faces beside the edge
  Pinch,         ///< the ball has a radius of curvature of a face
  LeavesFace,    ///< a contact goes over a border of its face
  EdgeConsumed,  ///< more of an edge would go than there is
  End,           ///< how the strip ends is not known how to build
  Corner,        ///< likewise of filleted edges that meet
  Interference,  ///< the strip runs into another face
  Result         ///< what came out is no valid solid
};

/// "edge", "no ball", ... as in the JSON report.
const char* to_string(FilletFault fault);

struct FilletRefusal {
  FilletFault fault = FilletFault::Result;
  int edge = 0;  ///< number; 0: none in particular
  std::string cause;
  std::optional<double> parameter{};  ///< of the edge
  std::optional<Vec3> point{};        ///< model units
  std::optional<double> largest{};    ///< the largest radius that works there, model units

  /// "edge 12: ... at (x, y, z)".
  std::string text() const;
};

/// Carries a refusal out of the work.
class FilletRefused : public std::runtime_error {
 public:
  explicit FilletRefused(FilletRefusal why)
      : std::runtime_error(why.text()), why_(std::move(why)) {}
  const FilletRefusal& why() const { return why_; }

 private:
  FilletRefusal why_;
};

}  // namespace blossom::occt
