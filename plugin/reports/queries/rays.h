// SPDX-License-Identifier: LGPL-2.1-or-later
// The JSON report of a ray; see plugin/cli/schemas/query-1.md.

#pragma once

#include <vector>

#include "adapters/occt/ray_casting.h"
#include "core/base/tolerances.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

struct RayAnswer {
  Ray ray{};                ///< its direction is a unit vector
  bool line = false;        ///< both ways
  bool first_only = false;  ///< no further than the first proven hit
  double tolerance = Tolerances{}.point;
  std::vector<occt::ShapeHit> hits{};
  Status status = Status::Complete;
  double seconds = 0;
};

/// Schema "blossom.query/1", kind "ray".
Json ray_report(const Input& input, const RayAnswer& answer);

}  // namespace blossom::reports
