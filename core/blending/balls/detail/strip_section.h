// SPDX-License-Identifier: LGPL-2.1-or-later
// The section of a strip at one ball, as homogeneous Bezier points across it.

#pragma once

#include <array>

#include "core/blending/balls/ball_strip.h"
#include "core/blending/balls/ball_track.h"

namespace blossom {

/// Along which the envelope touches a ball.
struct CharacteristicCircle {
  Vec3 centre;
  double radius = 0;
  std::array<Vec3, 2> to_contact;  ///< unit vectors from the centre
};

/// throws   InvalidInput if the balls have no envelope there
CharacteristicCircle characteristic_circle(const BallPoint& ball);

inline constexpr int kMaxRows = 8;

/// How sections are written.
struct SectionForm {
  SectionKind kind = SectionKind::Circle;
  double rho = 0.5;
  bool wide = false;  ///< an arc of degree 4, for large angles

  int rows() const;
  int degree() const;              ///< in v
  bool has_weight(int row) const;  ///< other than 1
};

/// Control points from contact 1 to contact 2.
/// throws   InvalidInput as `characteristic_circle`
std::array<Vec4, kMaxRows> section_rows(const BallTrack& track, const BallPoint& ball,
                                        const SectionForm& form);

/// The point at v in [0, 1] of rows like these.
Vec3 section_point(const std::array<Vec4, kMaxRows>& rows, const SectionForm& form, double v);

}  // namespace blossom
