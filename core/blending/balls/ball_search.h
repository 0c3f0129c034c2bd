// SPDX-License-Identifier: LGPL-2.1-or-later
// All paths of a ball between two surfaces, with a certificate.
//
// The centres are the curves in which the offsets of both surfaces meet. The engine finds them all
// on fitted offsets; each is then traced on the exact ones.

#pragma once

#include <array>
#include <vector>

#include "core/base/status.h"
#include "core/blending/balls/ball_spine.h"
#include "core/blending/balls/ball_track.h"
#include "core/results/options.h"
#include "core/results/result.h"

namespace blossom {

struct BallSpineOptions {
  double fit_tolerance = 1e-9;  ///< of the fitted offsets, model units
  IntersectionOptions intersection{};
};

struct BallSpines {
  Status status = Status::Complete;  ///< of the search on the fitted offsets
  std::vector<BallSpine> spines;
  std::array<double, 2> offset_errors{};        ///< of the fits, model units
  std::array<double, 2> offset_slope_errors{};  ///< likewise
  Certificate certificate;
  std::vector<Place> places;  ///< where the offsets touch or stayed undecided

  /// Curves of the fitted offsets that could not be traced on the exact ones; not empty only if
  /// the status is weaker than Complete.
  std::vector<SurfacePoint> lost;
};

/// All paths of a ball of constant radius between two surfaces.
///
/// throws    InvalidInput as `track_through` and `offset_surface`
BallSpines ball_spines(const BallSupport& a, const BallSupport& b, double radius,
                       const BallSpineOptions& options = {});

/// The spine whose contacts come nearest to a point, an edge's middle, say; -1 if there is none.
int nearest_spine(const BallSpines& spines, const Vec3& point);

}  // namespace blossom
