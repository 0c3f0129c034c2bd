// SPDX-License-Identifier: LGPL-2.1-or-later
// All foot points of a point on curves and surfaces: where its distance is stationary.
//
//   (S - p) . S_u = (S - p) . S_v = 0
//
// Both are Bernstein forms of the patch's parameters. A piece of a patch is left out when one of
// them has one sign on its net, settled when their Jacobian proves that there is at most one foot
// (`core/rays/two_forms.h`), and halved otherwise.

#pragma once

#include <vector>

#include "core/base/work_limit.h"
#include "core/distance.h"

namespace blossom {

/// What the distance does at a foot point, by its second derivatives.
enum class Extremum { Minimum, Maximum, Saddle, Unknown };

/// "minimum", "maximum", "saddle" or "unknown".
const char* to_string(Extremum extremum);

struct FootPoint {
  DistanceEnd at;       ///< on a curve or a surface; not a point
  double distance = 0;  ///< model units
  Extremum extremum = Extremum::Unknown;

  /// Complete: proven, and the only one near. Tolerance: within tolerance of this there may be
  /// several feet or none, or all of a region is stationary, as for the centre of a sphere.
  /// Stopped: the budget or the time was spent before it was known whether there is a foot in a
  /// region, all of a surface perhaps, or the degree is too high for the forms.
  Status status = Status::Complete;
  double size = 0;  ///< of the region, model units; 0 if Complete
};

/// All feet of `point`, by increasing distance.
///
/// set          its points are not looked at; feet outside of its trims are left out
/// tolerance    size of the regions in which what is not decided counts as one foot, model units
/// limit        of the whole question; null: none. A surface it ends midway has one foot, Stopped
/// throws       InvalidInput if a form is not sound, or the tolerance is not positive
std::vector<FootPoint> foot_points(const DistanceOperand& set, const Vec3& point, double tolerance,
                                   const WorkLimit* limit = nullptr);

}  // namespace blossom
