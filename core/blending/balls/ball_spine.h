// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the path of a ball between two surfaces is valid.
//
// A ball whose radius is a radius of curvature of a surface at the contact stops there: its centre
// and the other contact turn back. On one side of such a cusp it lies in the surface.

#pragma once

#include <vector>

#include "core/blending/balls/ball_track.h"

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

/// Where the smaller factor 1 - s r k, k a principal curvature, is least along a track; at 0 the
/// ball pinches.
struct BallPinch {
  double parameter = 0;
  int support = 0;
  double factor = 1;
};

struct BallSpine {
  BallTrack track;
  std::vector<BallCusp> cusps;         ///< increasing
  std::vector<BallStretch> stretches;  ///< in order, over the whole domain, cut at the cusps

  bool is_valid() const { return stretches.size() == 1 && stretches.front().valid; }
};

/// The cusps and stretches of a track.
///
/// The determinants of I - s r W are interpolated between the track's nodes. Bernstein coefficients
/// tell where they have a sign, twice the difference found between the nodes of the interpolation
/// included; where they are monotone or bend to one side only, the extremum and the zeros are
/// looked for on the exact determinant; elsewhere the piece is halved. So two cusps are both found,
/// however far apart the samples of the track are. A determinant below 1e-12 counts as 0.
BallSpine with_stretches(BallTrack track);

/// Where the ball is nearest to pinching, to 1e-9 of the way between two nodes.
BallPinch tightest_of(const BallTrack& track);

}  // namespace blossom
