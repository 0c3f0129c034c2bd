// SPDX-License-Identifier: LGPL-2.1-or-later
// All paths of a ball between two surfaces, with a certificate, and where they are valid.
//
// The centres are the curves in which the offsets of both surfaces meet. The engine finds them all
// on fitted offsets; each is then traced on the exact ones.

#pragma once

#include <optional>
#include <vector>

#include "core/base/status.h"
#include "core/blending/ball_track.h"
#include "core/intersection/options.h"
#include "core/intersection/result.h"

namespace blossom {

/// Where the centre stops and turns back, because r is a radius of curvature of a surface at the
/// contact: the contact on the other surface turns back, too.
struct BallCusp {
  double parameter = 0;
  int support = 0;  ///< 0 or 1: the surface whose curvature it is
};

/// A part of a track along which the ball is on its side of both surfaces, or is not.
struct BallStretch {
  Interval range;
  bool valid = true;
};

/// The least determinant of I - s r W along a track; 0 is a pinch.
struct BallPinch {
  double parameter = 0;
  int support = 0;
  double determinant = 1;
};

struct BallSpine {
  BallTrack track;
  std::vector<BallCusp> cusps;         ///< increasing
  std::vector<BallStretch> stretches;  ///< in order, over the whole domain, cut at the cusps
  BallPinch tightest;

  bool is_valid() const { return stretches.size() == 1 && stretches.front().valid; }
};

/// The cusps and stretches of a track.
///
/// Determinants are interpolated between the track's breaks, and halved, until twice the difference
/// at points between the nodes tells by Bernstein coefficients which sign they have, or that they
/// have one zero; so two cusps as near as the interpolant resolves are both found, however far
/// apart samples are. Where a least value is below that difference, it is itself looked for on the
/// exact determinant.
BallSpine with_stretches(BallTrack track);

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
