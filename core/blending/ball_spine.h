// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the path of a ball between two surfaces is valid.
//
// A ball whose radius is a radius of curvature of a surface at the contact stops there: its centre
// and the other contact turn back. On one side of such a cusp it lies in the surface. All paths
// between two surfaces: `core/rolling_ball.h`.

#pragma once

#include <vector>

#include "core/blending/ball_track.h"

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

}  // namespace blossom
