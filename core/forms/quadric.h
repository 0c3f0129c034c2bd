// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrics: the zero sets of polynomials of degree two, found from patches that lie on them.
//
// Cylinders, cones and spheres of CAD are patches of degree two at most. Put into their
// equation another patch becomes one function of two variables.

#pragma once

#include <array>
#include <optional>

#include "core/forms/patch.h"

namespace blossom {

/// q(X) = X^T Q X at the homogeneous point X = (wx, wy, wz, w); q(X) / w^2 is the polynomial's
/// value at the point in space.
struct Quadric {
  std::array<std::array<double, 4>, 4> matrix{};  ///< Q, symmetric

  double value(const Vec4& x) const;

  /// Of the value in space, there.
  Vec3 gradient(const Vec3& x) const;
};

/// False of degrees for which `quadric_of` finds nothing.
bool may_lie_on_quadric(const RationalBezierPatch& patch);

/// The quadric on which a patch lies, with a gradient of length about 1 in the patch's middle, so
/// that values are about distances.
///
/// returns   nothing for degrees above 2, for planes and for patches that hardly bend, which lie on
///           many quadrics or nearly so; nothing in doubt. The patch lies on the quadric to about
///           rounding; where that matters bound the value over the patch.
/// cost      O(10^2) points of the patch's square, once a patch
std::optional<Quadric> quadric_of(const RationalBezierPatch& patch);

}  // namespace blossom
